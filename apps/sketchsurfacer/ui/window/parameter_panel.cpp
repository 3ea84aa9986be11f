#include "sketchsurfacer/ui/window/parameter_panel.h"

#include "document/commands/change_value.h"
#include "sketchsurfacer/ui/viewport/length_text.h"
#include "widgets/controls/number_slider.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <cmath>

namespace ductus {

namespace {

constexpr double defaultSimplicity = 0.01; // w_simplicity, Sec. III.5.2
constexpr double defaultTightness = 0.5;

enum SymmetryChoice { NoSymmetry, AutoSymmetry, MirrorX, MirrorY, MirrorZ, OtherPlane };

std::optional<int> axisOf(const SymmetryPlane &plane)
{
    for (int axis = 0; axis < 3; ++axis)
        if (std::abs(std::abs(plane.normal[axis]) - 1.0) < 1e-9)
            return axis;
    return std::nullopt;
}

} // namespace

ParameterPanel::ParameterPanel(SketchDocument &document, QWidget *parent)
    : QWidget(parent), mDocument(document)
{
    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(8);

    mTightness =
        new NumberSlider(tr("Tightness"), {0.0, 100.0, 5.0, 100.0 * defaultTightness, 0, tr("%")},
                         tr("How closely the first rough skin (the proxy) wraps the strokes: tight finds "
                            "handles and holes, loose bridges gaps. Technically: alpha of the wrap."));
    mTightness->setEnds(tr("loose"), tr("tight"));
    mAutoTightness = new QCheckBox(tr("Choose tightness by itself"));
    mAutoTightness->setToolTip(tr("Takes the tightest skin that does not fall in between the strokes."));
    mLooseness = new NumberSlider(
        tr("Looseness"), {0.1, 5.0, 0.1, 1.0, 2, tr("%"), true},
        tr("How far the surface may stay away from the strokes. Raise it for wobbly sketches. "
           "Technically: epsilon, in percent of the sketch's diagonal."));
    mLooseness->setEnds(tr("exact"), tr("loose"));
    mSimplicity =
        new NumberSlider(tr("Simplicity"), {0.05, 20.0, 0.1, 1.0, 2, QStringLiteral("×"), true},
                         tr("How much few and simple surfaces are preferred to many. Technically: the weight "
                            "of the label costs, w_simplicity, as a multiple of its default."));
    mSimplicity->setEnds(tr("detailed"), tr("simple"));
    rows->addWidget(mTightness);
    rows->addWidget(mAutoTightness);
    rows->addWidget(mLooseness);
    rows->addWidget(mSimplicity);

    mSymmetry = new QComboBox;
    mSymmetry->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    mSymmetry->setMinimumContentsLength(6);
    mSymmetry->setAccessibleName(tr("Symmetry"));
    mSymmetry->setToolTip(tr("Only one half is solved and mirrored, welded exactly in the plane."));
    mSymmetry->addItems(
        {tr("None"), tr("Find it"), tr("Mirror left–right (x)"), tr("Mirror along y"), tr("Mirror along z")});
    auto *row = new QHBoxLayout;
    auto *label = new QLabel(tr("S&ymmetry"));
    label->setBuddy(mSymmetry);
    row->addWidget(label);
    row->addWidget(mSymmetry, 1);
    rows->addLayout(row);
    mSymmetryFound = new QLabel;
    mSymmetryFound->setProperty("dim", true);
    mSymmetryFound->setWordWrap(true);
    rows->addWidget(mSymmetryFound);

    for (NumberSlider *slider : {mTightness, mLooseness, mSimplicity}) {
        connect(slider, &NumberSlider::editBegun, this, [this] { mDrag = nextDrag(); });
        connect(slider, &NumberSlider::editEnded, this, [this] { mDrag = 0; });
    }
    connect(mTightness, &NumberSlider::valueChanged, this, [this](double percent) {
        SurfaceOptions options = mDocument.content().options;
        options.proxy.wrap.tightness = percent / 100.0;
        edit(tr("Change tightness"), options);
    });
    connect(mAutoTightness, &QCheckBox::toggled, this, [this](bool on) {
        SurfaceOptions options = mDocument.content().options;
        options.proxy.wrap.tightness = on ? -1.0 : mTightness->value() / 100.0;
        edit(tr("Change tightness"), options);
    });
    connect(mLooseness, &NumberSlider::valueChanged, this, [this](double percent) {
        SurfaceOptions options = mDocument.content().options;
        options.segmentation.epsilon = percent / 100.0;
        edit(tr("Change looseness"), options);
    });
    connect(mSimplicity, &NumberSlider::valueChanged, this, [this](double factor) {
        SurfaceOptions options = mDocument.content().options;
        options.segmentation.simplicity = factor * defaultSimplicity;
        edit(tr("Change simplicity"), options);
    });
    connect(mSymmetry, &QComboBox::activated, this, &ParameterPanel::chooseSymmetry);
    connect(&mDocument, &Document::changed, this, &ParameterPanel::refresh);
    refresh();
}

void ParameterPanel::edit(const QString &text, const SurfaceOptions &options)
{
    if (!mIsRefreshing)
        mDocument.setOptions(text, options, mDrag);
}

void ParameterPanel::chooseSymmetry(int index)
{
    SurfaceOptions options = mDocument.content().options;
    if (index == NoSymmetry || index == AutoSymmetry) {
        options.symmetry = index == AutoSymmetry ? SymmetryMode::Auto : SymmetryMode::None;
    } else if (index != OtherPlane) {
        options.symmetry = SymmetryMode::Given;
        const int axis = index - MirrorX;
        options.symmetryPlane.normal = Vec3::Unit(axis);
        options.symmetryPlane.offset = mDocument.strokes().box().centre()[axis];
        // Drawn about the origin, as most programs do: their plane, not the middle of what was drawn.
        if (std::abs(options.symmetryPlane.offset) < 0.02 * mDocument.strokes().box().diagonal())
            options.symmetryPlane.offset = 0.0;
    }
    edit(tr("Change symmetry"), options);
}

void ParameterPanel::refresh()
{
    mIsRefreshing = true;
    const SurfaceOptions &options = mDocument.content().options;
    const double tightness = options.proxy.wrap.tightness;
    mAutoTightness->setChecked(tightness < 0.0);
    mTightness->setValue(100.0 * (tightness < 0.0 ? defaultTightness : tightness));
    mLooseness->setValue(100.0 * options.segmentation.epsilon);
    mSimplicity->setValue(options.segmentation.simplicity / defaultSimplicity);

    int choice = options.symmetry == SymmetryMode::Auto ? AutoSymmetry : NoSymmetry;
    QString found;
    if (options.symmetry == SymmetryMode::Given) {
        const std::optional<int> axis = axisOf(options.symmetryPlane);
        choice = axis ? MirrorX + *axis : OtherPlane;
    } else if (options.symmetry == SymmetryMode::Auto) {
        if (const auto state = mDocument.shownResult(); state && state->surface) {
            const auto &symmetry = state->surface->symmetry;
            found =
                symmetry
                    ? tr("Found: %1 % of the strokes mirror, %2 apart.")
                          .arg(qRound(100 * symmetry->matchedShare))
                          .arg(lengthText(symmetry->residual * mDocument.strokes().metresPerUnit, locale()))
                    : tr("None was found.");
        }
    }
    while (mSymmetry->count() > OtherPlane)
        mSymmetry->removeItem(OtherPlane);
    if (choice == OtherPlane)
        mSymmetry->addItem(tr("A plane of its own"));
    mSymmetry->setCurrentIndex(choice);
    mSymmetryFound->setText(found);
    mSymmetryFound->setVisible(!found.isEmpty());
    mIsRefreshing = false;
}

} // namespace ductus
