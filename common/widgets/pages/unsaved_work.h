// UnsavedWork: keeps a copy of what the window's document has not saved, and offers on the start page what a
// crash left. An app makes one beside its document; nothing else of autosave has to be wired.
#pragma once

#include "document/recovery/autosave.h"
#include "document/recovery/recovery_list.h"

#include <QObject>

namespace ductus {

class MainWindowShell;

class UnsavedWork : public QObject
{
    Q_OBJECT
public:
    /// Copies stand in \a folder, see stateFolder(). Both must outlive this; closing the window for good
    /// discards the copy.
    UnsavedWork(MainWindowShell &window, Document &document, const QString &folder);

    Autosave &autosave() { return mAutosave; }

    /// Looks on a worker for what a crash left and shows it on the start page.
    void look();

signals:
    /// What a crash left is in the document now, unsaved.
    void opened();

private:
    void showFound(QList<RecoveredFile> files);
    void open(const RecoveredFile &file);
    void adopt(OpenedProject opened, const RecoveredFile &file);
    void removeReplaced();
    void remove(const RecoveredFile &file);

    MainWindowShell &mWindow;
    Document &mDocument;
    QString mFolder;
    Autosave mAutosave;
    QList<RecoveredFile> mReplaced; // opened ones, until there is a new copy of what was in them
};

} // namespace ductus
