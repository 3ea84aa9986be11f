#include "doodlestudio/ui/canvases/canvas_list.h"

#include "doodling/canvas/edit_scene.h"
#include "widgets/theme/icons.h"

#include <QHBoxLayout>
#include <QListWidget>
#include <QToolButton>
#include <QVBoxLayout>

namespace ductus {

CanvasList::CanvasList(StudioState &state, QWidget *parent) : QWidget(parent), mState(state)
{
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    mList = new QListWidget;
    mList->setObjectName(QStringLiteral("canvasList"));
    mList->setAccessibleName(tr("Canvases"));
    mList->setFixedHeight(104);
    mList->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    layout->addWidget(mList);
    auto *buttons = new QHBoxLayout;
    buttons->setSpacing(4);
    QToolButton *copy = button(QStringLiteral("edit-copy"), tr("Duplicate canvas"),
                               tr("A second canvas with the same drawings, beside this one."));
    QToolButton *remove = button(QStringLiteral("edit-delete"), tr("Take canvas away"),
                                 tr("Takes the canvas and its drawings away."));
    connect(copy, &QToolButton::clicked, this, &CanvasList::duplicateChosen);
    connect(remove, &QToolButton::clicked, this, &CanvasList::removeChosen);
    buttons->addWidget(copy);
    buttons->addWidget(remove);
    buttons->addStretch(1);
    layout->addLayout(buttons);
    connect(mList, &QListWidget::currentItemChanged, this, [this](QListWidgetItem *item) {
        if (!mIsRefreshing && item)
            mState.choose(CanvasId{item->data(Qt::UserRole).toInt()});
    });
    connect(mList, &QListWidget::itemChanged, this, [this](QListWidgetItem *item) {
        const Canvas *canvas = mState.document().canvas(CanvasId{item->data(Qt::UserRole).toInt()});
        if (mIsRefreshing || !canvas)
            return;
        Canvas changed = *canvas;
        changed.name = item->text().trimmed().toStdString();
        changed.isVisible = item->checkState() == Qt::Checked;
        const QString text = changed.isVisible != canvas->isVisible
                                 ? (changed.isVisible ? tr("Show canvas") : tr("Hide canvas"))
                                 : tr("Rename canvas");
        // Not from within the list's own signal: the edit fills the list anew.
        QMetaObject::invokeMethod(
            this, [this, text, changed] { mState.document().editCanvas(text, changed); },
            Qt::QueuedConnection);
    });
    connect(&state, &StudioState::chosenChanged, this, &CanvasList::refresh);
    connect(&state.document(), &Document::changed, this, &CanvasList::refresh);
    refresh();
}

QToolButton *CanvasList::button(const QString &iconName, const QString &name, const QString &teaches)
{
    auto *button = new QToolButton;
    button->setIcon(icon(iconName));
    button->setAccessibleName(name);
    button->setToolTip(QStringLiteral("%1. %2").arg(name, teaches));
    button->setAutoRaise(true);
    return button;
}

void CanvasList::removeChosen()
{
    if (mState.chosenCanvas())
        mState.document().edit(tr("Take canvas away"),
                               withoutCanvas(mState.document().scene(), mState.chosen()));
}

void CanvasList::duplicateChosen()
{
    const Canvas *canvas = mState.chosenCanvas();
    if (!canvas)
        return;
    Canvas copy = *canvas;
    copy.name = tr("%1 copy").arg(QString::fromStdString(canvas->name)).toStdString();
    const std::shared_ptr<const Shot> shot = mState.document().sceneShot();
    for (CanvasKeyframe &key : copy.keyframes.positions)
        key.pixel += Vec2(0.04 * shot->width, 0.04 * shot->height);
    if (mState.document().edit(tr("Duplicate canvas"),
                               withCanvas(mState.document().scene(), std::move(copy))))
        mState.choose(mState.document().scene().canvases.back().id);
}

void CanvasList::refresh()
{
    mIsRefreshing = true;
    const auto &canvases = mState.document().scene().canvases;
    while (mList->count() > int(canvases.size()))
        delete mList->takeItem(mList->count() - 1);
    while (mList->count() < int(canvases.size()))
        mList->addItem(new QListWidgetItem);
    for (int i = 0; i < mList->count(); ++i) {
        const Canvas &canvas = canvases[canvases.size() - 1 - std::size_t(i)];
        QListWidgetItem *item = mList->item(i);
        item->setText(QString::fromStdString(canvas.name));
        item->setData(Qt::UserRole, canvas.id.value);
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable |
                       Qt::ItemIsUserCheckable);
        item->setCheckState(canvas.isVisible ? Qt::Checked : Qt::Unchecked);
        QPixmap swatch(12, 12);
        swatch.fill(canvasColour(canvas.id));
        item->setIcon(swatch);
        if (canvas.id == mState.chosen())
            mList->setCurrentItem(item);
    }
    if (!mState.chosenCanvas())
        mList->setCurrentItem(nullptr);
    mIsRefreshing = false;
}

} // namespace ductus
