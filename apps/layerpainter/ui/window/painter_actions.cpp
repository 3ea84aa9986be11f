// Actions and menus of LayerPainter's window.
#include "layerpainter/ui/window/painter_window.h"
#include "widgets/pages/help_window.h"

#include <QActionGroup>
#include <QMenu>

namespace ductus {

void PainterWindow::addActions()
{
    ActionCatalogue &all = actions();
    const QString file = tr("File"), edit = tr("Edit"), layer = tr("Layer"), view = tr("View");
    all.add({"file.new",
             tr("&New painting"),
             tr("Begins with an empty canvas and one stack."),
             "document-new",
             {QKeySequence::New},
             file},
            [this] { newPainting(); });
    all.add({"file.open",
             tr("&Open..."),
             tr("Opens a project, a Quill or .tilt painting, or a mesh."),
             "document-open",
             {QKeySequence::Open},
             file},
            [this] { chooseAndOpen(); });
    all.add({"file.import",
             tr("&Import into painting..."),
             tr("The strokes of another painting or a mesh join this one; dropping a file does the same."),
             "document-import",
             {QKeySequence("Ctrl+Shift+O")},
             file},
            [this] { chooseImport(); });
    all.add({"file.updateSurfaces",
             tr("&Update surfaces"),
             tr("Takes what has changed in the sketches the surfaces were made from; your layers stay."),
             "view-refresh",
             {QKeySequence("F5")},
             file},
            [this] { lookForNewerSurfaces(true); });
    all.add({"file.start",
             tr("S&tart page"),
             tr("Shows samples and recent files; the painting stays open."),
             "go-home",
             {QKeySequence("Alt+Home")},
             file},
            [this] {
                refreshRecent();
                isStartPageShown() && !mPainting.isEmpty() ? showCanvas() : showStartPage();
            });
    all.add({"file.save",
             tr("&Save"),
             tr("Saves the painting with layers and looks."),
             "document-save",
             {QKeySequence::Save},
             file},
            [this] { save(); });
    all.add({"file.saveAs",
             tr("Save &as..."),
             tr("Saves under another name and goes on there."),
             "document-save-as",
             {QKeySequence("Ctrl+Shift+S")},
             file},
            [this] { saveAs(); });
    all.add({"file.export",
             tr("&Export picture..."),
             tr("Writes what the canvas shows as a PNG file."),
             "document-export",
             {QKeySequence("Ctrl+E")},
             file},
            [this] { chooseExport(); });
    all.add({"file.film",
             tr("Export &film..."),
             tr("A turntable, the camera path or the motion as MP4, WebM, GIF or pictures."),
             "media-playback-start",
             {QKeySequence("Ctrl+Shift+E")},
             file},
            [this] { chooseFilm(); });
    all.add({"file.mesh",
             tr("Export &mesh..."),
             tr("A GLB file whose vertices have the colours of all layers, for the web."),
             "document-send",
             {},
             file},
            [this] { chooseMesh(); });
    all.add({"file.log",
             tr("Save action &log..."),
             tr("Everything done so far, a line each; layerpainter replay plays it again."),
             "view-history",
             {},
             file},
            [this] { chooseLogFile(); });
    all.add({"edit.delete",
             tr("&Delete strokes"),
             tr("Takes the chosen strokes away."),
             "edit-delete",
             {QKeySequence::Delete},
             edit},
            [this] { deleteSelection(); });
    all.add({"edit.duplicate",
             tr("Duplicate &into layer"),
             tr("Copies of the chosen strokes in the active layer: how highlights and shadows are made."),
             "edit-copy",
             {QKeySequence("Ctrl+D")},
             edit},
            [this] { duplicateSelection(); });
    all.add({"edit.toLayer",
             tr("&Move to layer"),
             tr("The chosen strokes go into the active layer."),
             "go-up",
             {QKeySequence("Ctrl+M")},
             edit},
            [this] {
                if (!mView->selection().empty())
                    (void)mPainting.perform(act::MoveElements{mView->selection(), mBrush.layer, 0});
            });
    all.add({"edit.recolour",
             tr("Rec&olour"),
             tr("Gives the chosen strokes the present colour."),
             "format-stroke-color",
             {QKeySequence("Ctrl+R")},
             edit},
            [this] {
                if (!mView->selection().empty())
                    (void)mPainting.perform(act::Recolour{mView->selection(), mBrush.colour});
            });
    all.add({"edit.selectLayer",
             tr("Choose &all of layer"),
             tr("All strokes of the active layer."),
             "edit-select-all",
             {QKeySequence::SelectAll},
             edit},
            [this] {
                std::vector<ElementId> chosen;
                if (const Layer *active = mPainting.painting().findLayer(mBrush.layer))
                    for (const Element &element : active->drawingAt(0).elements)
                        chosen.push_back(element.id);
                mView->setSelection(std::move(chosen));
            });
    all.add({"edit.escape",
             tr("Cancel"),
             tr("Forgets what was begun, then the choice, then the tool."),
             "dialog-cancel",
             {QKeySequence("Esc")},
             edit},
            [this] { escape(); });
    all.add({"layer.addStack",
             tr("Add &stack"),
             tr("A new shape to paint on, with layers of its own."),
             "stack",
             {QKeySequence("Ctrl+Shift+N")},
             layer},
            [this] { mLayers->addStack(); });
    all.add({"layer.add",
             tr("Add &layer"),
             tr("Its strokes colour the shape below them."),
             "appearance-layer",
             {QKeySequence("Ctrl+L")},
             layer},
            [this] { mLayers->addLayer(); });
    all.add({"layer.duplicate",
             tr("&Duplicate layer"),
             tr("A copy with all strokes, right above."),
             "edit-copy",
             {QKeySequence("Ctrl+J")},
             layer},
            [this] { mLayers->duplicateLayer(); });
    all.add({"layer.rename",
             tr("&Rename"),
             tr("Another name for stack or layer."),
             "edit-rename",
             {QKeySequence("F2")},
             layer},
            [this] { mLayers->tree().renameCurrent(); });
    all.add({"layer.remove",
             tr("D&elete layer"),
             tr("Undo brings it back."),
             "edit-delete",
             {QKeySequence("Ctrl+Delete")},
             layer},
            [this] { mLayers->removeLayer(); });
    all.add({"view.frame",
             tr("Fr&ame all"),
             tr("Back to the painting's own view."),
             "zoom-fit-best",
             {QKeySequence("F"), QKeySequence("Home")},
             view},
            [this] { mView->frameAll(); });
    ActionSpec motion{"view.motion",   tr("&Motion"),       tr("Shows the timeline of motion and camera."),
                      "keyframe-next", {QKeySequence("T")}, view};
    motion.isCheckable = true;
    all.add(motion, [this] { setMotionShown(!mMotion->isVisible()); });
    all.add({"motion.play",
             tr("&Play"),
             tr("Plays motion, drawings and camera path; again stops."),
             "media-playback-start",
             {QKeySequence("Space")},
             view},
            [this] {
                if (!mMotion->isVisible())
                    setMotionShown(true);
                mMotion->setPlaying(!mMotion->isPlaying());
            });
    all.add({"motion.keepView",
             tr("&Keep view as key"),
             tr("Where you look from becomes a key of the camera path at the present time."),
             "keyframe-add",
             {QKeySequence("K")},
             view},
            [this] {
                setMotionShown(true);
                mMotion->keepView();
            });
    all.add({"brush.larger",
             tr("&Larger brush"),
             tr("Wider strokes."),
             "list-add",
             {QKeySequence("]")},
             tr("Brush")},
            [this] { mBrushPanel->step(1); });
    all.add({"brush.smaller",
             tr("&Smaller brush"),
             tr("Finer strokes."),
             "list-remove",
             {QKeySequence("[")},
             tr("Brush")},
            [this] { mBrushPanel->step(-1); });
}

void PainterWindow::addToolActions()
{
    struct Tool
    {
        const char *id;
        QString text, teaches, hint;
        const char *icon, *key;
    };
    const Tool tools[] = {
        {"tool.orbit", tr("&Turn view"), tr("Drag turns the view. With other tools: the right button."),
         tr("Drag to turn, wheel to zoom, middle button or Shift to pan."), "view-refresh", "O"},
        {"tool.select", tr("&Select"),
         tr("A click chooses a stroke, Shift adds, a drag chooses a box, with Ctrl a lasso."),
         tr("Click a stroke, or drag a box over strokes of the active layer. Ctrl+D copies them into the "
            "active layer."),
         "select", "V"},
        {"tool.move", tr("&Move"), tr("Moves, turns and scales the chosen strokes."),
         tr("Drag the chosen strokes; the ring turns them (with Shift upright), the square scales them."),
         "transform-move", "G"},
        {"tool.paint", tr("&Paint"), tr("Paints into the active layer: a shape in stacks, colour in layers."),
         tr("Paint on the surface or in the air. Shift draws straight, [ and ] change the size."),
         "draw-freehand", "B"},
        {"tool.erase", tr("&Erase"),
         tr("Takes strokes of the active layer away; with Shift only the touched parts."),
         tr("Drag over strokes of the active layer. With Shift only the touched parts go."), "draw-eraser",
         "E"},
        {"tool.gradient", tr("&Gradient"), tr("Fades the active layer along a drag."),
         tr("Drag from where the layer is full to where it fades out. With Shift around a point."),
         "gradient", "D"},
        {"tool.inspect", tr("&What colours this"), tr("A click lists the layers that colour a point."),
         tr("Click on the painting: the list shows which layers colour this point, the topmost first."),
         "color-picker", "I"}};
    mToolActions = new QActionGroup(this);
    for (std::size_t i = 0; i < std::size(tools); ++i) {
        const Tool &tool = tools[i];
        ActionSpec spec{tool.id, tool.text, tool.teaches, tool.icon, {QKeySequence(tool.key)}, tr("Tools")};
        spec.isCheckable = true;
        QAction *action = actions().add(spec, [this, i] { setTool(PainterTool(i)); });
        action->setStatusTip(tool.hint);
        mToolActions->addAction(action);
        addTool(action);
        if (i == 0 || i == 2)
            addToolSeparator();
    }
}

void PainterWindow::fillMenus()
{
    const auto named = [this](std::initializer_list<const char *> ids) {
        QList<QAction *> list;
        for (const char *id : ids)
            list << actions().action(QLatin1String(id));
        return list;
    };
    addToMenu(fileMenu(), named({"file.new", "file.open", "file.import", "file.updateSurfaces", "file.start",
                                 "file.save", "file.saveAs", "file.export", "file.film", "file.mesh",
                                 "file.sendToSketchSurfacer", "file.sendToDoodleStudio", "file.log"}));
    addToMenu(editMenu(), named({"edit.copy", "edit.paste", "edit.selectLayer", "edit.duplicate",
                                 "edit.toLayer", "edit.recolour", "edit.delete", "edit.escape"}));
    QMenu *layer = menu(tr("&Layer"));
    layer->addActions(
        named({"layer.addStack", "layer.add", "layer.duplicate", "layer.rename", "layer.remove"}));
    QMenu *brush = menu(tr("&Brush"));
    brush->addActions(named({"brush.larger", "brush.smaller"}));
    addToMenu(viewMenu(), named({"view.frame", "view.motion", "motion.play", "motion.keepView"}));
}

void PainterWindow::openManual(const QString &topic)
{
    auto *help = findChild<HelpWindow *>();
    if (!help)
        help = new HelpWindow(QStringLiteral(":/manual/layerpainter.md"), this);
    help->show();
    help->raise();
    help->activateWindow();
    // Tools have sections of their names; on the canvas the one in hand is meant.
    const QAction *tool =
        topic == QLatin1String("canvas") ? mToolActions->checkedAction() : actions().action(topic);
    help->showSection(tool ? plainText(tool->text()) : QString());
}

} // namespace ductus
