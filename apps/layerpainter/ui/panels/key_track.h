// KeyTrack: time from left to right, with the keys of camera and layers; a drag scrubs, arrow keys step.
#pragma once

#include <QWidget>
#include <vector>

namespace ductus {

struct TrackKey
{
    double seconds = 0;
    bool isCamera = false; // else of a layer or group
};

class KeyTrack : public QWidget
{
    Q_OBJECT
public:
    explicit KeyTrack(QWidget *parent = nullptr);

    void setLength(double seconds);
    double length() const { return mLength; }
    void setSeconds(double seconds);
    double seconds() const { return mSeconds; }
    void setKeys(std::vector<TrackKey> keys);
    /// The camera's key under the playhead, if there is one.
    bool isOnCameraKey() const;

    QSize sizeHint() const override { return {320, 28}; }
    QSize minimumSizeHint() const override { return {80, 28}; }

signals:
    void scrubbed(double seconds);

protected:
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    double xAt(double seconds) const;
    void scrub(double seconds);
    void scrubTo(double x);

    double mLength = 4;
    double mSeconds = 0;
    std::vector<TrackKey> mKeys;
};

} // namespace ductus
