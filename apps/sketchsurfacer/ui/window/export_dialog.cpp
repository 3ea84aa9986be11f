#include "sketchsurfacer/ui/window/export_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace ductus {

namespace {

struct Format
{
    const char *extension;
    const char *name;
    bool hasRegions, hasCreases;
    double bytesPerVertex, bytesPerTriangle; // rough, for the preview of the size
};

constexpr Format formats[] = {
    {".obj", QT_TRANSLATE_NOOP("ductus::ExportDialog", "OBJ - with regions as groups"), true, true, 58, 21},
    {".ply", QT_TRANSLATE_NOOP("ductus::ExportDialog", "PLY - with region numbers"), true, false, 24, 17},
    {".stl", QT_TRANSLATE_NOOP("ductus::ExportDialog", "STL - for printing"), false, false, 0, 50},
    {".glb", QT_TRANSLATE_NOOP("ductus::ExportDialog", "GLB - for the web and game engines"), true, false, 24,
     12},
    {".off", QT_TRANSLATE_NOOP("ductus::ExportDialog", "OFF - plain"), false, false, 55, 20}};

} // namespace

MeshFileContent exportContent(const SurfaceResult &surface, const StrokeSet &sketch,
                              const ExportChoice &choice)
{
    const bool isGlb = choice.extension == QLatin1String(".glb");
    const double scale = sketch.metresPerUnit / (isGlb ? 1.0 : choice.metresPerExportUnit);
    MeshFileContent content;
    content.mesh = surface.mesh;
    for (Vec3 &p : content.mesh.vertices) {
        p *= scale;
        if (isGlb && sketch.upAxis == UpAxis::Z)
            p = Vec3(p.x(), p.z(), -p.y());
    }
    if (choice.withRegions)
        content.triangleRegions = surface.triangleRegions;
    if (choice.withCreases)
        content.featureLines = surface.featureLines;
    content.comment = "SketchSurfacer";
    return content;
}

ExportDialog::ExportDialog(std::shared_ptr<const SurfaceResult> surface, const StrokeSet &sketch,
                           const ExportChoice &before, QWidget *parent)
    : QDialog(parent), mSurface(std::move(surface))
{
    mSketch.metresPerUnit = sketch.metresPerUnit;
    mSketch.upAxis = sketch.upAxis;
    setWindowTitle(tr("Export surface"));
    auto *rows = new QVBoxLayout(this);
    auto *form = new QFormLayout;
    rows->addLayout(form);
    mFormat = new QComboBox;
    mFormat->setAccessibleName(tr("Format"));
    for (const Format &format : formats) {
        mFormat->addItem(tr(format.name), QString::fromLatin1(format.extension));
        if (before.extension == QLatin1String(format.extension))
            mFormat->setCurrentIndex(mFormat->count() - 1);
    }
    mUnit = new QComboBox;
    mUnit->setAccessibleName(tr("Unit"));
    const std::pair<QString, double> units[] = {
        {tr("millimetres"), 0.001}, {tr("centimetres"), 0.01}, {tr("metres"), 1.0}, {tr("inches"), 0.0254}};
    for (const auto &[name, metres] : units) {
        mUnit->addItem(name, metres);
        if (metres == before.metresPerExportUnit)
            mUnit->setCurrentIndex(mUnit->count() - 1);
    }
    mRegions = new QCheckBox(tr("Keep &regions apart"));
    mRegions->setChecked(before.withRegions);
    mCreases = new QCheckBox(tr("Add &creases as lines"));
    mCreases->setChecked(before.withCreases);
    mSize = new QLabel;
    mSize->setProperty("dim", true);
    mSize->setWordWrap(true);
    form->addRow(tr("&Format"), mFormat);
    form->addRow(tr("&Unit"), mUnit);
    form->addRow(QString(), mRegions);
    form->addRow(QString(), mCreases);
    rows->addWidget(mSize);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    auto *go = buttons->addButton(tr("&Export..."), QDialogButtonBox::AcceptRole);
    go->setProperty("primary", true);
    go->setDefault(true);
    rows->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(mFormat, &QComboBox::currentIndexChanged, this, &ExportDialog::refresh);
    connect(mUnit, &QComboBox::currentIndexChanged, this, &ExportDialog::refresh);
    refresh();
}

ExportChoice ExportDialog::choice() const
{
    const Format &format = formats[mFormat->currentIndex()];
    return {QString::fromLatin1(format.extension), mUnit->currentData().toDouble(),
            format.hasRegions && mRegions->isChecked(), format.hasCreases && mCreases->isChecked()};
}

void ExportDialog::refresh()
{
    const Format &format = formats[mFormat->currentIndex()];
    const bool isGlb = QLatin1String(format.extension) == QLatin1String(".glb");
    mRegions->setEnabled(format.hasRegions);
    mCreases->setEnabled(format.hasCreases);
    mUnit->setEnabled(!isGlb);
    mUnit->setToolTip(isGlb ? tr("GLB is always in metres.") : QString());
    const Box3 box = boundingBox(mSurface->mesh.vertices);
    const Vec3 size =
        (box.max - box.min) * mSketch.metresPerUnit / (isGlb ? 1.0 : mUnit->currentData().toDouble());
    const auto number = [this](double x) { return locale().toString(x, 'g', 4); };
    const double bytes = format.bytesPerVertex * mSurface->mesh.vertexCount() +
                         format.bytesPerTriangle * mSurface->mesh.triangleCount();
    mSize->setText(
        tr("%1 × %2 × %3 in the file, %4 triangles, about %5")
            .arg(number(size.x()), number(size.y()), number(size.z()),
                 locale().toString(mSurface->mesh.triangleCount()),
                 locale().formattedDataSize(qint64(bytes), 1, QLocale::DataSizeTraditionalFormat)));
}

} // namespace ductus
