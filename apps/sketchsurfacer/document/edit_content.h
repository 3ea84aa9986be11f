// EditContent: the one undo command of SketchSurfacer: this content becomes that content.
#pragma once

#include "sketchsurfacer/document/sketch_content.h"

#include <QUndoCommand>
#include <functional>

namespace ductus {

class EditContent : public QUndoCommand
{
public:
    using Apply = std::function<void(const SketchContent &)>;

    /// \a text names the act. Commands of one \a drag (> 0) merge.
    EditContent(const QString &text, SketchContent before, SketchContent after, quint64 drag, Apply apply);

    void redo() override { mApply(mAfter); }
    void undo() override { mApply(mBefore); }
    int id() const override { return mDrag > 0 ? 1 : -1; }
    bool mergeWith(const QUndoCommand *other) override;

private:
    SketchContent mBefore, mAfter;
    quint64 mDrag;
    Apply mApply;
};

} // namespace ductus
