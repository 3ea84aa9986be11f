#include "base/job_control.h"

#include <algorithm>
#include <utility>

namespace ductus {

JobControl::JobControl(const std::atomic<bool> *cancelFlag, ProgressFunction onProgress)
    : mCancelFlag(cancelFlag), mOnProgress(std::move(onProgress))
{
}

void JobControl::progress(double fraction, std::string_view text) const
{
    if (mOnProgress)
        mOnProgress(mBegin + (mEnd - mBegin) * std::clamp(fraction, 0.0, 1.0), text);
}

JobControl JobControl::part(double begin, double end) const
{
    JobControl share = *this;
    share.mBegin = mBegin + (mEnd - mBegin) * begin;
    share.mEnd = mBegin + (mEnd - mBegin) * end;
    return share;
}

} // namespace ductus
