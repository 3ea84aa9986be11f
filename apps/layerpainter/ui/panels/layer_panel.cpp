#include "layerpainter/ui/panels/layer_panel.h"

#include "document/commands/change_value.h"
#include "layerpainter/document/default_view.h"
#include "layerpainter/ui/panels/blend_names.h"
#include "layerpainter/ui/panels/mask_list.h"
#include "widgets/controls/number_slider.h"
#include "widgets/theme/icons.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <QVBoxLayout>

namespace ductus {

namespace {
constexpr std::size_t fewLayers = 20; // are found by looking
}

LayerPanel::LayerPanel(PaintingDocument &document, QWidget *parent)
    : QWidget(parent), mDocument(document), mTree(new LayerTree(document))
{
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    mFind = new QLineEdit;
    mFind->setPlaceholderText(tr("Find layers"));
    mFind->setAccessibleName(tr("Find layers"));
    mFind->setClearButtonEnabled(true);
    mFind->addAction(icon(QStringLiteral("edit-find")), QLineEdit::LeadingPosition);
    connect(mFind, &QLineEdit::textChanged, mTree, &LayerTree::setFilter);
    layout->addWidget(mFind);
    layout->addWidget(mTree);
    auto *buttons = new QHBoxLayout;
    buttons->setSpacing(4);
    QToolButton *stack = button(QStringLiteral("stack"), tr("Add stack"),
                                tr("A new shape to paint on, with layers of its own."));
    QToolButton *layer = button(QStringLiteral("appearance-layer"), tr("Add layer"),
                                tr("Its strokes colour the shape below them."));
    QToolButton *copy = button(QStringLiteral("edit-copy"), tr("Duplicate layer"),
                               tr("A copy with all strokes, right above."));
    QToolButton *remove =
        button(QStringLiteral("edit-delete"), tr("Delete layer"), tr("Undo brings it back."));
    connect(stack, &QToolButton::clicked, this, &LayerPanel::addStack);
    connect(layer, &QToolButton::clicked, this, &LayerPanel::addLayer);
    connect(copy, &QToolButton::clicked, this, &LayerPanel::duplicateLayer);
    connect(remove, &QToolButton::clicked, this, &LayerPanel::removeLayer);
    for (QToolButton *each : {stack, layer, copy})
        buttons->addWidget(each);
    buttons->addStretch();
    buttons->addWidget(remove);
    layout->addLayout(buttons);
    buildProperties(layout);
    connect(mTree, &LayerTree::layerChosen, this, [this] { refresh(); });
    connect(&mDocument, &Document::changed, this, [this] { refresh(); });
    refresh();
}

QToolButton *LayerPanel::button(const QString &iconName, const QString &name, const QString &teaches)
{
    auto *made = new QToolButton;
    made->setIcon(icon(iconName));
    made->setIconSize({20, 20});
    made->setAutoRaise(true);
    made->setAccessibleName(name);
    made->setToolTip(QStringLiteral("<b>%1</b><br>%2").arg(name, teaches));
    return made;
}

void LayerPanel::buildProperties(QVBoxLayout *layout)
{
    NumberRange percent{0, 100, 1, 100, 0, tr("%")};
    mOpacity = new NumberSlider(tr("Opacity"), percent, tr("How strongly the layer shows."));
    layout->addWidget(mOpacity);
    mAppearance = new QWidget;
    auto *rows = new QVBoxLayout(mAppearance);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(8);
    auto *blendRow = new QHBoxLayout;
    auto *blendLabel = new QLabel(tr("Blend"));
    mBlend = new QComboBox;
    mBlend->setAccessibleName(tr("Blend mode"));
    mBlend->setToolTip(tr(
        "How its colour is mixed with what is below: Multiply darkens, Screen lightens, Overlay does both."));
    for (int i = 0; i < blendModeCount; ++i)
        mBlend->addItem(blendText(BlendMode(i)));
    blendRow->addWidget(blendLabel);
    blendRow->addWidget(mBlend, 1);
    rows->addLayout(blendRow);
    mTolerance = new NumberSlider(
        tr("Reach"), {0, 1, 0.01, 0, 3, {}},
        tr("Tolerance: how far from its strokes the layer still colours. 0: only inside them."));
    rows->addWidget(mTolerance);
    mMasks = new MaskList(mDocument);
    rows->addWidget(mMasks);
    layout->addWidget(mAppearance);

    for (NumberSlider *slider : {mOpacity, mTolerance})
        connect(slider, &NumberSlider::editBegun, this, [this] { mDrag = nextDrag(); });
    connect(mOpacity, &NumberSlider::valueChanged, this, [this](double value) {
        act::SetProperties edit;
        edit.layer = mTree->currentLayer();
        edit.opacity = value / 100;
        (void)mDocument.perform(edit, mDrag);
    });
    connect(mTolerance, &NumberSlider::valueChanged, this, [this](double value) {
        if (const Layer *layer = mDocument.painting().findLayer(mTree->currentLayer()))
            (void)mDocument.perform(act::SetTolerance{layer->id, value, layer->toleranceMode}, mDrag);
    });
    connect(mBlend, &QComboBox::activated, this, [this](int index) {
        act::SetProperties edit;
        edit.layer = mTree->currentLayer();
        edit.blend = BlendMode(index);
        (void)mDocument.perform(edit);
    });
}

void LayerPanel::refresh()
{
    const LayerId id = mTree->currentLayer();
    const Layer *layer = mDocument.painting().findLayer(id);
    const bool isAppearance = layer && !isSubstrate(mDocument.painting(), id);
    mOpacity->setEnabled(layer);
    mAppearance->setVisible(isAppearance);
    mFind->setVisible(mDocument.painting().layers().size() > fewLayers || !mFind->text().isEmpty());
    if (!layer)
        return;
    mOpacity->setValue(100 * layer->properties.opacity);
    if (!isAppearance)
        return;
    mBlend->setCurrentIndex(int(layer->properties.blendMode));
    const double most =
        std::max({0.1 * paintingBox(mDocument.painting()).diagonal(), 2 * layer->tolerance, 0.01});
    if (layer->tolerance > mTolerance->range().maximum || mTolerance->range().maximum > 4 * most ||
        mTolerance->range().maximum < 0.25 * most)
        mTolerance->setRange({0, most, most / 100, 0, decimalsFor(0.1 * most), {}});
    mTolerance->setValue(layer->tolerance);
    mMasks->setLayer(id);
}

void LayerPanel::addStack()
{
    mFind->clear(); // what is new is not to be hidden at once
    const auto made = mDocument.perform(
        act::AddStack{tr("Stack %1").arg(mDocument.painting().stacks.size() + 1).toStdString()});
    if (made)
        mTree->choose(LayerId{made->at(1)});
}

void LayerPanel::addLayer()
{
    const StackId stack = mTree->currentStack();
    const Stack *found = mDocument.painting().findStack(stack);
    if (!found)
        return;
    mFind->clear();
    const auto made = mDocument.perform(
        act::AddLayer{stack, tr("Layer %1").arg(found->appearance.size() + 1).toStdString()});
    if (made)
        mTree->choose(LayerId{made->at(0)});
}

void LayerPanel::duplicateLayer()
{
    mFind->clear();
    if (const Layer *layer = mDocument.painting().findLayer(mTree->currentLayer()))
        (void)mDocument.perform(act::DuplicateLayer{
            layer->id, tr("%1 copy").arg(QString::fromStdString(layer->name)).toStdString()});
}

void LayerPanel::removeLayer()
{
    const LayerId layer = mTree->currentLayer();
    if (isSubstrate(mDocument.painting(), layer))
        (void)mDocument.perform(act::RemoveStack{mTree->currentStack()});
    else if (layer.isValid())
        (void)mDocument.perform(act::RemoveLayer{layer});
}

} // namespace ductus
