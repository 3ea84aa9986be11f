// RecoveryList: the copies autosave.h left behind because the program ended without closing its document. A
// copy whose program still runs (it holds the lock) is not listed.
#pragma once

#include "base/result.h"
#include "document/document_files.h"

#include <QDateTime>
#include <QImage>
#include <QList>
#include <QString>

namespace ductus {

struct RecoveredFile
{
    QString copy;         // the autosaved .ductus
    QString originalPath; // of the document; empty if it was never saved
    QString displayName;
    QDateTime savedAt;
    QImage thumbnail; // may be null
};

/// What a copy is of, beside it as name.ductus.json.
QString recoveryNotePath(const QString &copy);
Result<void> writeRecoveryNote(const QString &copy, const QString &originalPath, const QString &displayName);

/// The copies in \a folder, newest first; damaged ones too: opening them says what is wrong. Reads each for
/// its thumbnail, so rather for a worker if there may be large ones.
QList<RecoveredFile> recoveredFiles(const QString &folder);

/// Removes the copy for good. WriteFailed if the system refuses.
Result<void> discardRecovered(const RecoveredFile &file);

/// Puts \a opened, read from \a file.copy by openProjectFile(), into \a document as unsaved work on the
/// original. The copy stays until the document is saved or discarded. UI thread.
Result<OpenNotes> adoptRecovered(Document &document, OpenedProject opened, const RecoveredFile &file);

} // namespace ductus
