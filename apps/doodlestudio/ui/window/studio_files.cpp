// Opening, saving and exporting in DoodleStudio's window.
#include "document/bundled_sample.h"
#include "document/document_files.h"
#include "document/project_picture.h"
#include "doodlestudio/ui/film/export_dialog.h"
#include "doodlestudio/ui/player/player_view.h"
#include "doodlestudio/ui/window/studio_window.h"
#include "widgets/pages/sample_words.h"
#include "widgets/pages/start_page.h"
#include "widgets/shell/message_bar.h"

#include <QDir>
#include <QEventLoop>
#include <QFileDialog>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>

namespace ductus {

namespace {

QJsonArray sampleList()
{
    QFile file(QStringLiteral(":/clips/clips.json"));
    return file.open(QIODevice::ReadOnly)
               ? QJsonDocument::fromJson(file.readAll()).object()["samples"].toArray()
               : QJsonArray();
}

} // namespace

void StudioWindow::fillStartPage()
{
    StartPage *page = startPage();
    page->setHeading(tr("DoodleStudio"), tr("Draw into a filmed scene, so that it stays where you put it."));
    page->setButtons({}, tr("Open..."));
    page->setDropSentence(tr("Drop a clip, a folder of pictures or a project anywhere."));
    QList<SampleCard> cards;
    for (const QJsonValue &sample : sampleList()) {
        const QString id = sample["id"].toString();
        cards << SampleCard{sample["title"].toString(), sample["lesson"].toString(),
                            QStringLiteral(":/clips/%1.png").arg(id), id};
    }
    page->setSamples(cards);
    connect(page, &StartPage::openRequested, this, &StudioWindow::chooseAndOpen);
    connect(page, &StartPage::openFile, this, &StudioWindow::openPath);
    connect(page, &StartPage::openSample, this, &StudioWindow::openSample);
    connect(page, &StartPage::forgetFile, &mRecent, &RecentFiles::remove);
    connect(&mRecent, &RecentFiles::changed, this, &StudioWindow::refreshRecent);
    refreshRecent();
}

void StudioWindow::refreshRecent()
{
    QList<RecentCard> cards;
    for (const RecentFile &file : mRecent.files())
        cards << RecentCard{file.path, QPixmap::fromImage(file.picture), file.isMissing};
    startPage()->setRecent(cards);
}

void StudioWindow::chooseAndOpen()
{
    const QString path = QFileDialog::getOpenFileName(
        this, tr("Open"), QFileInfo(mRecent.paths().value(0)).path(),
        tr("Clips and projects (*.ductus %1);;All files (*)").arg(clipPatterns()));
    if (!path.isEmpty())
        openPath(path);
}

void StudioWindow::openPath(const QString &path)
{
    if (const QString id = bundledSampleId(path, QStringLiteral("clips.json")); !id.isEmpty()) {
        openSample(id);
        return;
    }
    if (!confirmLeaving())
        return;
    if (path.endsWith(QLatin1String(".ductus"), Qt::CaseInsensitive))
        openProject(path);
    else
        openClipAt(path);
}

void StudioWindow::openSample(const QString &id)
{
    if (!confirmLeaving())
        return;
    // Decoders read files: the clip is put where files may be.
    const QString folder =
        QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + QStringLiteral("/samples");
    const QString clip = QStringLiteral("%1/%2.mp4").arg(folder, id);
    const QString packed = QStringLiteral(":/clips/%1.mp4").arg(id);
    if (QFileInfo(clip).size() != QFileInfo(packed).size()) {
        QDir().mkpath(folder);
        QFile::remove(clip);
        if (!QFile::copy(packed, clip)) {
            showError({ErrorCode::WriteFailed, "Opening the sample", "its clip cannot be put into the cache",
                       "Make room on the disk", clip.toStdString()});
            return;
        }
        QFile::setPermissions(clip, QFile::ReadOwner | QFile::WriteOwner);
    }
    QFile file(QStringLiteral(":/clips/%1.ductus").arg(id));
    if (!file.open(QIODevice::ReadOnly))
        return;
    const QByteArray bytes = file.readAll();
    const std::string_view view(bytes.constData(), std::size_t(bytes.size()));
    Result<Project> project = parseProject(asBytes(view), id.toStdString() + ".ductus", knownDocuments());
    if (!project) {
        showError(project.error());
        return;
    }
    QString title = id;
    for (const QJsonValue &sample : sampleList())
        if (sample["id"].toString() == id)
            title = sampleWords(sample["title"].toString());
    if (Result<void> started = mDoodle.startSample(std::move(*project), clip, title); !started) {
        showError(started.error());
        return;
    }
    messages()->closeAll();
    findClip();
}

void StudioWindow::openProject(const QString &path)
{
    openDocument(mDoodle, jobs(), path, [this, path](Result<OpenNotes> notes) {
        if (!notes && notes.error().code == ErrorCode::TooLittleData) {
            takePainting(path); // no filmed scene, so perhaps a painting for one
            return;
        }
        if (!notes) {
            showError(notes.error());
            return;
        }
        messages()->closeAll();
        mRecent.add(path, projectThumbnail(mDoodle.project()));
        for (const QString &warning : notes->warnings)
            messages()->warning(warning);
        findClip();
        lookForNewerPaintings(false);
    });
}

ExportDialog *StudioWindow::openExport()
{
    if (mDoodle.isEmpty()) {
        messages()->info(tr("Open a clip first; its film can be exported then."));
        return nullptr;
    }
    auto *dialog = findChild<ExportDialog *>();
    if (!dialog) {
        dialog = new ExportDialog(mDoodle, jobs(), this);
        connect(dialog, &ExportDialog::exported, this, [this, dialog](const QString &path) {
            if (!dialog->isVisible())
                messages()->success(tr("Exported to %1.").arg(QFileInfo(path).fileName()));
        });
    }
    dialog->show();
    dialog->raise();
    return dialog;
}

void StudioWindow::showOpened()
{
    showCanvas();
    mPlayer->setFocus();
    showSceneWords();
}

void StudioWindow::save()
{
    if (mDoodle.filePath().isEmpty() || mDoodle.isReadOnly())
        saveAs();
    else
        saveTo(mDoodle.filePath());
}

void StudioWindow::saveAs()
{
    if (mDoodle.isEmpty())
        return;
    if (const QString path = askForPath(); !path.isEmpty())
        saveTo(path);
}

QString StudioWindow::askForPath()
{
    const QString beside =
        QFileInfo(mDoodle.clipPath()).absolutePath() + QLatin1Char('/') + mDoodle.displayName();
    QString path = QFileDialog::getSaveFileName(this, tr("Save as"), beside + QStringLiteral(".ductus"),
                                                tr("Ductus projects (*.ductus)"));
    if (!path.isEmpty() && !path.endsWith(QLatin1String(".ductus"), Qt::CaseInsensitive))
        path += QStringLiteral(".ductus");
    return path;
}

bool StudioWindow::saveForClosing()
{
    const bool hasPlace = !mDoodle.filePath().isEmpty() && !mDoodle.isReadOnly();
    const QString path = hasPlace ? mDoodle.filePath() : askForPath();
    if (path.isEmpty())
        return false;
    bool isSaved = false;
    QEventLoop loop;
    saveTo(path, [&](bool saved) {
        isSaved = saved;
        loop.quit();
    });
    loop.exec(QEventLoop::ExcludeUserInputEvents);
    return isSaved;
}

void StudioWindow::saveTo(const QString &path, std::function<void(bool)> finish)
{
    const QImage shown = mPlayer->grabPicture();
    mDoodle.setPicture(shown);
    mDoodle.setSnapshotFolder(QFileInfo(path).absolutePath());
    saveDocument(mDoodle, jobs(), path, [this, path, shown, finish](Result<SaveReport> report) {
        if (report)
            mRecent.add(path, shown);
        else
            showError(report.error(), tr("Save as..."), [this] { saveAs(); });
        if (finish)
            finish(report.ok());
    });
}

} // namespace ductus
