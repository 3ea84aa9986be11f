// ToolRail: the bar of tools at the left, 48 px wide: one 40-px button a tool. It scrolls by wheel and keys
// when the window is too low for all.
#pragma once

#include <QWidget>

class QAction;
class QVBoxLayout;

namespace ductus {

class ToolRail : public QWidget
{
    Q_OBJECT
public:
    explicit ToolRail(QWidget *parent = nullptr);

    void addTool(QAction *action);
    void addSeparator();
    bool isEmpty() const;

private:
    QVBoxLayout *mButtons;
};

} // namespace ductus
