// JobControl: how a long engine function reports progress and learns that it should stop.
// The engine sees only this; threads, windows and terminals are the caller's business.
//
//     for (int i = 0; i < n; ++i) {
//         if (control.isCancelled())
//             return cancelledError("Fitting the surface");
//         control.progress(double(i) / n, "Fitting the surface");
//     }
#pragma once

#include <atomic>
#include <functional>
#include <string_view>

namespace ductus {

class JobControl
{
public:
    using ProgressFunction = std::function<void(double fraction, std::string_view text)>;

    /// Never cancelled, progress goes nowhere.
    JobControl() = default;

    /// \a cancelFlag may be null; both must outlive the control. Progress may arrive from worker threads.
    JobControl(const std::atomic<bool> *cancelFlag, ProgressFunction onProgress);

    /// \a fraction in 0..1 of this control's own share.
    void progress(double fraction, std::string_view text) const;

    /// To be asked at least every 100 ms.
    bool isCancelled() const { return mCancelFlag && mCancelFlag->load(std::memory_order_relaxed); }

    /// A control for a step that covers \a begin .. \a end of this one.
    JobControl part(double begin, double end) const;

    /// The same cancel flag, but progress goes nowhere: for all but one of several parallel runs.
    JobControl silenced() const { return JobControl(mCancelFlag, {}); }

private:
    const std::atomic<bool> *mCancelFlag = nullptr;
    ProgressFunction mOnProgress;
    double mBegin = 0.0;
    double mEnd = 1.0;
};

} // namespace ductus
