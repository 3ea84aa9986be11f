#include "sketchsurfacer/document/edit_content.h"

namespace ductus {

EditContent::EditContent(const QString &text, SketchContent before, SketchContent after, quint64 drag,
                         Apply apply)
    : QUndoCommand(text), mBefore(std::move(before)), mAfter(std::move(after)), mDrag(drag),
      mApply(std::move(apply))
{
}

bool EditContent::mergeWith(const QUndoCommand *other)
{
    const auto *next = dynamic_cast<const EditContent *>(other);
    if (!next || next->mDrag != mDrag)
        return false;
    mAfter = next->mAfter;
    return true;
}

} // namespace ductus
