// SurfaceButton: the one large button: "Surface it", then "Update", while it runs "Stop". Below it one line
// says how things stand.
#pragma once

#include "sketchsurfacer/document/surfacing_jobs.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace ductus {

class ThinBar;

class SurfaceButton : public QWidget
{
    Q_OBJECT
public:
    SurfaceButton(SketchDocument &document, SurfacingJobs &jobs, JobRunner &runner,
                  QWidget *parent = nullptr);

    QPushButton *button() const { return mButton; }

signals:
    /// Clicked while it offers to surface.
    void surfaceRequested();

private:
    void refresh();
    void showProgress(const JobState &state);

    SketchDocument &mDocument;
    SurfacingJobs &mJobs;
    QPushButton *mButton;
    ThinBar *mProgress;
    QLabel *mState;
};

} // namespace ductus
