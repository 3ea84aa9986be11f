// edit_loop KIND PROJECT STATEDIR SEED AUTOSAVE_MS: an app without a window. It opens what is there as an app
// does after a crash, recovered work first, then edits, saves and autosaves until it is killed. What it has
// done it tells on stdout, a line each, when it is done: "edited N", "saved N", "autosaved N".
#include "base/random.h"
#include "document/document_files.h"
#include "document/recovery/autosave.h"
#include "document/recovery/recovery_list.h"
#include "recovery/edited_document.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QStringList>
#include <QTimer>

#include <cstdio>
#include <cstdlib>
#include <unistd.h>

using namespace ductus;

namespace {

// In one piece and at once: what was told before the kill is in the pipe.
void tell(const char *what, int count)
{
    char line[64];
    const int length = std::snprintf(line, sizeof line, "%s %d\n", what, count);
    if (::write(STDOUT_FILENO, line, std::size_t(length)) != length)
        std::_Exit(3);
}

[[noreturn]] void giveUp(const std::string &why)
{
    std::fprintf(stderr, "edit_loop: %s\n", why.c_str());
    std::_Exit(1);
}

class EditLoop : public QObject
{
public:
    EditLoop(const QString &kind, const QString &path, const QString &state, quint64 seed, int autosaveMs)
        : mKind(kind), mPath(path), mState(state), mRandom(seed), mEdited(editedDocument(kind))
    {
        const QStringList done = open();
        mAutosave = std::make_unique<Autosave>(mEdited->document(), mRunner, state);
        // A thousandth of the times apps have; see AutosaveTimes.
        mAutosave->setTimes({autosaveMs, autosaveMs / 40 + 1, autosaveMs / 2, autosaveMs / 8 + 1});
        connect(mAutosave.get(), &Autosave::aboutToWrite, this, [this] { mCopied = mEdited->editCount(); });
        connect(mAutosave.get(), &Autosave::saved, this, [this] { tell("autosaved", mCopied); });
        connect(mAutosave.get(), &Autosave::failed, this,
                [](const Error &error) { giveUp(error.message()); });
        tell("edited", mEdited->editCount());
        save([this, done] { // what was recovered is safe now, so its copies may go
            for (const RecoveredFile &file : recoveredFiles(mState))
                if (done.contains(file.copy))
                    (void)discardRecovered(file);
            planSave();
        });
        QTimer::singleShot(0, this, &EditLoop::edit);
    }

private:
    // As after a crash: the newest copy where it is further than the file. The copies that were looked at.
    QStringList open()
    {
        const QList<RecoveredFile> copies = recoveredFiles(mState);
        QStringList seen;
        for (const RecoveredFile &copy : copies)
            seen << copy.copy;
        const int saved = QFileInfo::exists(mPath) ? sure(editsIn(mKind, mPath)) : -1;
        if (!copies.isEmpty() && sure(editsIn(mKind, copies[0].copy)) > saved)
            sure(
                adoptRecovered(mEdited->document(), sure(openProjectFile(copies[0].copy, mKind)), copies[0]));
        else if (saved >= 0)
            sure(adoptProject(mEdited->document(), sure(openProjectFile(mPath, mKind))));
        else
            mEdited->start();
        if (mEdited->document().isReadOnly())
            giveUp(mEdited->document().readOnlyReason().toStdString());
        return seen;
    }

    template <typename T>
    static T sure(Result<T> result)
    {
        if (!result)
            giveUp(result.error().message());
        return std::move(result).value();
    }

    void edit()
    {
        if (!mEdited->edit())
            giveUp("an edit was refused");
        tell("edited", mEdited->editCount());
        QTimer::singleShot(int(mRandom.index(9)), this, &EditLoop::edit); // ms: faster than any hand
    }

    void planSave()
    {
        QTimer::singleShot(int(mRandom.uniform(40, 500)), this, [this] { save([this] { planSave(); }); });
    }

    void save(std::function<void()> then)
    {
        const int count = mEdited->editCount();
        saveDocument(mEdited->document(), mRunner, mPath, [count, then](Result<SaveReport> report) {
            if (!report)
                giveUp(report.error().message());
            tell("saved", count);
            then();
        });
    }

    QString mKind, mPath, mState;
    Random mRandom;
    JobRunner mRunner;
    std::unique_ptr<EditedDocument> mEdited;
    std::unique_ptr<Autosave> mAutosave;
    int mCopied = 0;
};

} // namespace

int main(int argc, char **argv)
{
    QCoreApplication app(argc, argv);
    const QStringList words = app.arguments();
    if (words.size() != 6 || !editedKinds().contains(words[1])) {
        std::fputs("Usage: edit_loop KIND PROJECT STATEDIR SEED AUTOSAVE_MS\n", stderr);
        return 2;
    }
    QCoreApplication::setApplicationName(words[1]);
    const EditLoop loop(words[1], words[2], words[3], words[4].toULongLong(), words[5].toInt());
    return app.exec();
}
