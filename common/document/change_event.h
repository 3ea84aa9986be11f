// ChangeEvent: what Document::changed tells its views. Apps derive one struct a kind of change; a view asks
// with `event.as<StrokesChanged>()` and ignores what it does not show.
#pragma once

namespace ductus {

struct ChangeEvent
{
    virtual ~ChangeEvent() = default;

    /// This event as a \a T, or null if it is another kind.
    template <typename T>
    const T *as() const
    {
        return dynamic_cast<const T *>(this);
    }
};

/// The whole content was replaced: a file was opened. Views forget all they hold.
struct DocumentReset : ChangeEvent
{
};

} // namespace ductus
