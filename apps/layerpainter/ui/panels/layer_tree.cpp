#include "layerpainter/ui/panels/layer_tree.h"

#include "widgets/theme/icons.h"

#include <QDropEvent>
#include <QHeaderView>
#include <QMouseEvent>
#include <QScrollBar>
#include <QTimer>
#include <algorithm>
#include <set>

namespace ductus {

namespace {

enum Column { NameColumn, EyeColumn, LockColumn };
constexpr int layerRole = Qt::UserRole;     // of the row's layer, -1 for the scene's row
constexpr int stackRole = Qt::UserRole + 1; // of the stack it belongs to

LayerId layerOf(const QTreeWidgetItem *item)
{
    return LayerId{item ? item->data(0, layerRole).toInt() : -1};
}

StackId stackOf(const QTreeWidgetItem *item)
{
    return StackId{item ? item->data(0, stackRole).toInt() : sceneStackId.value};
}

QString text(const std::string &name)
{
    return QString::fromStdString(name);
}

} // namespace

LayerTree::LayerTree(PaintingDocument &document, QWidget *parent) : QTreeWidget(parent), mDocument(document)
{
    setObjectName(QStringLiteral("layerTree"));
    setAccessibleName(tr("Layers"));
    setHeaderHidden(true);
    setColumnCount(3);
    header()->setStretchLastSection(false);
    header()->setSectionResizeMode(NameColumn, QHeaderView::Stretch);
    for (const int column : {EyeColumn, LockColumn}) {
        header()->setSectionResizeMode(column, QHeaderView::Fixed);
        header()->setMinimumSectionSize(20);
        setColumnWidth(column, 28);
    }
    setIndentation(16);
    setMouseTracking(true);
    setDragDropMode(QAbstractItemView::InternalMove);
    setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
    setMinimumHeight(300);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    connect(this, &QTreeWidget::itemClicked, this, &LayerTree::onClicked);
    connect(this, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem *item) { onEdited(item); });
    connect(this, &QTreeWidget::currentItemChanged, this, [this] {
        if (!mIsFilling)
            emit layerChosen(currentLayer());
    });
    connect(&mDocument, &Document::changed, this, [this](const ChangeEvent &event) {
        const auto *change = event.as<PaintingChanged>();
        if (!change || change->layers || change->properties)
            refresh();
    });
    refresh();
}

void LayerTree::fillRow(QTreeWidgetItem *item, const Layer &layer)
{
    const bool visible = layer.properties.visible;
    item->setData(0, layerRole, layer.id.value);
    item->setIcon(EyeColumn, visible ? icon(QStringLiteral("peek")) : QIcon());
    item->setToolTip(EyeColumn, visible ? tr("Hide") : tr("Show"));
    item->setIcon(LockColumn, layer.locked ? icon(QStringLiteral("lock")) : QIcon());
    item->setToolTip(LockColumn, layer.locked ? tr("Unlock") : tr("Lock: nothing changes it"));
    // The whole name, too: many are longer than the column.
    item->setToolTip(NameColumn, QStringLiteral("<b>%1</b><br>%2")
                                     .arg(item->text(NameColumn).toHtmlEscaped(),
                                          tr("%n strokes", nullptr, layer.elementCount()).toHtmlEscaped()));
    QFont font = item->font(NameColumn);
    font.setItalic(!visible);
    item->setFont(NameColumn, font);
}

void LayerTree::refresh()
{
    mIsFilling = true;
    const LayerId chosen = currentLayer();
    // A click on an eye must not move the list under the hand, nor open what was folded.
    const int scrolled = verticalScrollBar()->value();
    std::set<StackId> folded;
    for (int i = 0; i < topLevelItemCount(); ++i)
        if (topLevelItem(i)->childCount() > 0 && !topLevelItem(i)->isExpanded())
            folded.insert(stackOf(topLevelItem(i)));
    clear();
    const Painting &painting = mDocument.painting();
    const auto addStack = [&](const Stack &stack) {
        auto *row = new QTreeWidgetItem(this, {text(stack.name)});
        row->setData(0, stackRole, stack.id.value);
        row->setData(0, layerRole, -1);
        row->setIcon(NameColumn, icon(QStringLiteral("stack")));
        QFont bold = row->font(NameColumn);
        bold.setWeight(QFont::DemiBold);
        row->setFont(NameColumn, bold);
        Qt::ItemFlags flags = row->flags() | Qt::ItemIsDropEnabled;
        if (stack.substrate) {
            fillRow(row, *stack.substrate);
            flags |= Qt::ItemIsEditable;
        } else {
            flags &= ~Qt::ItemIsDragEnabled;
            row->setToolTip(NameColumn, tr("Its layers colour everything, after all others."));
        }
        row->setFlags(flags);
        for (auto layer = stack.appearance.rbegin(); layer != stack.appearance.rend(); ++layer) {
            auto *child = new QTreeWidgetItem(row, {text(layer->name)});
            child->setData(0, stackRole, stack.id.value);
            child->setIcon(NameColumn, icon(QStringLiteral("appearance-layer")));
            fillRow(child, *layer);
            child->setFlags((child->flags() | Qt::ItemIsEditable) & ~Qt::ItemIsDropEnabled);
        }
        row->setExpanded(!folded.contains(stack.id));
    };
    addStack(painting.sceneStack);
    for (auto stack = painting.stacks.rbegin(); stack != painting.stacks.rend(); ++stack)
        addStack(*stack);
    QTreeWidgetItem *row = rowOf(chosen);
    if (!row)
        row = topLevelItem(std::min(1, topLevelItemCount() - 1));
    setCurrentItem(row);
    applyFilter();
    if (currentLayer() == chosen) {
        executeDelayedItemsLayout();
        verticalScrollBar()->setValue(scrolled);
    }
    mIsFilling = false;
    if (currentLayer() != chosen)
        emit layerChosen(currentLayer());
}

