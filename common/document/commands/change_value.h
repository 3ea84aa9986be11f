// ChangeValue: the undo command for "this property of this object becomes that". One drag of a slider gives
// one command: commands with the same id, object and drag merge; when the value comes back to where it began
// the command becomes obsolete and leaves the stack.
//
//     struct SetOpacity : ChangeValue<LayerId, double> {
//         double get(const LayerId &id) const override { return mDocument.opacity(id); }
//         void set(const LayerId &id, const double &value) override { mDocument.applyOpacity(id, value); }
//     };
#pragma once

#include <QUndoCommand>
#include <typeinfo>
#include <utility>

namespace ductus {

/// Object: names what is changed (an id, compared with ==); Value: copied, compared with ==.
template <typename Object, typename Value>
class ChangeValue : public QUndoCommand
{
public:
    /// \a text names the act ("Change opacity"). \a commandId tells kinds of change apart when merging, -1
    /// never merges. \a drag: commands of one drag (the same number, > 0) merge; 0 never merges. Values that
    /// are typed or scrolled have no drag: each is a step of its own.
    ChangeValue(const QString &text, int commandId, Object object, Value newValue, quint64 drag = 0)
        : QUndoCommand(text), mObject(std::move(object)), mNewValue(std::move(newValue)), mDrag(drag),
          mCommandId(commandId)
    {
    }

    void redo() override
    {
        if (!mHasOldValue) {
            mOldValue = get(mObject);
            mHasOldValue = true;
        }
        if (mOldValue == mNewValue)
            setObsolete(true); // an edit to the present value is no edit
        set(mObject, mNewValue);
    }

    void undo() override { set(mObject, mOldValue); }

    int id() const override { return mDrag > 0 ? mCommandId : -1; }

    bool mergeWith(const QUndoCommand *other) override
    {
        const auto *next = dynamic_cast<const ChangeValue *>(other);
        if (!next || typeid(*next) != typeid(*this) || next->mDrag != mDrag || !(next->mObject == mObject))
            return false;
        mNewValue = next->mNewValue;
        setObsolete(mOldValue == mNewValue);
        return true;
    }

protected:
    virtual Value get(const Object &object) const = 0;
    virtual void set(const Object &object, const Value &value) = 0;

private:
    Object mObject;
    Value mOldValue{};
    Value mNewValue;
    quint64 mDrag = 0;
    int mCommandId = -1;
    bool mHasOldValue = false;
};

/// A number for a new drag, unique in the process. UI thread only.
quint64 nextDrag();

} // namespace ductus
