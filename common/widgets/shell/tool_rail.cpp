#include "widgets/shell/tool_rail.h"

#include "document/settings/action_catalogue.h"

#include <QAction>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>

namespace ductus {

namespace {

constexpr int railWidth = 48;
constexpr int buttonSide = 40;
constexpr int iconSide = 24;

} // namespace

ToolRail::ToolRail(QWidget *parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("toolRail"));
    setAttribute(Qt::WA_StyledBackground);
    setAccessibleName(tr("Tools"));
    setFixedWidth(railWidth + 1); // and its line
    auto *column = new QWidget;
    column->setObjectName(QStringLiteral("scrolled"));
    mButtons = new QVBoxLayout(column);
    mButtons->setContentsMargins(4, 8, 4, 8);
    mButtons->setSpacing(4);
    mButtons->addStretch(1);
    auto *area = new QScrollArea;
    area->setFrameShape(QFrame::NoFrame);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setWidgetResizable(true);
    area->setFocusPolicy(Qt::NoFocus);
    area->setWidget(column);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 1, 0);
    layout->addWidget(area);
}

void ToolRail::addTool(QAction *action)
{
    auto *button = new QToolButton;
    button->setDefaultAction(action);
    button->setIconSize({iconSide, iconSide});
    button->setFixedSize(buttonSide, buttonSide);
    button->setFocusPolicy(Qt::TabFocus);
    button->setToolButtonStyle(action->icon().isNull() ? Qt::ToolButtonTextOnly : Qt::ToolButtonIconOnly);
    button->setAccessibleName(plainText(action->text()));
    button->setAccessibleDescription(action->statusTip());
    button->setProperty("helpTopic", action->objectName());
    mButtons->insertWidget(mButtons->count() - 1, button);
}

bool ToolRail::isEmpty() const
{
    return mButtons->count() == 1; // what stretches below the buttons
}

void ToolRail::addSeparator()
{
    auto *line = new QWidget;
    line->setObjectName(QStringLiteral("sectionLine"));
    line->setAttribute(Qt::WA_StyledBackground);
    line->setFixedSize(24, 1);
    mButtons->insertSpacing(mButtons->count() - 1, 3);
    mButtons->insertWidget(mButtons->count() - 1, line, 0, Qt::AlignHCenter);
    mButtons->insertSpacing(mButtons->count() - 1, 3);
}

} // namespace ductus
