#include "sketchsurfacer/ui/window/measures_panel.h"

#include "sketchsurfacer/ui/viewport/length_text.h"
#include "surfacing/sketch/point_cloud.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <cmath>

namespace ductus {

namespace {

struct Unit
{
    const char *name;
    double metres;
};

constexpr Unit units[] = {{QT_TRANSLATE_NOOP("ductus::MeasuresPanel", "metre"), 1.0},
                          {QT_TRANSLATE_NOOP("ductus::MeasuresPanel", "decimetre"), 0.1},
                          {QT_TRANSLATE_NOOP("ductus::MeasuresPanel", "centimetre"), 0.01},
                          {QT_TRANSLATE_NOOP("ductus::MeasuresPanel", "millimetre"), 0.001},
                          {QT_TRANSLATE_NOOP("ductus::MeasuresPanel", "inch"), 0.0254},
                          {QT_TRANSLATE_NOOP("ductus::MeasuresPanel", "foot"), 0.3048}};

// All three in the unit of the largest: "51.6 × 31.3 × 37.8 cm".
QString sizeText(const Vec3 &metres, const QLocale &locale)
{
    const QString largest = lengthText(metres.maxCoeff(), locale);
    const QString unit = largest.mid(largest.indexOf(QChar(0x00a0)));
    const double size = unit.endsWith(QLatin1String("mm"))   ? 0.001
                        : unit.endsWith(QLatin1String("cm")) ? 0.01
                        : unit.endsWith(QLatin1String("km")) ? 1000.0
                                                             : 1.0;
    QStringList numbers;
    for (int axis = 0; axis < 3; ++axis)
        numbers << locale.toString(metres[axis] / size, 'g', 3);
    return numbers.join(QStringLiteral(" × ")) + unit;
}

QLabel *valueLabel()
{
    auto *label = new QLabel(QStringLiteral("–"));
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    label->setSizePolicy(QSizePolicy::Ignored,
                         QSizePolicy::Preferred); // the inspector's width, not the number's
    return label;
}

} // namespace

MeasuresPanel::MeasuresPanel(SketchDocument &document, QWidget *parent) : QWidget(parent), mDocument(document)
{
    auto *form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    form->setVerticalSpacing(6);
    mSize = valueLabel();
    mStrokes = valueLabel();
    mArea = valueLabel();
    mVolume = valueLabel();
    mWatertight = valueLabel();
    mDeviation = valueLabel();
    mDeviation->setToolTip(
        tr("Half of the strokes' points lie nearer to the surface than this; in brackets: 95 %."));
    mUnit = new QComboBox;
    mUnit->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    mUnit->setMinimumContentsLength(6);
    mUnit->setAccessibleName(tr("Unit of the sketch"));
    mUnit->setToolTip(tr("What the number 1 of the sketch's file means. Nothing is scaled."));
    for (const Unit &unit : units)
        mUnit->addItem(tr(unit.name), unit.metres);
    mUp = new QComboBox;
    mUp->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    mUp->setMinimumContentsLength(6);
    mUp->setAccessibleName(tr("Up axis"));
    mUp->addItems({tr("y is up"), tr("z is up")});
    form->addRow(tr("Size"), mSize);
    form->addRow(tr("Strokes"), mStrokes);
    form->addRow(tr("Off the strokes"), mDeviation);
    form->addRow(tr("Area"), mArea);
    form->addRow(tr("Volume"), mVolume);
    form->addRow(tr("Watertight"), mWatertight);
    form->addRow(tr("&One unit is a"), mUnit);
    form->addRow(tr("Ax&es"), mUp);
    const auto setUnit = [this] {
        mDocument.setUnit(mUnit->currentData().toDouble(), mUp->currentIndex() == 1 ? UpAxis::Z : UpAxis::Y);
    };
    connect(mUnit, &QComboBox::activated, this, setUnit);
    connect(mUp, &QComboBox::activated, this, setUnit);
    connect(&document, &Document::changed, this, &MeasuresPanel::refresh);
    refresh();
}

void MeasuresPanel::setResult(const std::shared_ptr<const ResultView> &view)
{
    mResult = view && !view->isPreview ? view : nullptr;
    refresh();
}

void MeasuresPanel::refresh()
{
    const StrokeSet &strokes = mDocument.strokes();
    const double metres = strokes.metresPerUnit;
    const QString none = QStringLiteral("–");
    const SurfaceResult *surface = mResult ? mResult->state->surface.get() : nullptr;
    const Box3 box = surface ? boundingBox(surface->mesh.vertices) : strokes.box();
    if (box.isEmpty()) {
        mSize->setText(none);
    } else {
        const Vec3 size = metres * (box.max - box.min);
        mSize->setText(sizeText(size, locale()));
    }
    const int count = int(strokes.strokes.size());
    mStrokes->setText(isPointCloud(strokes) ? tr("%n points", nullptr, count) : locale().toString(count));
    mArea->setText(surface ? areaText(surfaceArea(surface->mesh) * metres * metres, locale()) : none);
    mWatertight->setText(!surface ? none : mResult->isClosed ? tr("yes") : tr("no, it has a border"));
    const double litres =
        surface && mResult->isClosed ? std::abs(signedVolume(surface->mesh)) * std::pow(metres, 3) * 1000 : 0;
    mVolume->setText(litres <= 0.0  ? none
                     : litres < 0.1 ? tr("%1 cm³").arg(locale().toString(litres * 1000, 'g', 3))
                     : litres < 500 ? tr("%1 l").arg(locale().toString(litres, 'g', 3))
                                    : tr("%1 m³").arg(locale().toString(litres / 1000, 'g', 3)));
    const double diagonal = strokes.box().diagonal() * metres;
    mDeviation->setText(
        surface && surface->deviation.max > 0.0
            ? QStringLiteral("%1 (%2)").arg(lengthText(surface->deviation.median * diagonal, locale()),
                                            lengthText(surface->deviation.p95 * diagonal, locale()))
            : none);
    for (int i = 0; i < mUnit->count(); ++i)
        if (std::abs(mUnit->itemData(i).toDouble() / metres - 1.0) < 1e-6)
            mUnit->setCurrentIndex(i);
    mUp->setCurrentIndex(strokes.upAxis == UpAxis::Z ? 1 : 0);
}

} // namespace ductus
