// ExportDialog: from the scene to a film in one of three ways - share, slides, overlay - with progress, and
// where it is when it is done.
#pragma once

#include "document/jobs/job_runner.h"
#include "doodlestudio/document/doodle_document.h"
#include "doodling/export/export_film.h"

#include <QDialog>

class QButtonGroup;
class QCheckBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QVBoxLayout;

namespace ductus {

enum class ExportPreset { Share, Slides, Overlay };

/// What a preset means for the engine.
FilmExport exportOf(ExportPreset preset, bool withSound);
/// "mp4", "gif", "webm".
QString suffixOf(ExportPreset preset);

class ExportDialog : public QDialog
{
    Q_OBJECT
public:
    /// Both must outlive this.
    ExportDialog(DoodleDocument &document, JobRunner &runner, QWidget *parent = nullptr);

    void setPreset(ExportPreset preset);
    void setPath(const QString &path);
    QString path() const;
    bool isExporting() const { return mJob > 0; }
    void start();

signals:
    void exported(const QString &path);

private:
    void buildPresets(QVBoxLayout *layout);
    void choosePath();
    void pathEdited();
    /// The file is there and nobody has said yet that it may go: asks, in the dialog.
    bool asksToReplace();
    void finish(const QString &path, Result<ExportReport> report);
    void showRunning(bool running);

    DoodleDocument &mDocument;
    JobRunner &mRunner;
    QButtonGroup *mPresets;
    QLineEdit *mPath;
    QCheckBox *mSound;
    QProgressBar *mProgress;
    QLabel *mStatus;
    QPushButton *mStart;
    QPushButton *mFolder;
    QPushButton *mClose;
    JobId mJob = 0;
    QString mMayReplace; // the file that was agreed on
};

} // namespace ductus
