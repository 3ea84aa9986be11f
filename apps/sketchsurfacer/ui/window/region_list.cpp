#include "sketchsurfacer/ui/window/region_list.h"

#include "sketchsurfacer/ui/viewport/length_text.h"
#include "widgets/theme/icons.h"

#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <numeric>

namespace ductus {

namespace {

enum Column { Kind, Area, Deviation, Lock, ColumnCount };

QIcon swatch(Rgba colour)
{
    QPixmap pixmap(32, 32);
    pixmap.setDevicePixelRatio(2.0);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(colour[0], colour[1], colour[2]));
    painter.drawRoundedRect(QRectF(1, 1, 14, 14), 3, 3);
    return QIcon(pixmap);
}

} // namespace

QString surfaceKindName(int degree)
{
    switch (degree) {
    case 1:
        return RegionList::tr("plane");
    case 2:
        return RegionList::tr("quadric");
    case 3:
        return RegionList::tr("cubic");
    case 4:
        return RegionList::tr("quartic");
    default:
        return RegionList::tr("surface");
    }
}

RegionList::RegionList(QWidget *parent) : QWidget(parent)
{
    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    mEmpty = new QLabel(tr("The regions appear here once the sketch is surfaced."));
    mEmpty->setWordWrap(true);
    mEmpty->setProperty("dim", true);
    mTree = new QTreeWidget;
    mTree->setObjectName(QStringLiteral("regionList"));
    mTree->setAccessibleName(tr("Regions"));
    mTree->setRootIsDecorated(false);
    mTree->setUniformRowHeights(true);
    mTree->setAllColumnsShowFocus(true);
    mTree->setFrameShape(QFrame::NoFrame);
    mTree->setMinimumSize(80, 200);
    mTree->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    mTree->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    mTree->setIconSize(QSize(16, 16));
    mTree->setContextMenuPolicy(Qt::CustomContextMenu);
    mTree->setHeaderLabels({tr("Kind"), tr("Area"), tr("Off by"), QString()});
    mTree->headerItem()->setToolTip(Deviation, tr("Mean distance of its strokes from the region."));
    mTree->setToolTip(
        tr("Press Enter or right-click to change a region's kind; the lock keeps it as it is."));
    mTree->header()->setStretchLastSection(false);
    mTree->header()->setSectionResizeMode(Kind, QHeaderView::Stretch);
    for (const int column : {int(Area), int(Deviation), int(Lock)})
        mTree->header()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    mTree->header()->setMinimumSectionSize(28);
    rows->addWidget(mEmpty);
    rows->addWidget(mTree);
    mTree->hide();
    connect(mTree, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem *item) {
        if (item)
            emit chosen(regionOf(item));
    });
    connect(mTree, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem *item, int column) {
        if (column == Lock)
            emit lockToggled(regionOf(item));
    });
    connect(mTree, &QTreeWidget::itemActivated, this,
            [this](QTreeWidgetItem *item) { openMenu(mTree->visualItemRect(item).bottomLeft()); });
    connect(mTree, &QTreeWidget::customContextMenuRequested, this, &RegionList::openMenu);
}

int RegionList::regionOf(const QTreeWidgetItem *item) const
{
    return item ? item->data(Kind, Qt::UserRole).toInt() : -1;
}

int RegionList::rowCount() const
{
    return mTree->topLevelItemCount();
}

void RegionList::setResult(const std::shared_ptr<const ResultView> &view, double metresPerUnit)
{
    const QSignalBlocker blocker(mTree);
    const int before = regionOf(mTree->currentItem());
    mTree->clear();
    const bool has = view && !view->regionViews.empty();
    mTree->setVisible(has);
    mEmpty->setVisible(!has);
    if (!has)
        return;
    std::vector<int> order(view->regionViews.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        return view->regionViews[std::size_t(a)].area > view->regionViews[std::size_t(b)].area;
    });
    for (int region : order) {
        const RegionView &data = view->regionViews[std::size_t(region)];
        auto *item = new QTreeWidgetItem(mTree);
        item->setData(Kind, Qt::UserRole, region);
        item->setIcon(Kind, swatch(data.colour));
        item->setText(Kind, surfaceKindName(data.degree));
        item->setText(Area, areaText(data.area * metresPerUnit * metresPerUnit, locale()));
        item->setText(Deviation, data.deviation < 0.0 ? QStringLiteral("–")
                                                      : lengthText(data.deviation * metresPerUnit, locale()));
        item->setTextAlignment(Area, Qt::AlignRight | Qt::AlignVCenter);
        item->setTextAlignment(Deviation, Qt::AlignRight | Qt::AlignVCenter);
        item->setIcon(Lock, icon(data.isLocked ? QStringLiteral("lock") : QStringLiteral("unlock")));
        item->setToolTip(Lock, data.isLocked ? tr("Locked: stays as it is. Click to free it.")
                                             : tr("Click to keep this region as it is."));
        if (region == before)
            mTree->setCurrentItem(item);
    }
}

void RegionList::choose(int region)
{
    const QSignalBlocker blocker(mTree);
    mTree->setCurrentItem(nullptr);
    for (int i = 0; i < mTree->topLevelItemCount(); ++i)
        if (regionOf(mTree->topLevelItem(i)) == region) {
            mTree->setCurrentItem(mTree->topLevelItem(i));
            mTree->scrollToItem(mTree->topLevelItem(i));
        }
}

void RegionList::openMenu(const QPoint &position)
{
    const int region = regionOf(mTree->itemAt(position) ? mTree->itemAt(position) : mTree->currentItem());
    if (region < 0)
        return;
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (int degree = 1; degree <= 4; ++degree)
        menu->addAction(tr("Make it a %1").arg(surfaceKindName(degree)), this,
                        [this, region, degree] { emit degreeChosen(region, degree); });
    menu->addSeparator();
    menu->addAction(icon(QStringLiteral("lock")), tr("Lock or free it"), this,
                    [this, region] { emit lockToggled(region); });
    menu->popup(mTree->viewport()->mapToGlobal(position));
}

} // namespace ductus
