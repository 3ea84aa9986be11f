#include "widgets/shell/undo_panel.h"

#include "widgets/theme/icons.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QUndoView>

namespace ductus {

UndoPanel::UndoPanel(QWidget *parent) : QDockWidget(tr("History"), parent), mView(new QUndoView)
{
    setObjectName(QStringLiteral("history"));
    setFeatures(QDockWidget::DockWidgetClosable);
    auto *heading = new QLabel(windowTitle());
    heading->setProperty("heading", true);
    auto *close = new QToolButton;
    close->setIcon(icon(QStringLiteral("close")));
    close->setIconSize({16, 16});
    close->setFixedSize(28, 28);
    close->setFocusPolicy(Qt::TabFocus);
    close->setAccessibleName(tr("Close history"));
    close->setToolTip(tr("Close the history"));
    connect(close, &QToolButton::clicked, this, &QDockWidget::close);
    auto *title = new QWidget;
    auto *row = new QHBoxLayout(title);
    row->setContentsMargins(16, 8, 8, 4);
    row->addWidget(heading, 1);
    row->addWidget(close);
    setTitleBarWidget(title);

    mView->setObjectName(QStringLiteral("historyView"));
    mView->setFrameShape(QFrame::NoFrame);
    mView->setAccessibleName(tr("History of edits"));
    mView->setEmptyLabel(tr("As it was opened"));
    mView->setMinimumWidth(200);
    setWidget(mView);
}

void UndoPanel::setStack(QUndoStack *stack)
{
    mView->setStack(stack);
}

} // namespace ductus
