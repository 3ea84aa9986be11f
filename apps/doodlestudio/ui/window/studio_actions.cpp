// Actions and menus of DoodleStudio's window.
#include "doodlestudio/ui/canvases/canvas_list.h"
#include "doodlestudio/ui/canvases/canvas_panel.h"
#include "doodlestudio/ui/drawing/drawing_panel.h"
#include "doodlestudio/ui/player/player_view.h"
#include "doodlestudio/ui/timeline/transport_bar.h"
#include "doodlestudio/ui/window/studio_window.h"
#include "widgets/pages/help_window.h"
#include "widgets/theme/icons.h"

#include <QMenu>
#include <QToolButton>
#include <algorithm>

namespace ductus {

void StudioWindow::addFileActions()
{
    ActionCatalogue &all = actions();
    const QString file = tr("File");
    all.add({"file.open",
             tr("&Open..."),
             tr("Opens a clip, a folder of pictures or a project."),
             "document-open",
             {QKeySequence::Open},
             file},
            [this] { chooseAndOpen(); });
    all.add({"file.start",
             tr("S&tart page"),
             tr("Shows samples and recent files; the clip stays open."),
             "go-home",
             {QKeySequence("Alt+Home")},
             file},
            [this] {
                refreshRecent();
                isStartPageShown() && !mDoodle.isEmpty() ? showCanvas() : showStartPage();
            });
    all.add({"file.save",
             tr("&Save"),
             tr("Saves what was drawn and where; the clip itself stays where it is."),
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
    QAction *pack =
        all.add({"file.pack",
                 tr("&Pack the analysis"),
                 tr("Saves how the scene moves in the project as well, so that it opens at once "
                    "on another computer. Makes the file larger."),
                 {},
                 {},
                 file},
                [this] { packAnalysis(actions().action(QStringLiteral("file.pack"))->isChecked()); });
    pack->setCheckable(true);
    all.add(
        {"file.place",
         tr("Place a pa&inting..."),
         tr("Stands a painting of LayerPainter in the scene: seen by the shot's camera, hidden by what is "
            "before it."),
         "document-import",
         {},
         file},
        [this] { choosePainting(); });
    all.add({"file.updatePaintings",
             tr("&Update paintings"),
             tr("Takes what has changed in the paintings that stand in the scene; they stay where they are."),
             "view-refresh",
             {QKeySequence("F5")},
             file},
            [this] { lookForNewerPaintings(true); });
    QAction *exportFilm = all.add({"file.export",
                                   tr("&Export..."),
                                   tr("Makes a film, a moving picture for slides, or an overlay."),
                                   "document-export",
                                   {QKeySequence("Ctrl+E")},
                                   file},
                                  [this] { openExport(); });
    auto *button = new QToolButton;
    button->setDefaultAction(exportFilm);
    button->setText(tr("Export"));
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    addToTopRow(button);
}

void StudioWindow::addPlayActions()
{
    ActionCatalogue &all = actions();
    const QString play = tr("Play");
    QAction *toggle = all.add({"play.toggle",
                               tr("&Play"),
                               tr("Runs the clip in a loop, or stops it."),
                               "media-playback-start",
                               {QKeySequence(Qt::Key_Space)},
                               play},
                              [this] { mPlayback.toggle(); });
    connect(&mPlayback, &Playback::playingChanged, this, [this, toggle](bool playing) {
        toggle->setIcon(icon(playing ? "media-playback-pause" : "media-playback-start"));
        toggle->setText(playing ? tr("&Pause") : tr("&Play"));
    });
    all.add({"play.back",
             tr("One frame &back"),
             tr("Goes to the frame before."),
             "media-seek-backward",
             {QKeySequence(Qt::Key_Left), QKeySequence(Qt::Key_Comma)},
             play},
            [this] { mPlayback.step(-1); });
    all.add({"play.forward",
             tr("One frame &on"),
             tr("Goes to the next frame."),
             "media-seek-forward",
             {QKeySequence(Qt::Key_Right), QKeySequence(Qt::Key_Period)},
             play},
            [this] { mPlayback.step(1); });
    all.add({"play.start",
             tr("To the be&ginning"),
             tr("Goes to the first frame."),
             "media-skip-backward",
             {QKeySequence(Qt::Key_Home)},
             play},
            [this] { mPlayback.setFrame(0); });
    all.add({"play.end",
             tr("To the &end"),
             tr("Goes to the last frame."),
             "media-skip-forward",
             {QKeySequence(Qt::Key_End)},
             play},
            [this] { mPlayback.setFrame(mPlayback.frameCount() - 1); });
    all.add({"play.reverse",
             tr("Play back&wards"),
             tr("Runs the clip backwards; again: faster."),
             {},
             {QKeySequence(Qt::Key_J)},
             play},
            [this] { mPlayback.play(mPlayback.rate() < 0 ? std::max(-8.0, mPlayback.rate() * 2) : -1.0); });
    all.add({"play.stop", tr("&Stop"), tr("Stops the clip."), {}, {QKeySequence(Qt::Key_K)}, play},
            [this] { mPlayback.stop(); });
    all.add({"play.faster",
             tr("Play &forwards"),
             tr("Runs the clip; again: faster."),
             {},
             {QKeySequence(Qt::Key_L)},
             play},
            [this] { mPlayback.play(mPlayback.rate() > 0 ? std::min(8.0, mPlayback.rate() * 2) : 1.0); });
    QAction *sound = all.addToggle({"play.sound",
                                    tr("So&und"),
                                    tr("Lets the clip be heard while it runs."),
                                    "sound",
                                    {QKeySequence(Qt::Key_M)},
                                    play},
                                   [this](bool on) { mPlayback.setMuted(!on); });
    sound->setChecked(true);
    for (const char *id :
         {"play.start", "play.back", "play.toggle", "play.forward", "play.end", "play.sound"})
        mTransport->addButton(all.action(QLatin1String(id)));
}

void StudioWindow::addCanvasActions()
{
    ActionCatalogue &all = actions();
    const QString canvas = tr("Canvas");
    all.add({"canvas.follow",
             tr("&Follow what is here"),
             tr("Pins the canvas to what is under its middle; it follows from then on."),
             "pin",
             {QKeySequence(Qt::Key_F)},
             canvas},
            [this] { mCanvasPanel->pinHere(); });
    all.add({"canvas.stay",
             tr("S&tay here"),
             tr("Lets the canvas stand still in the scene where it is now."),
             {},
             {QKeySequence("Shift+F")},
             canvas},
            [this] { mCanvasPanel->setFollows(false); });
    all.add({"canvas.face",
             tr("Face the &camera"),
             tr("Turns the canvas straight to the camera in this frame."),
             {},
             {QKeySequence(Qt::Key_C)},
             canvas},
            [this] { mCanvasPanel->faceCamera(); });
    all.add({"canvas.nextKeyframe",
             tr("&Next keyframe"),
             tr("Goes to the next frame in which the canvas is pinned, turned or sized."),
             "keyframe-next",
             {QKeySequence("Ctrl+Right")},
             canvas},
            [this] { goToKeyframe(1); });
    all.add({"canvas.previousKeyframe",
             tr("&Previous keyframe"),
             tr("Goes to the keyframe before."),
             "keyframe-previous",
             {QKeySequence("Ctrl+Left")},
             canvas},
            [this] { goToKeyframe(-1); });
    all.add({"canvas.duplicate",
             tr("&Duplicate canvas"),
             tr("A second canvas with the same drawings, beside this one."),
             "edit-copy",
             {QKeySequence("Ctrl+D")},
             canvas},
            [this] { mCanvasList->duplicateChosen(); });
    all.add({"canvas.remove",
             tr("Ta&ke canvas away"),
             tr("Takes the canvas and its drawings away."),
             "edit-delete",
             {QKeySequence("Ctrl+Delete")},
             canvas},
            [this] { mCanvasList->removeChosen(); });
    all.add({"scene.analyse",
             tr("&Look at the scene again"),
             tr("Finds anew how the camera and all else moves; drawings stay."),
             "view-refresh",
             {},
             tr("Scene")},
            [this] {
                if (!mDoodle.isEmpty())
                    analyse();
            });
    all.add({"edit.escape",
             tr("Cancel"),
             tr("Gives up what was begun; then the choice."),
             "dialog-cancel",
             {QKeySequence("Esc")},
             tr("Edit")},
            [this] {
                if (mHand.isDrawing())
                    mHand.cancel();
                else if (!mPlayer->cancelDrag())
                    mState.choose({});
            });
}

void StudioWindow::addDrawingActions()
{
    ActionCatalogue &all = actions();
    const QString draw = tr("Draw");
    const struct
    {
        const char *id;
        QString text, teaches;
        const char *icon;
        Qt::Key key;
        DrawingTool tool;
    } tools[] = {
        {"draw.pen", tr("&Pen"), tr("Draws lines."), "draw-freehand", Qt::Key_P, DrawingTool::Pen},
        {"draw.fill", tr("&Filled shape"), tr("Draw an outline; what is inside is filled."), "shape-fill",
         Qt::Key_G, DrawingTool::Fill},
        {"draw.arrow", tr("&Arrow"), tr("Points at something."), "arrow-mark", Qt::Key_A, DrawingTool::Arrow},
        {"draw.words", tr("&Words"), tr("Type words, then click where they should stand."), "draw-text",
         Qt::Key_T, DrawingTool::Text},
        {"draw.sticker", tr("&Sticker"), tr("Ready-made drawings."), "sticker", Qt::Key_S,
         DrawingTool::Sticker},
        {"draw.eraser", tr("&Eraser"), tr("Takes parts of lines away."), "draw-eraser", Qt::Key_E,
         DrawingTool::Eraser},
        {"draw.move", tr("&Move a drawing"), tr("Moves something that was drawn."), "transform-move",
         Qt::Key_V, DrawingTool::Move}};
    for (const auto &tool : tools)
        all.add({tool.id, tool.text, tool.teaches, tool.icon, {QKeySequence(tool.key)}, draw},
                [this, chosen = tool.tool] {
                    setStep(StudioStep::Draw);
                    mDrawing->setTool(chosen);
                });
    all.add({"draw.wider", tr("W&ider brush"), tr("Makes the brush wider."), {}, {QKeySequence("]")}, draw},
            [this] { mDrawing->changeWidth(1); });
    all.add({"draw.narrower",
             tr("&Narrower brush"),
             tr("Makes the brush narrower."),
             {},
             {QKeySequence("[")},
             draw},
            [this] { mDrawing->changeWidth(-1); });
    all.add({"draw.onion",
             tr("&Onion skin"),
             tr("The drawings before shine through in red, those after in blue."),
             {},
             {QKeySequence(Qt::Key_O)},
             draw},
            [this] {
                mState.setOnionSkin({!mState.onionSkin().isOn, mState.onionSkin().count});
            });
    all.add({"draw.addDrawing",
             tr("A&dd drawing"),
             tr("An empty drawing after this one: the next moment of an animation."),
             "list-add",
             {QKeySequence(Qt::Key_N)},
             draw},
            [this] { mDrawing->strip().addDrawing(); });
    all.add({"draw.duplicateDrawing",
             tr("D&uplicate drawing"),
             tr("A copy of this drawing after it, to be changed a little."),
             "edit-copy",
             {QKeySequence("Shift+N")},
             draw},
            [this] { mDrawing->strip().duplicateDrawing(); });
    all.add({"draw.removeDrawing",
             tr("Take drawing awa&y"),
             tr("Takes the present drawing out of the animation."),
             "list-remove",
             {QKeySequence("Shift+Delete")},
             draw},
            [this] { mDrawing->strip().removeDrawing(); });
    all.add({"draw.copy",
             tr("&Copy lines"),
             tr("Puts the lines of this drawing on the clipboard, for the other apps of the suite as well."),
             "edit-copy",
             {QKeySequence::Copy},
             draw},
            [this] { copyStrokes(); });
    all.add({"draw.paste",
             tr("Paste &lines"),
             tr("Draws the strokes on the clipboard on the chosen canvas, whichever app they come from."),
             "edit-paste",
             {QKeySequence::Paste},
             draw},
            [this] { pasteStrokes(); });
    all.add({"draw.next",
             tr("Ne&xt drawing"),
             tr("Goes to the next drawing of the canvas."),
             {},
             {QKeySequence(Qt::Key_Down)},
             draw},
            [this] { mDrawing->strip().step(1); });
    all.add({"draw.previous",
             tr("P&revious drawing"),
             tr("Goes to the drawing before."),
             {},
             {QKeySequence(Qt::Key_Up)},
             draw},
            [this] { mDrawing->strip().step(-1); });
}

void StudioWindow::fillMenus()
{
    const auto named = [this](std::initializer_list<const char *> ids) {
        QList<QAction *> list;
        for (const char *id : ids)
            list << actions().action(QLatin1String(id));
        return list;
    };
    addToMenu(fileMenu(), named({"file.open", "file.start", "file.save", "file.saveAs", "file.pack",
                                 "file.place", "file.updatePaintings", "file.export"}));
    menu(tr("&Canvas"))
        ->addActions(named({"canvas.follow", "canvas.stay", "canvas.face", "canvas.previousKeyframe",
                            "canvas.nextKeyframe", "canvas.duplicate", "canvas.remove", "scene.analyse"}));
    menu(tr("&Draw"))
        ->addActions(named({"draw.pen", "draw.fill", "draw.arrow", "draw.words", "draw.sticker",
                            "draw.eraser", "draw.move", "draw.copy", "draw.paste", "draw.wider",
                            "draw.narrower", "draw.onion", "draw.addDrawing", "draw.duplicateDrawing",
                            "draw.removeDrawing", "draw.next", "draw.previous"}));
    menu(tr("&Play"))
        ->addActions(named({"play.toggle", "play.back", "play.forward", "play.start", "play.end",
                            "play.reverse", "play.stop", "play.faster", "play.sound"}));
}

void StudioWindow::openManual(const QString &topic)
{
    auto *help = findChild<HelpWindow *>();
    if (!help)
        help = new HelpWindow(QStringLiteral(":/manual/doodlestudio.md"), this);
    QString heading;
    if (const ActionSpec *spec = actions().spec(topic))
        heading = plainText(spec->text);
    help->show();
    help->raise();
    if (heading.isEmpty() || !help->showSection(heading))
        help->showSection(topic.isEmpty() ? QStringLiteral("DoodleStudio") : topic);
}

} // namespace ductus
