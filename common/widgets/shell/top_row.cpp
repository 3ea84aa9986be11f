#include "widgets/shell/top_row.h"

#include "document/settings/action_catalogue.h"
#include "widgets/theme/icons.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QToolButton>

namespace ductus {

namespace {

constexpr int rowHeight = 44;
constexpr int margin = 8;
constexpr int gap = 16;
constexpr int searchWidth = 184;
constexpr int narrowSearchWidth = 36;

} // namespace

TopRow::TopRow(QWidget *parent)
    : QWidget(parent), mMenuButton(new QToolButton(this)), mFoldedMenu(new QMenu(this)),
      mMenuBar(new QMenuBar(this)), mRight(new QWidget(this)), mRightLayout(new QHBoxLayout(mRight)),
      mSearch(new QPushButton), mHelp(new QToolButton)
{
    setObjectName(QStringLiteral("topRow"));
    setAttribute(Qt::WA_StyledBackground);
    setFixedHeight(rowHeight + 1); // and its line

    mMenuBar->setNativeMenuBar(false);
    mMenuButton->setIcon(icon(QStringLiteral("application-menu")));
    mMenuButton->setIconSize({16, 16});
    mMenuButton->setFixedSize(28, 28);
    mMenuButton->setPopupMode(QToolButton::InstantPopup);
    mMenuButton->setMenu(mFoldedMenu);
    mMenuButton->setAccessibleName(tr("Menu"));
    mMenuButton->setToolTip(tr("All menus"));
    mMenuButton->setFocusPolicy(Qt::TabFocus);
    connect(mFoldedMenu, &QMenu::aboutToShow, this, &TopRow::fillFoldedMenu);

    mSearch->setIcon(icon(QStringLiteral("edit-find")));
    mSearch->setIconSize({16, 16});
    mSearch->setObjectName(QStringLiteral("searchField"));
    mSearch->setText(tr("Search actions"));
    mSearch->setFixedWidth(searchWidth);
    mHelp->setIcon(icon(QStringLiteral("help")));
    mHelp->setIconSize({16, 16});
    mHelp->setFixedSize(28, 28);
    mHelp->setFocusPolicy(Qt::TabFocus);
    mRightLayout->setContentsMargins(0, 0, 0, 0);
    mRightLayout->setSpacing(8);
    mRightLayout->addWidget(mSearch);
    mRightLayout->addWidget(mHelp);
}

void TopRow::setCentre(QWidget *widget)
{
    delete mCentre;
    mCentre = widget;
    if (mCentre) {
        mCentre->setParent(this);
        mCentre->setVisible(mIsCentreVisible);
    }
    arrange();
}

void TopRow::setCentreVisible(bool visible)
{
    mIsCentreVisible = visible;
    if (mCentre)
        mCentre->setVisible(visible);
    arrange();
}

void TopRow::addAtRight(QWidget *widget)
{
    mRightLayout->insertWidget(mRightLayout->indexOf(mSearch), widget);
    arrange();
}

void TopRow::setSearchAction(QAction *action)
{
    connect(mSearch, &QPushButton::clicked, action, &QAction::trigger);
    mSearch->setToolTip(action->toolTip());
    mSearch->setAccessibleName(plainText(action->text()));
    arrange();
}

void TopRow::setHelpAction(QAction *action)
{
    connect(mHelp, &QToolButton::clicked, action, &QAction::trigger);
    mHelp->setToolTip(action->toolTip());
    mHelp->setAccessibleName(plainText(action->text()));
}

void TopRow::fillFoldedMenu()
{
    mFoldedMenu->clear();
    mFoldedMenu->addActions(mMenuBar->actions());
}

// Centre in the middle of the row as long as there is room; then pushed aside; then the menus fold, then the
// search.
void TopRow::arrange()
{
    const QSize centre = mCentre ? mCentre->sizeHint().expandedTo(mCentre->minimumSize()) : QSize();
    const int centreWidth = mCentre && mIsCentreVisible ? centre.width() : 0;
    const int menuWidth = mMenuBar->sizeHint().width();
    // Tried without touching the search: each change asks for a layout, so that a row whose search stays
    // narrow would never come to rest.
    const int besideSearch = mRight->sizeHint().width() - mSearch->minimumWidth();
    const auto rightWidthWith = [&](bool wide) {
        return besideSearch + (wide ? searchWidth : narrowSearchWidth);
    };
    const auto fits = [&](int left, bool wide) {
        return margin + left + gap + centreWidth + gap + rightWidthWith(wide) + margin <= width();
    };
    const int button = 28 + 4;
    mIsFolded = !fits(menuWidth, true) && !fits(menuWidth, false);
    const bool isSearchWide = fits(mIsFolded ? button : menuWidth, true);
    const int rightWidth = rightWidthWith(isSearchWide);
    if (mSearch->minimumWidth() != (isSearchWide ? searchWidth : narrowSearchWidth)) {
        mSearch->setText(isSearchWide ? tr("Search actions") : QString());
        mSearch->setFixedWidth(isSearchWide ? searchWidth : narrowSearchWidth);
        mRightLayout->invalidate();
    }
    mMenuButton->setVisible(mIsFolded);
    mMenuBar->setVisible(!mIsFolded);
    const int leftWidth = mIsFolded ? button : menuWidth;
    const auto vertical = [&](int height) { return (rowHeight - height) / 2; };
    mMenuButton->move(margin, vertical(28));
    const int menuHeight = mMenuBar->sizeHint().height();
    mMenuBar->setGeometry(margin, vertical(menuHeight), menuWidth, menuHeight);
    const int rightX = width() - margin - rightWidth;
    const int rightHeight = mRight->sizeHint().height();
    mRight->setGeometry(rightX, vertical(rightHeight), rightWidth, rightHeight);
    if (mCentre) {
        const int leftEnd = margin + leftWidth + gap;
        int x = (width() - centreWidth) / 2;
        x = std::max(leftEnd, std::min(x, rightX - gap - centreWidth));
        mCentre->setGeometry(x, vertical(centre.height()), centre.width(), centre.height());
    }
}

void TopRow::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    arrange();
}

bool TopRow::event(QEvent *event)
{
    const bool done = QWidget::event(event);
    if (event->type() == QEvent::LayoutRequest || event->type() == QEvent::StyleChange ||
        event->type() == QEvent::FontChange || event->type() == QEvent::Show)
        arrange();
    return done;
}

} // namespace ductus