void LayerTree::setFilter(const QString &part)
{
    mFilter = part.trimmed();
    applyFilter();
    if (currentItem() && !currentItem()->isHidden())
        scrollToItem(currentItem());
}

void LayerTree::applyFilter()
{
    const auto matches = [this](const QTreeWidgetItem *item) {
        return item->text(NameColumn).contains(mFilter, Qt::CaseInsensitive);
    };
    for (int i = 0; i < topLevelItemCount(); ++i) {
        QTreeWidgetItem *stack = topLevelItem(i);
        const bool isWanted = mFilter.isEmpty() || matches(stack);
        bool anyLayer = false;
        for (int j = 0; j < stack->childCount(); ++j) {
            const bool isShown = isWanted || matches(stack->child(j));
            stack->child(j)->setHidden(!isShown);
            anyLayer |= isShown;
        }
        stack->setHidden(!isWanted && !anyLayer);
    }
}

QTreeWidgetItem *LayerTree::rowOf(LayerId layer) const
{
    if (!layer.isValid())
        return nullptr;
    for (QTreeWidgetItemIterator it(const_cast<LayerTree *>(this)); *it; ++it)
        if (layerOf(*it) == layer)
            return *it;
    return nullptr;
}

LayerId LayerTree::currentLayer() const
{
    return layerOf(currentItem());
}

StackId LayerTree::currentStack() const
{
    return stackOf(currentItem());
}

void LayerTree::choose(LayerId layer)
{
    if (QTreeWidgetItem *row = rowOf(layer))
        setCurrentItem(row);
}

void LayerTree::renameCurrent()
{
    if (currentItem())
        editItem(currentItem(), NameColumn);
}

void LayerTree::onClicked(QTreeWidgetItem *item, int column)
{
    const Layer *layer = mDocument.painting().findLayer(layerOf(item));
    if (!layer)
        return;
    if (column == EyeColumn) {
        act::SetProperties edit;
        edit.layer = layer->id;
        edit.visible = !layer->properties.visible;
        (void)mDocument.perform(edit);
    } else if (column == LockColumn) {
        (void)mDocument.perform(act::LockLayer{layer->id, !layer->locked});
    }
}

void LayerTree::onEdited(QTreeWidgetItem *item)
{
    if (mIsFilling)
        return;
    const std::string name = item->text(NameColumn).trimmed().toStdString();
    const LayerId layer = layerOf(item);
    const bool isStack = !item->parent();
    const StackId stack = stackOf(item);
    // The row goes away while it is being edited: after the editor has closed.
    QTimer::singleShot(0, this, [this, name, layer, isStack, stack] {
        const Layer *found = mDocument.painting().findLayer(layer);
        if (!found || name.empty() || found->name == name) {
            refresh();
            return;
        }
        if (isStack)
            (void)mDocument.perform(act::RenameStack{stack, name});
        else
            (void)mDocument.perform(act::RenameLayer{layer, name});
    });
}

void LayerTree::dropEvent(QDropEvent *event)
{
    QTreeWidgetItem *dragged = currentItem();
    QTreeWidgetItem *target = itemAt(event->position().toPoint());
    const DropIndicatorPosition where = dropIndicatorPosition();
    event->setDropAction(Qt::IgnoreAction); // the rows follow the document
    event->accept();
    if (!dragged || !target || dragged == target)
        return;
    const Painting &painting = mDocument.painting();
    const StackId to = stackOf(target);
    if (!dragged->parent()) { // a stack, before or behind another
        const StackId stack = stackOf(dragged);
        const auto indexOf = [&](StackId id) {
            const auto found = std::ranges::find(painting.stacks, id, &Stack::id);
            return int(found - painting.stacks.begin());
        };
        if (to == sceneStackId || stack == to)
            return;
        int position = indexOf(to) + (where == AboveItem ? 1 : 0); // later stands above
        if (indexOf(stack) < position)
            --position;
        (void)mDocument.perform(act::MoveStack{stack, position});
        return;
    }
    const LayerId layer = layerOf(dragged);
    const Stack *stack = painting.findStack(to);
    int position = int(stack->appearance.size());
    if (target->parent()) {
        const auto found = std::ranges::find(stack->appearance, layerOf(target), &Layer::id);
        position = int(found - stack->appearance.begin()) + (where == AboveItem ? 1 : 0);
    }
    if (stackOf(dragged) == to) {
        const auto own = std::ranges::find(stack->appearance, layer, &Layer::id);
        if (int(own - stack->appearance.begin()) < position)
            --position;
    }
    (void)mDocument.perform(act::MoveLayer{layer, to, position});
}

void LayerTree::mouseMoveEvent(QMouseEvent *event)
{
    emit layerHovered(layerOf(itemAt(event->pos())));
    QTreeWidget::mouseMoveEvent(event);
}

void LayerTree::leaveEvent(QEvent *event)
{
    emit layerHovered(LayerId());
    QTreeWidget::leaveEvent(event);
}

} // namespace ductus
