// TopRow: the one row above everything: menus, a centre, search and help. Where the row is too narrow for the
// menu titles they move into the button at its left.
#pragma once

#include <QWidget>

class QAction;
class QHBoxLayout;
class QMenu;
class QMenuBar;
class QPushButton;
class QToolButton;

namespace ductus {

class TopRow : public QWidget
{
    Q_OBJECT
public:
    explicit TopRow(QWidget *parent = nullptr);

    QMenuBar *menuBar() { return mMenuBar; }
    /// Takes the widget.
    void setCentre(QWidget *widget);
    /// The centre is hidden, with its keys, while there is nothing to see.
    void setCentreVisible(bool visible);
    void addAtRight(QWidget *widget);
    void setSearchAction(QAction *action);
    void setHelpAction(QAction *action);
    bool menusAreFolded() const { return mIsFolded; }

protected:
    void resizeEvent(QResizeEvent *event) override;
    bool event(QEvent *event) override;

private:
    void arrange();
    void fillFoldedMenu();

    QToolButton *mMenuButton;
    QMenu *mFoldedMenu;
    QMenuBar *mMenuBar;
    QWidget *mCentre = nullptr;
    QWidget *mRight;
    QHBoxLayout *mRightLayout;
    QPushButton *mSearch;
    QToolButton *mHelp;
    bool mIsFolded = false;
    bool mIsCentreVisible = true;
};

} // namespace ductus
