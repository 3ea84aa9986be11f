// Actions and menus of SketchSurfacer's window.
#include "sketchsurfacer/ui/viewport/turntable.h"
#include "sketchsurfacer/ui/window/surfacer_window.h"
#include "widgets/controls/segmented_switch.h"
#include "widgets/pages/help_window.h"
#include "widgets/shell/message_bar.h"

#include <QActionGroup>
#include <QApplication>
#include <QFileDialog>
#include <QMenu>

namespace ductus {

void SurfacerWindow::addActions()
{
    ActionCatalogue &all = actions();
    const QString file = tr("File"), edit = tr("Edit"), surface = tr("Surface");
    all.add({"file.new",
             tr("&New sketch"),
             tr("Begins with an empty canvas to draw on."),
             "document-new",
             {QKeySequence::New},
             file},
            [this] { newSketch(); });
    all.add({"file.open",
             tr("&Open..."),
             tr("Opens a project, or a sketch of another program."),
             "document-open",
             {QKeySequence::Open},
             file},
            [this] { chooseAndOpen(); });
    all.add({"file.start",
             tr("S&tart page"),
             tr("Shows samples and recent files; the sketch stays open."),
             "go-home",
             {QKeySequence("Alt+Home")},
             file},
            [this] {
                refreshRecent(); // a file may be gone meanwhile
                isStartPageShown() && !mSketch.isEmpty() ? showCanvas() : showStartPage();
            });
    all.add({"file.save",
             tr("&Save"),
             tr("Saves sketch, decisions and surface."),
             "document-save",
             {QKeySequence::Save},
             file},
            [this] { save(); });
    all.add({"file.saveAs",
             tr("Save &as..."),
             tr("Saves under another name."),
             "document-save-as",
             {QKeySequence("Ctrl+Shift+S")},
             file},
            [this] { saveAs(); });
    all.add({"file.export",
             tr("&Export surface..."),
             tr("Writes OBJ, PLY, STL, GLB or OFF for other programs."),
             "document-export",
             {QKeySequence("Ctrl+E")},
             file},
            [this] { exportSurface(); });
    all.add({"file.sendToLayerPainter",
             tr("Send to &LayerPainter"),
             tr("Opens the project in LayerPainter, to paint on the surface."),
             "document-send",
             {QKeySequence("Ctrl+Shift+L")},
             file},
            [this] { sendToLayerPainter(); });
    all.add({"file.picture",
             tr("Save p&icture..."),
             tr("Writes what the canvas shows as a PNG file."),
             "peek",
             {QKeySequence("Ctrl+P")},
             file},
            [this] {
                const QString path = QFileDialog::getSaveFileName(
                    this, tr("Save picture"), mSketch.displayName() + QStringLiteral(".png"),
                    tr("Pictures (*.png)"));
                if (!path.isEmpty())
                    savePicture(path);
            });
    all.add({"file.turntable",
             tr("Save t&urntable..."),
             tr("Writes a round of 72 pictures into a folder, to be made a film of."),
             {},
             {},
             file},
            [this] {
                const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder for the pictures"));
                if (!folder.isEmpty())
                    saveTurntable(folder, 72);
            });
    all.add({"edit.copy",
             tr("&Copy strokes"),
             tr("Puts the chosen strokes, or all, on the clipboard, for the other apps of the suite as well."),
             "edit-copy",
             {QKeySequence::Copy},
             edit},
            [this] { copyStrokes(); });
    all.add({"edit.paste",
             tr("&Paste sketch"),
             tr("Adds strokes copied in this or another app of the suite, or opens text or a file."),
             "edit-paste",
             {QKeySequence::Paste},
             edit},
            [this] { pasteSketch(); });
    all.add({"edit.delete",
             tr("&Delete strokes"),
             tr("Takes the chosen strokes out of the sketch."),
             "edit-delete",
             {QKeySequence::Delete},
             edit},
            [this] {
                const std::vector<StrokeId> chosen = mPresenter->selection();
                mPresenter->setSelection({});
                mSketch.deleteStrokes(chosen);
            });
    all.add({"edit.selectAll",
             tr("Choose &all strokes"),
             tr("So that one act changes them all."),
             "edit-select-all",
             {QKeySequence::SelectAll},
             edit},
            [this] {
                std::vector<StrokeId> ids;
                for (const Stroke &stroke : mSketch.strokes().strokes)
                    ids.push_back(stroke.id);
                mPresenter->setSelection(std::move(ids));
            });
    all.add({"edit.escape",
             tr("Cancel"),
             tr("Stops what runs, forgets what was begun, goes back to the arrow."),
             "dialog-cancel",
             {QKeySequence("Esc")},
             edit},
            [this] { escape(); });
    all.add({"surface.run",
             tr("&Surface it"),
             tr("Finds the surface the strokes describe."),
             "surface",
             {QKeySequence("Ctrl+Return"), QKeySequence("Ctrl+Enter")},
             surface},
            [this] { surfaceIt(); });
    all.add({"surface.anew",
             tr("Surface a&new"),
             tr("Forgets the way here: edited strokes are usually worked into the surface there is."),
             "view-refresh",
             {QKeySequence("Ctrl+Shift+Return")},
             surface},
            [this] {
                if (mSketch.isEmpty())
                    return;
                mSketch.startAnew();
                surfaceIt();
            });
    QAction *follow =
        all.addToggle({"surface.follow",
                       tr("&Update by itself"),
                       tr("After a scribble or a moved slider the surface follows without a click."),
                       "view-refresh",
                       {},
                       surface},
                      [this](bool on) { mSurfacing.setFollowsEdits(on); });
    follow->setChecked(true);
    all.add({"surface.clearScribbles",
             tr("Remove all s&cribbles"),
             tr("Back to the regions found automatically."),
             "edit-clear",
             {},
             surface},
            [this] { mSketch.clearScribbles(); });
    all.add({"surface.ownProxy",
             tr("Use &proxy from file..."),
             tr("Takes a mesh made elsewhere as the rough skin the strokes are read on."),
             "proxy",
             {},
             surface},
            [this] { chooseAndOpen(); });
    all.add({"surface.autoProxy",
             tr("Make proxy &automatically"),
             tr("Forgets the mesh from a file."),
             {},
             {},
             surface},
            [this] { mSketch.setGivenProxy(nullptr); });
}

void SurfacerWindow::addToolActions()
{
    struct Tool
    {
        ToolKind kind;
        const char *id;
        QString text, teaches;
        const char *icon;
        const char *key;
    };
    const Tool tools[] = {
        {ToolKind::Select, "tool.select", tr("&Select"),
         tr("Drag turns the view, a click chooses a stroke or region."), "select", "V"},
        {ToolKind::RoleBrush, "tool.roles", tr("&Role brush"),
         tr("Paint over strokes to say what they are: border, ignored, ..."), "role-brush", "B"},
        {ToolKind::DrawStroke, "tool.draw", tr("&Draw stroke"),
         tr("Add the stroke that was missing; the surface follows."), "draw-stroke", "D"},
        {ToolKind::NewRegion, "tool.newRegion", tr("&New region"),
         tr("Yellow: what you scribble over becomes a surface of its own."), "new-region", "N"},
        {ToolKind::Merge, "tool.merge", tr("&Merge regions"),
         tr("Green: the regions you connect become one."), "merge", "M"},
        {ToolKind::Seam, "tool.seam", tr("Se&am"), tr("Red: a crease must run exactly here."), "seam", "S"},
        {ToolKind::Split, "tool.split", tr("S&plit region"),
         tr("Orange: cuts a region in two along your line."), "edit-cut", "X"},
        {ToolKind::ForbidSeam, "tool.forbidSeam", tr("&Forbid seam"), tr("Blue: no crease may run here."),
         "draw-eraser", "E"},
        {ToolKind::Lock, "tool.lock", tr("&Lock region"),
         tr("A locked region stays as it is, whatever else changes."), "lock", "L"},
        {ToolKind::Measure, "tool.measure", tr("M&easure"), tr("The length between two points."), "measure",
         "R"}};
    mToolActions = new QActionGroup(this);
    for (const Tool &tool : tools) {
        ActionSpec spec{tool.id, tool.text, tool.teaches, tool.icon, {QKeySequence(tool.key)}, tr("Tools")};
        spec.isCheckable = true;
        QAction *action = actions().add(spec, [this, kind = tool.kind] {
            // Scribbles need something to be drawn on.
            if (kind >= ToolKind::NewRegion && kind <= ToolKind::Lock && mView->mode() == ViewMode::Sketch &&
                mPresenter->resultView())
                showMode(ViewMode::Regions);
            mTools->setTool(kind);
        });
        mToolActions->addAction(action);
        addTool(action);
        if (tool.kind == ToolKind::Select || tool.kind == ToolKind::DrawStroke || tool.kind == ToolKind::Lock)
            addToolSeparator();
    }
    connect(mTools, &ToolBox::toolChanged, this,
            [this] { mToolActions->actions().at(int(mTools->tool()))->setChecked(true); });
    mToolActions->actions().first()->setChecked(true);
}

void SurfacerWindow::openManual(const QString &topic)
{
    if (!mHelp)
        mHelp = new HelpWindow(QStringLiteral(":/manual/sketchsurfacer.md"), this);
    mHelp->show();
    mHelp->raise();
    mHelp->activateWindow();
    // Tools have sections of their names; on the canvas the one in hand is meant.
    const QAction *tool =
        topic == QLatin1String("canvas") ? mToolActions->checkedAction() : actions().action(topic);
    mHelp->showSection(tool ? plainText(tool->text()) : QString());
}

void SurfacerWindow::addViewActions()
{
    struct Preset
    {
        const char *id;
        QString text;
        QString key;
        ViewPreset preset;
    };
    const QString view = tr("View");
    const Preset presets[] = {{"view.front", tr("&Front"), "Num+1", ViewPreset::Front},
                              {"view.back", tr("&Back"), "Ctrl+Num+1", ViewPreset::Back},
                              {"view.right", tr("&Right"), "Num+3", ViewPreset::Right},
                              {"view.left", tr("&Left"), "Ctrl+Num+3", ViewPreset::Left},
                              {"view.top", tr("&Top"), "Num+7", ViewPreset::Top},
                              {"view.bottom", tr("B&ottom"), "Ctrl+Num+7", ViewPreset::Bottom},
                              {"view.threeQuarter", tr("Three-&quarter"), "Num+0", ViewPreset::ThreeQuarter}};
    ActionCatalogue &all = actions();
    for (const Preset &preset : presets)
        all.add({preset.id, preset.text, tr("Looks from there."), {}, {QKeySequence(preset.key)}, view},
                [this, p = preset.preset] { mView->setPreset(p); });
    all.add({"view.frame",
             tr("Fr&ame all"),
             tr("Brings the whole sketch into view."),
             "zoom-fit-best",
             {QKeySequence("F"), QKeySequence("Home")},
             view},
            [this] { mView->frameAll(); });
    all.add({"view.zoomIn", tr("&Zoom in"), tr("Comes nearer."), "zoom-in", {QKeySequence::ZoomIn}, view},
            [this] { mView->zoomBy(0.8); });
    all.add({"view.zoomOut", tr("Zoom o&ut"), tr("Steps back."), "zoom-out", {QKeySequence::ZoomOut}, view},
            [this] { mView->zoomBy(1.25); });
    const std::pair<const char *, QPointF> turns[] = {
        {"Left", {-40, 0}}, {"Right", {40, 0}}, {"Up", {0, -40}}, {"Down", {0, 40}}};
    for (const auto &[key, by] : turns)
        all.add({QStringLiteral("view.turn") + QLatin1String(key),
                 tr("Turn view (%1)").arg(QLatin1String(key)),
                 tr("Turns the view without a mouse."),
                 {},
                 {QKeySequence(QStringLiteral("Alt+") + QLatin1String(key))},
                 view},
                [this, by = by] { mView->orbitBy(by); });
    QAction *perspective = all.addToggle({"view.perspective",
                                          tr("&Perspective"),
                                          tr("Far things smaller; off for measuring by eye."),
                                          {},
                                          {QKeySequence("P"), QKeySequence("Num+5")},
                                          view},
                                         [this](bool on) { mView->setPerspective(on); });
    perspective->setChecked(true);
    QAction *strokes = all.addToggle({"view.strokes",
                                      tr("St&rokes on the surface"),
                                      tr("Shows the sketch on top of the surface."),
                                      "stroke",
                                      {QKeySequence("T")},
                                      view},
                                     [this](bool on) { mView->setStrokesShown(on); });
    strokes->setChecked(true);
    all.addToggle({"view.turntable",
                   tr("&Turntable"),
                   tr("Turns the view by itself, to look at it from all sides."),
                   "view-refresh",
                   {QKeySequence("G")},
                   view},
                  [this](bool on) { mTurntable->setTurning(on); });
    QAction *mirror =
        all.addToggle({"edit.mirror",
                       tr("&Mirror drawn strokes"),
                       tr("Where the sketch is symmetric a stroke comes with its mirror image."),
                       {},
                       {QKeySequence("Shift+X")},
                       tr("Edit")},
                      [this](bool on) { mTools->setMirrors(on); });
    mirror->setChecked(true);
    all.addToggle(
        {"view.ambiguity",
         tr("What the sketch leaves &open"),
         tr("Colours where the strokes allow more than one surface; a click there offers the others."),
         "help",
         {QKeySequence("A")},
         view},
        [this](bool on) { showAmbiguity(on); });
    all.addToggle({"view.compare",
                   tr("&Compare with the sketch"),
                   tr("A line to drag: the sketch at its left, the surface at its right."),
                   "peek",
                   {QKeySequence("C")},
                   view},
                  [this](bool on) {
                      if (on && mView->mode() == ViewMode::Sketch)
                          showMode(ViewMode::Surface);
                      mView->setComparison(on ? std::optional(0.5) : std::nullopt);
                  });
}

void SurfacerWindow::fillMenus()
{
    const auto named = [this](const QStringList &ids) {
        QList<QAction *> list;
        for (const QString &id : ids)
            list << actions().action(id);
        return list;
    };
    addToMenu(fileMenu(),
              named({"file.new", "file.open", "file.start", "file.save", "file.saveAs", "file.export",
                     "file.sendToLayerPainter", "file.picture", "file.turntable"}));
    addToMenu(editMenu(), named({"edit.copy", "edit.paste", "edit.delete", "edit.selectAll", "edit.mirror"}));
    addToMenu(viewMenu(), named({"view.frame", "view.zoomIn", "view.zoomOut", "view.perspective",
                                 "view.strokes", "view.compare", "view.ambiguity", "view.turntable"}));
    QMenu *presets = new QMenu(tr("Loo&k from"), this);
    presets->addActions(named({"view.front", "view.back", "view.right", "view.left", "view.top",
                               "view.bottom", "view.threeQuarter"}));
    addToMenu(viewMenu(), {presets->menuAction()});
    QMenu *surface = menu(tr("&Surface"));
    surface->addActions(named({"surface.run", "surface.anew", "surface.follow"}));
    surface->addSeparator();
    surface->addActions(named({"surface.clearScribbles", "surface.ownProxy", "surface.autoProxy"}));
    menu(tr("&Tools"))->addActions(mToolActions->actions());
}

} // namespace ductus
