#include "layerpainter/ui/panels/mask_list.h"

#include "document/commands/change_value.h"
#include "layerpainter/document/default_view.h"
#include "layerpainter/document/texture_block.h"
#include "widgets/controls/number_slider.h"
#include "widgets/theme/icons.h"

#include <QFileDialog>
#include <QGuiApplication>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

namespace ductus {

namespace {

QString maskText(const Painting &painting, const Mask &mask)
{
    switch (mask.shape.index()) {
    case 0:
        return std::get<GradientMask>(mask.shape).shape == GradientMask::Shape::Linear
                   ? MaskList::tr("Gradient")
                   : MaskList::tr("Round gradient");
    case 1:
        return MaskList::tr("Noise");
    case 2:
        return MaskList::tr("Texture");
    default: {
        const StrokeMask &strokes = std::get<StrokeMask>(mask.shape);
        const Layer *other = painting.findLayer(strokes.layer);
        const QString name = other ? QString::fromStdString(other->name) : QString();
        return strokes.inside ? MaskList::tr("Inside %1").arg(name) : MaskList::tr("Outside %1").arg(name);
    }
    }
}

} // namespace

MaskList::MaskList(PaintingDocument &document, QWidget *parent) : QWidget(parent), mDocument(document)
{
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    mRows = new QVBoxLayout;
    mRows->setSpacing(4);
    layout->addLayout(mRows);
    auto *add = new QToolButton;
    add->setText(tr("Add mask"));
    add->setAccessibleName(tr("Add mask"));
    add->setIcon(icon(QStringLiteral("list-add")));
    add->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    add->setToolTip(tr("<b>Add mask</b><br>Masks weaken the layer in places; gradients are drawn with the "
                       "gradient tool (D)."));
    add->setPopupMode(QToolButton::InstantPopup);
    auto *menu = new QMenu(add);
    add->setMenu(menu);
    connect(menu, &QMenu::aboutToShow, this, [this, menu] { fillMenu(*menu); });
    layout->addWidget(add, 0, Qt::AlignLeft);
}

void MaskList::setLayer(LayerId layer)
{
    const bool isOther = !(layer == mLayer);
    mLayer = layer;
    std::vector<std::size_t> kinds;
    if (const auto now = masks())
        for (const Mask &mask : *now)
            kinds.push_back(mask.shape.index());
    if (mDrag == 0 || isOther || kinds != mShown) {
        mShown = std::move(kinds);
        refresh();
    }
}

std::optional<std::vector<Mask>> MaskList::masks() const
{
    const Layer *layer = mDocument.painting().findLayer(mLayer);
    return layer ? std::optional(layer->properties.masks) : std::nullopt;
}

void MaskList::perform(std::vector<Mask> masks, quint64 drag)
{
    act::SetProperties edit;
    edit.layer = mLayer;
    edit.masks = std::move(masks);
    (void)mDocument.perform(edit, drag);
}

void MaskList::refresh()
{
    while (QLayoutItem *item = mRows->takeAt(0)) {
        if (item->widget()) {
            item->widget()->hide(); // it stays where it was until the event loop comes by
            item->widget()->deleteLater();
        }
        delete item;
    }
    const auto now = masks();
    for (std::size_t i = 0; now && i < now->size(); ++i) {
        addChip(i, (*now)[i]);
        if (const auto *noise = std::get_if<NoiseMask>(&(*now)[i].shape))
            addNoiseSliders(i, *noise);
    }
}

void MaskList::addChip(std::size_t index, const Mask &mask)
{
    auto *chip = new QToolButton;
    chip->setText(maskText(mDocument.painting(), mask) + (mask.inverted ? tr(", inside out") : QString()));
    chip->setIcon(icon(QStringLiteral("gradient")));
    chip->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    chip->setCheckable(true);
    chip->setChecked(mask.enabled);
    chip->setToolTip(tr("Mask of the layer. Click: on and off. With Shift: inside out. With Ctrl: remove."));
    connect(chip, &QToolButton::clicked, this, [this, index] {
        auto now = masks();
        if (!now || index >= now->size())
            return;
        const Qt::KeyboardModifiers keys = QGuiApplication::keyboardModifiers();
        if (keys & Qt::ControlModifier)
            now->erase(now->begin() + std::ptrdiff_t(index));
        else if (keys & Qt::ShiftModifier)
            (*now)[index].inverted = !(*now)[index].inverted;
        else
            (*now)[index].enabled = !(*now)[index].enabled;
        perform(std::move(*now));
    });
    mRows->addWidget(chip, 0, Qt::AlignLeft);
}

void MaskList::addNoiseSliders(std::size_t index, const NoiseMask &noise)
{
    const auto slider = [&](const QString &label, const NumberRange &range, const QString &teaches,
                            double value, double NoiseMask::*member) {
        auto *made = new NumberSlider(label, range, teaches);
        made->setValue(value);
        connect(made, &NumberSlider::editBegun, this, [this] { mDrag = nextDrag(); });
        connect(made, &NumberSlider::editEnded, this, [this] { mDrag = 0; });
        connect(made, &NumberSlider::valueChanged, this, [this, index, member](double changed) {
            auto now = masks();
            if (!now || index >= now->size() || !std::holds_alternative<NoiseMask>((*now)[index].shape))
                return;
            std::get<NoiseMask>((*now)[index].shape).*member = changed;
            perform(std::move(*now), mDrag);
        });
        mRows->addWidget(made);
    };
    const double size = std::max(noise.cellSize, 1e-6);
    slider(tr("Grain"), {size / 20, size * 20, size / 20, size, 3, {}, true},
           tr("How large the spots of the noise are, in the painting's unit."), size, &NoiseMask::cellSize);
    slider(tr("Amount"), {0, 1, 0.01, 0.5, 2, {}},
           tr("Where the noise begins to show: 0 everywhere, 1 nowhere."), noise.threshold,
           &NoiseMask::threshold);
    slider(tr("Softness"), {0, 1, 0.01, 0.1, 2, {}}, tr("How soft the borders of the spots are."),
           noise.softness, &NoiseMask::softness);
}

void MaskList::fillMenu(QMenu &menu)
{
    menu.clear();
    menu.addAction(tr("Noise"), this, &MaskList::addNoise);
    menu.addAction(tr("Texture from pictures..."), this, &MaskList::chooseTexture);
    for (const bool inside : {true, false}) {
        QMenu *layers = menu.addMenu(inside ? tr("Inside strokes of") : tr("Outside strokes of"));
        for (const Layer *layer : mDocument.painting().layers())
            if (!(layer->id == mLayer))
                layers->addAction(QString::fromStdString(layer->name), this,
                                  [this, id = layer->id, inside] { addStrokes(id, inside); });
        layers->setEnabled(!layers->isEmpty());
    }
}

void MaskList::addNoise()
{
    auto now = masks();
    if (!now)
        return;
    NoiseMask noise;
    const double diagonal = paintingBox(mDocument.painting()).diagonal();
    noise.cellSize = diagonal > 0 ? 0.02 * diagonal : 0.1;
    noise.seed = now->size() + 1;
    now->push_back({true, false, noise});
    perform(std::move(*now));
}

void MaskList::chooseTexture()
{
    const QStringList pictures = QFileDialog::getOpenFileNames(
        this, tr("Slices of a texture, or one picture"), {}, tr("Pictures (*.png *.jpg *.jpeg)"));
    if (!pictures.isEmpty())
        addTexture(pictures);
}

void MaskList::addTexture(const QStringList &pictures)
{
    auto now = masks();
    if (!now)
        return;
    const Result<TextureMask> texture = textureFromPictures(pictures, paintingBox(mDocument.painting()));
    if (!texture) {
        emit mDocument.refused(texture.error());
        return;
    }
    now->push_back({true, false, *texture});
    perform(std::move(*now));
}

void MaskList::addStrokes(LayerId other, bool inside)
{
    auto now = masks();
    if (!now)
        return;
    now->push_back({true, false, StrokeMask{other, inside}});
    perform(std::move(*now));
}

} // namespace ductus
