#include "widgets/shell/undo_panel.h"

#include "widgets/theme/icons.h"

#include <QUndoView>

namespace ductus {

UndoPanel::UndoPanel(QWidget *parent) : QDockWidget(tr("History"), parent), mView(new QUndoView)
{
    setObjectName(QStringLiteral("history"));
    mView->setFrameShape(QFrame::NoFrame);
    mView->setAccessibleName(tr("History of edits"));
    mView->setEmptyLabel(tr("As it was opened"));
    mView->setCleanIcon(icon(QStringLiteral("document-save")));
    mView->setMinimumWidth(200);
    setWidget(mView);
}

void UndoPanel::setStack(QUndoStack *stack)
{
    mView->setStack(stack);
}

} // namespace ductus
