// Turntable: turns the view around what is shown, to be looked at or taken picture by picture.
#pragma once

#include <QElapsedTimer>
#include <QImage>
#include <QObject>
#include <QTimer>
#include <functional>

namespace ductus {

class SketchView;

class Turntable : public QObject
{
    Q_OBJECT
public:
    /// \a view must outlive this.
    explicit Turntable(SketchView &view, QObject *parent = nullptr);

    /// Turns until it is stopped, a round in twelve seconds.
    void setTurning(bool on);
    bool isTurning() const { return mTimer.isActive(); }

    /// One round in \a count pictures; \a taken gets each with its number and says whether to go on. The view
    /// stands as before afterwards.
    void takePictures(int count, std::function<bool(int number, const QImage &picture)> taken);

signals:
    void picturesTaken();

private:
    SketchView &mView;
    QTimer mTimer;
    QElapsedTimer mClock;
};

} // namespace ductus
