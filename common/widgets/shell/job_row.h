// JobRow: one job in the list.
#pragma once

#include "document/jobs/job_runner.h"

#include <QWidget>

class QLabel;
class QToolButton;

namespace ductus {

class ThinBar;

class JobRow : public QWidget
{
    Q_OBJECT
public:
    explicit JobRow(JobId id, QWidget *parent = nullptr);

    void show(const JobState &state);

signals:
    void cancelRequested(int id);

private:
    QLabel *mTitle;
    QLabel *mStage;
    QLabel *mTime;
    ThinBar *mBar;
    QToolButton *mCancel;
};

} // namespace ductus
