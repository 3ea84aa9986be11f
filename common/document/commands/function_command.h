// FunctionCommand: an undo command from two functions, for edits that are not the value of one property.
//
//     stack->push(new FunctionCommand(tr("Delete strokes"), [=] { remove(ids); }, [=] { insert(strokes); }));
#pragma once

#include <QUndoCommand>
#include <functional>

namespace ductus {

class FunctionCommand : public QUndoCommand
{
public:
    FunctionCommand(const QString &text, std::function<void()> redo, std::function<void()> undo)
        : QUndoCommand(text), mRedo(std::move(redo)), mUndo(std::move(undo))
    {
    }

    void redo() override { mRedo(); }
    void undo() override { mUndo(); }

private:
    std::function<void()> mRedo;
    std::function<void()> mUndo;
};

} // namespace ductus
