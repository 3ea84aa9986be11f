// JobChip: at the right of the status row, what is being worked on: stage, percent, remaining time, cancel. A
// click opens the list of all jobs. Hidden while nothing runs.
#pragma once

#include "document/jobs/job_runner.h"

#include <QAbstractButton>

class QToolButton;

namespace ductus {

class JobPopup;

class JobChip : public QWidget
{
    Q_OBJECT
public:
    explicit JobChip(JobRunner &runner, QWidget *parent = nullptr);

    /// What it says now; empty while hidden.
    QString text() const;
    void openList();

private:
    void refresh();

    JobRunner &mRunner;
    class Face;
    Face *mFace;
    QToolButton *mCancel;
    JobPopup *mPopup = nullptr;
};

} // namespace ductus
