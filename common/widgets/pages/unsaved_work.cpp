#include "widgets/pages/unsaved_work.h"

#include "widgets/main_window_shell.h"
#include "widgets/pages/recovery_notice.h"
#include "widgets/pages/start_page.h"
#include "widgets/shell/message_bar.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QPointer>
#include <algorithm>
#include <utility>

namespace ductus {

namespace {

const QString autosaveKey = QStringLiteral("autosave"); // of the message

} // namespace

UnsavedWork::UnsavedWork(MainWindowShell &window, Document &document, const QString &folder)
    : mWindow(window), mDocument(document), mFolder(folder), mAutosave(document, window.jobs(), folder)
{
    // A held button is a stroke, a drag or a turn of the view.
    mAutosave.setBusyCheck([] { return QGuiApplication::mouseButtons() != Qt::NoButton; });
    connect(&mWindow, &MainWindowShell::closing, this, [this] {
        mAutosave.discard();
        removeReplaced();
    });
    connect(&mDocument, &Document::modifiedChanged, this, [this](bool modified) {
        if (!modified)
            removeReplaced();
    });
    connect(&mAutosave, &Autosave::saved, this, [this] {
        mWindow.messages()->withdraw(autosaveKey);
        removeReplaced();
    });
    connect(&mAutosave, &Autosave::failed, this, [this](const Error &error) {
        Message message = messageFrom(error);
        message.kind = MessageKind::Warning;
        message.key = autosaveKey;
        mWindow.messages()->show(message);
    });
}

void UnsavedWork::look()
{
    JobSpec spec{QStringLiteral("recovery"), tr("Looking for unsaved work")};
    spec.isQuiet = true;
    mWindow.jobs().start<QList<RecoveredFile>>(
        spec,
        [folder = mFolder](const JobControl &) -> Result<QList<RecoveredFile>> {
            return recoveredFiles(folder);
        },
        [self = QPointer(this)](Result<QList<RecoveredFile>> files) {
            if (self && files)
                self->showFound(*files);
        });
}

void UnsavedWork::showFound(QList<RecoveredFile> files)
{
    files.removeIf([this](const RecoveredFile &file) {
        return std::any_of(mReplaced.begin(), mReplaced.end(),
                           [&](const RecoveredFile &replaced) { return replaced.copy == file.copy; });
    });
    if (files.isEmpty()) {
        mWindow.startPage()->setNotice(nullptr);
        return;
    }
    auto *notice = new RecoveryNotice(files);
    connect(notice, &RecoveryNotice::openRequested, this, &UnsavedWork::open);
    connect(notice, &RecoveryNotice::discardRequested, this, &UnsavedWork::remove);
    mWindow.startPage()->setNotice(notice);
}

void UnsavedWork::open(const RecoveredFile &file)
{
    if (!mWindow.confirmLeaving())
        return;
    auto work = [file](const JobControl &) {
        return openProjectFile(file.copy, QCoreApplication::applicationName());
    };
    mWindow.jobs().start<OpenedProject>({QStringLiteral("open"), tr("Opening %1").arg(file.displayName)},
                                        work, [self = QPointer(this), file](Result<OpenedProject> opened) {
                                            if (!self)
                                                return;
                                            if (opened)
                                                self->adopt(std::move(*opened), file);
                                            else
                                                self->mWindow.showError(opened.error());
                                        });
}

void UnsavedWork::adopt(OpenedProject opened, const RecoveredFile &file)
{
    const Result<OpenNotes> notes = adoptRecovered(mDocument, std::move(opened), file);
    if (!notes) {
        mWindow.showError(notes.error());
        return;
    }
    mWindow.messages()->closeAll();
    emit this->opened();
    for (const QString &warning : notes->warnings)
        mWindow.messages()->warning(warning);
    // The old copy goes once the work is in a new one, so that at no moment there is none.
    mReplaced << file;
    mAutosave.saveNow();
    look();
}

void UnsavedWork::removeReplaced()
{
    for (const RecoveredFile &file : std::exchange(mReplaced, {}))
        remove(file);
}

void UnsavedWork::remove(const RecoveredFile &file)
{
    if (const Result<void> removed = discardRecovered(file); !removed)
        mWindow.showError(removed.error());
    look();
}

} // namespace ductus
