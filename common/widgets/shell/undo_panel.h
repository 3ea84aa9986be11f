// UndoPanel: the history as a list; a click goes there.
#pragma once

#include <QDockWidget>

class QUndoStack;
class QUndoView;

namespace ductus {

class UndoPanel : public QDockWidget
{
    Q_OBJECT
public:
    explicit UndoPanel(QWidget *parent = nullptr);
    /// Null: empty.
    void setStack(QUndoStack *stack);

private:
    QUndoView *mView;
};

} // namespace ductus
