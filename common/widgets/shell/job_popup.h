// JobPopup: the list of all jobs: title, stage, bar, time, cancel; one row each, kept up to date while open.
#pragma once

#include "document/jobs/job_runner.h"

#include <QFrame>
#include <map>

class QLabel;
class QVBoxLayout;

namespace ductus {

class JobRow;

class JobPopup : public QFrame
{
    Q_OBJECT
public:
    explicit JobPopup(JobRunner &runner, QWidget *parent = nullptr);

    /// Opens with its right lower corner above that of \a anchor.
    void openAbove(const QWidget &anchor);

private:
    void refresh();

    JobRunner &mRunner;
    QVBoxLayout *mRows;
    QLabel *mEmpty;
    std::map<JobId, JobRow *> mRowOf;
    const QWidget *mAnchor = nullptr;
};

} // namespace ductus
