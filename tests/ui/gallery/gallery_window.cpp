#include "ui/gallery/gallery_window.h"

#include "document/commands/change_value.h"
#include "ui/gallery/gallery_canvas.h"
#include "widgets/controls/folding_section.h"
#include "widgets/controls/number_slider.h"
#include "widgets/controls/segmented_switch.h"
#include "widgets/pages/start_page.h"
#include "widgets/shell/message_bar.h"
#include "widgets/theme/icons.h"

#include <QActionGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QThread>
#include <QVBoxLayout>

namespace ductus {

AppIdentity galleryIdentity(AppKind kind)
{
    switch (kind) {
    case AppKind::SketchSurfacer:
        return {"SketchSurfacer", kind, "app-sketchsurfacer"};
    case AppKind::LayerPainter:
        return {"LayerPainter", kind, "app-layerpainter"};
    case AppKind::DoodleStudio:
        return {"DoodleStudio", kind, "app-doodlestudio"};
    }
    return {};
}

GalleryWindow::GalleryWindow(AppKind kind, const ShellServices &services)
    : MainWindowShell(galleryIdentity(kind), services)
{
    addActions();
    mViews =
        new SegmentedSwitch(tr("View"), {{tr("Sketch"), tr("The strokes as they were drawn.")},
                                         {tr("Proxy"), tr("The rough skin around the strokes.")},
                                         {tr("Regions"), tr("Which patch each part belongs to.")},
                                         {tr("Surface"), tr("The result.")},
                                         {tr("Deviation"), tr("How far the strokes are from the surface.")}});
    setCentre(mViews);
    setCanvas(new GalleryCanvas);
    fillInspector();
    fillStrip();
    fillStartPage();
    setHint(tr("Drag to turn, Shift-drag to move, wheel to zoom. Click a stroke to select it."));
    setDocument(&mDocument);
}

void GalleryWindow::addActions()
{
    ActionCatalogue &all = actions();
    const QString file = tr("File");
    addToMenu(fileMenu(), {all.add({"file.new",
                                    tr("&New"),
                                    tr("Starts with an empty sketch."),
                                    "document-new",
                                    {QKeySequence("Ctrl+N")},
                                    file},
                                   [this] { showCanvas(); }),
                           all.add({"file.open",
                                    tr("&Open..."),
                                    tr("Opens a project or a sketch of another program."),
                                    "document-open",
                                    {QKeySequence("Ctrl+O")},
                                    file}),
                           all.add({"file.save",
                                    tr("&Save"),
                                    tr("Writes the project to its file."),
                                    "document-save",
                                    {QKeySequence("Ctrl+S")},
                                    file}),
                           all.add({"file.export",
                                    tr("&Export surface..."),
                                    tr("Writes the surface for other programs."),
                                    "document-export",
                                    {QKeySequence("Ctrl+E")},
                                    file})});
    auto *group = new QActionGroup(this);
    const struct
    {
        const char *id;
        QString text, teaches, icon, key;
    } tools[] = {
        {"tool.select", tr("Select"), tr("Click a stroke; drag a box for many."), "select", "V"},
        {"tool.role", tr("Role brush"), tr("Paint over strokes to say what they are."), "role-brush", "B"},
        {"tool.draw", tr("Draw stroke"), tr("Adds a stroke on the plane you look at."), "draw-stroke", "D"},
        {"tool.newRegion", tr("New region"), tr("Draw where a patch of its own should be."), "new-region",
         "N"},
        {"tool.merge", tr("Merge regions"), tr("Draw across a border to make two patches one."), "merge",
         "M"},
        {"tool.seam", tr("Seam"), tr("Draw where the surface should have a crease."), "seam", "S"},
        {"tool.lock", tr("Lock region"), tr("Keeps a patch as it is in the next update."), "lock", "L"},
        {"tool.measure", tr("Measure"), tr("Drag from one point to another."), "measure", "R"},
    };
    for (const auto &tool : tools) {
        ActionSpec spec{tool.id, tool.text, tool.teaches, tool.icon, {QKeySequence(tool.key)}, tr("Tools")};
        spec.isCheckable = true;
        QAction *action = all.add(spec);
        group->addAction(action);
        if (spec.id == QLatin1String("tool.newRegion") || spec.id == QLatin1String("tool.lock"))
            addToolSeparator();
        addTool(action);
        menu(tr("&Tools"))->addAction(action);
    }
    all.action("tool.role")->setChecked(true);
    all.setDisabledReason("tool.lock", tr("There are no regions yet: press Surface it."));
}

void GalleryWindow::fillInspector()
{
    auto *run = new QPushButton(tr("Surface it"));
    run->setProperty("primary", true);
    run->setAccessibleName(tr("Surface it"));
    connect(run, &QPushButton::clicked, this, [this] { startJob(20.0); });
    setInspectorHead(run);

    auto *shape = new QWidget;
    auto *rows = new QVBoxLayout(shape);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(12);
    mTightness = new NumberSlider(tr("Tightness"), {0.0, 1.0, 0.01, 0.4, 2},
                                  tr("How closely the proxy follows the strokes."));
    mTightness->setEnds(tr("loose"), tr("tight"));
    auto *looseness = new NumberSlider(tr("Looseness"), {0.1, 10.0, 0.1, 1.0, 2, QStringLiteral("%"), true},
                                       tr("How far a stroke may be from its patch (epsilon)."));
    auto *simplicity = new NumberSlider(tr("Simplicity"), {0.0, 1000.0, 5.0, 50.0, 0, QStringLiteral("mm")},
                                        tr("Fewer and simpler patches (w_simplicity)."));
    rows->addWidget(mTightness);
    rows->addWidget(looseness);
    rows->addWidget(simplicity);
    connect(mTightness, &NumberSlider::editBegun, this, [this] { mDrag = nextDrag(); });
    connect(mTightness, &NumberSlider::valueChanged, this,
            [this](double value) { mDocument.changeTightness(value, mDrag); });
    connect(&mDocument, &Document::changed, this, [this] { mTightness->setValue(mDocument.tightness()); });
    addSection("shape", tr("Shape"), shape);

    auto *symmetry = new QWidget;
    auto *symmetryRows = new QVBoxLayout(symmetry);
    symmetryRows->setContentsMargins(0, 0, 0, 0);
    symmetryRows->setSpacing(8);
    auto *mirrored = new QCheckBox(tr("&Mirrored"));
    auto *plane = new QComboBox;
    plane->setAccessibleName(tr("Plane of symmetry"));
    plane->addItems({tr("Left and right (YZ)"), tr("Front and back (XZ)"), tr("Found in the sketch")});
    symmetryRows->addWidget(mirrored);
    symmetryRows->addWidget(plane);
    addSection("symmetry", tr("Symmetry"), symmetry);

    auto *empty = new QLabel(tr("The patches of the surface will be listed here."));
    empty->setProperty("dim", true);
    empty->setWordWrap(true);
    addSection("regions", tr("Regions"), empty);
}

void GalleryWindow::fillStrip()
{
    auto *strip = new QWidget;
    auto *row = new QHBoxLayout(strip);
    row->setContentsMargins(16, 8, 16, 8);
    row->setSpacing(16);
    auto *caption = new QLabel(tr("Regions"));
    caption->setProperty("caption", true);
    row->addWidget(caption);
    for (const char *words : {"plane 4", "quadric 7", "cubic 2", "quartic 1"})
        row->addWidget(new QLabel(QString::fromLatin1(words)));
    row->addStretch(1);
    setStrip(strip);
}

void GalleryWindow::fillStartPage()
{
    startPage()->setHeading(identity().name, tr("Turns the strokes of a 3D sketch into a smooth surface."));
    QList<SampleCard> samples;
    const QString picture = QStringLiteral(DUCTUS_GALLERY_PICTURE);
    for (const auto &[title, lesson] : std::initializer_list<std::pair<const char *, const char *>>{
             {"Car", "Half the strokes and mirror symmetry make the whole body."},
             {"Bottle", "Round things need few strokes."},
             {"Computer mouse", "Where two patches meet there is a crease."},
             {"Iron", "Force a seam where the sketch is silent."},
             {"Table lamp", "Strokes that are no surface can be left out."},
             {"Bevelled box", "Flat patches, and how simplicity finds them."}})
        samples.append(
            {QString::fromLatin1(title), QString::fromLatin1(lesson), picture, QString::fromLatin1(title)});
    startPage()->setSamples(samples);
    const QImage hero(picture);
    startPage()->setRecent(
        {{QDir::homePath() + "/sketches/hat.ductus", QPixmap::fromImage(hero), false},
         {QDir::homePath() + "/sketches/a very long name of a sketch that has to be cut.ductus", {}, false},
         {"/media/stick/vase.ductus", {}, true}});
    connect(startPage(), &StartPage::newRequested, this, [this] { showCanvas(); });
    connect(startPage(), &StartPage::openSample, this, [this] { showCanvas(); });
    connect(this, &MainWindowShell::filesDropped, this,
            [this](const QStringList &paths) { messages()->info(paths.join(QStringLiteral(", "))); });
}

void GalleryWindow::startJob(double seconds)
{
    jobs().start<int>(
        {"surface", tr("Surfacing the sketch")},
        [seconds](const JobControl &control) -> Result<int> {
            const int steps = int(seconds * 50.0);
            for (int i = 0; i < steps; ++i) {
                if (control.isCancelled())
                    return cancelledError("Surfacing the sketch");
                control.progress(i / double(steps),
                                 i < steps / 3 ? "Building the proxy" : "Fitting the patches");
                QThread::msleep(20);
            }
            return steps;
        },
        [this](Result<int> result) {
            if (result)
                messages()->success(tr("The surface is ready."));
        });
}

} // namespace ductus
