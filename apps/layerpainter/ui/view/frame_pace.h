// FramePace: how coarse the canvas is drawn while it moves, so that it stays fluid without a graphics card.
// A resolution is kept through a movement as long as it is fast enough: changes of sharpness would flicker.
#pragma once

namespace ductus {

class FramePace
{
public:
    static constexpr double targetMilliseconds = 45; // a frame while moving; leaves room for 15 a second
    static constexpr int stillMilliseconds = 150;    // without movement until the canvas is sharp again
    static constexpr int coarsest = 6;

    /// The view turns or a tool works. The first call after stop() begins a movement.
    void move();
    /// The painting was edited, \a now in milliseconds of any clock: a single edit is shown sharp at once, a
    /// row of them (a slider's) is a movement.
    void edit(double now);
    void stop() { mIsMoving = false; }
    bool isMoving() const { return mIsMoving; }

    /// Pixels of the window to each side of a drawn one: 1 when still.
    int divisor() const { return mIsMoving ? mDivisor : 1; }
    /// What a frame of the present divisor took.
    void drawn(double milliseconds);

private:
    double mSharpMilliseconds = 0; // what a frame costs at full resolution, as far as known
    double mLastEdit = -1e9;
    int mDivisor = 1;
    bool mIsMoving = false;
};

} // namespace ductus
