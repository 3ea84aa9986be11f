#include "doodlestudio/ui/window/studio_window.h"

#include "document/recovery/state_folder.h"
#include "doodlestudio/ui/canvases/canvas_list.h"
#include "doodlestudio/ui/canvases/canvas_panel.h"
#include "doodlestudio/ui/canvases/timeline_rows.h"
#include "doodlestudio/ui/drawing/drawing_panel.h"
#include "doodlestudio/ui/player/player_view.h"
#include "doodlestudio/ui/timeline/timeline_view.h"
#include "doodlestudio/ui/timeline/transport_bar.h"
#include "widgets/controls/segmented_switch.h"
#include "widgets/pages/tablet_page.h"
#include "widgets/shell/message_bar.h"
#include "widgets/theme/icons.h"

#include <QMenu>
#include <QSplitter>
#include <QStandardPaths>
#include <QVBoxLayout>

namespace ductus {

namespace {

constexpr int fewestLines = 240, mostLines = 720;

} // namespace

StudioWindow::StudioWindow(const ShellServices &services, QWidget *parent)
    : MainWindowShell({tr("DoodleStudio"), AppKind::DoodleStudio, QStringLiteral("app-doodlestudio")},
                      services, parent),
      mFollower(mDoodle, *services.jobs), mState(mDoodle, mFollower), mHandles(mState), mOcclusion(mState),
      mCanvases(mState), mHand(mState), mDirect(mState, mHand), mPreview(mState, mFrames),
      mUnsaved(*this, mDoodle, stateFolder(QStringLiteral("doodlestudio"), QStringLiteral("autosave"))),
      mLog(mDoodle, *services.actions,
           [this] {
               const Canvas *canvas = mState.chosenCanvas();
               return LogPlace{canvas ? QString::fromStdString(canvas->name) : QString(), mState.frame()};
           }),
      mRecent(*services.settings,
              QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + QStringLiteral("/recent"))
{
    buildCanvas();
    setDocument(&mDoodle);
    addFileActions();
    addPlayActions();
    addCanvasActions();
    addDrawingActions();
    addLogActions();
    fillMenus();
    fillInspector();
    fillStartPage();
    connectParts();
    mUnsaved.look();
}

StudioWindow::~StudioWindow()
{
    jobs().cancelAll();
    mPlayback.stop();
    mFrames.setClip(nullptr);
    setDocument(nullptr);
    setCanvas(nullptr);
}

void StudioWindow::buildCanvas()
{
    mSteps = new SegmentedSwitch(
        tr("Step"), {{tr("1  Place"), tr("Put a canvas where the drawing should be."), icon("canvas")},
                     {tr("2  Pin"), tr("Say where the canvas must be; it follows in between."), icon("pin")},
                     {tr("3  Draw"), tr("Draw on the canvas, seen from the front."), icon("draw-freehand")}});
    setCentre(mSteps);
    mPlayer = new PlayerView;
    mPlayer->setProperty("helpTopic", "canvas");
    mPlayer->addLayer(&mCanvases);
    mSplitter = new QSplitter(Qt::Horizontal);
    mSplitter->setChildrenCollapsible(false);
    mSplitter->addWidget(mPlayer);
    mDrawing = new DrawingPanel(mState, mHand);
    mDrawing->setProperty("helpTopic", "drawing");
    mDrawing->hide();
    mSplitter->addWidget(mDrawing);
    mSplitter->setStretchFactor(0, 3);
    mSplitter->setStretchFactor(1, 2);
    setCanvas(mSplitter);

    auto *strip = new QWidget;
    auto *rows = new QVBoxLayout(strip);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    mTransport = new TransportBar(mPlayback);
    mTimeline = new TimelineView;
    mTimeline->setFixedHeight(168);
    rows->addWidget(mTransport);
    rows->addWidget(mTimeline);
    setStrip(strip);
}

void StudioWindow::fillInspector()
{
    mCanvasList = new CanvasList(mState);
    addSection(QStringLiteral("canvases"), tr("Canvases"), mCanvasList);
    mCanvasPanel = new CanvasPanel(mState);
    addSection(QStringLiteral("canvas"), tr("This canvas"), mCanvasPanel);
    connect(
        mCanvasPanel, &CanvasPanel::occlusionBrushChosen, this, [this](CanvasPanel::OcclusionBrush brush) {
            mOcclusion.setInFront(brush == CanvasPanel::OcclusionBrush::InFront);
            if (brush == CanvasPanel::OcclusionBrush::Off) {
                applyStep();
                return;
            }
            mPlayer->setTool(&mOcclusion);
            setHint(brush == CanvasPanel::OcclusionBrush::InFront
                        ? tr("Brush where the canvas must be seen; it counts in the frames around, too.")
                        : tr("Brush where the canvas must be hidden; it counts in the frames around, too."));
        });
}

void StudioWindow::connectParts()
{
    connect(mSteps, &SegmentedSwitch::currentChanged, this, [this] {
        mCanvasPanel->setOcclusionBrush(CanvasPanel::OcclusionBrush::Off); // applies the step
    });
    connect(&mState, &StudioState::lookChanged, mPlayer, qOverload<>(&QWidget::update));
    connect(&mState, &StudioState::frameRequested, &mPlayback, [this](int frame) {
        mPlayback.stop();
        mPlayback.setFrame(frame);
    });
    connect(&mDoodle, &DoodleDocument::refused, this, [this](const Error &error) { showError(error); });
    connect(&mHandles, &HandlesTool::hinted, this, [this](const QString &sentence) {
        if (!sentence.isEmpty())
            setHint(sentence);
    });
    connectTimeline();
    connect(&mDoodle, &Document::changed, this, &StudioWindow::onDocumentChanged);
    connect(&mPlayback, &Playback::frameChanged, this, &StudioWindow::showFrame);
    connect(&mFrames, &FrameStore::frameReady, this, [this](int frame) {
        if (frame == mPlayback.frame())
            showPicture();
    });
    connect(&mPreview, &FilmPreview::ready, this, [this](int frame) {
        if (frame == mPlayback.frame())
            showPicture();
    });
    connect(&mState, &StudioState::lookChanged, this, &StudioWindow::showPicture);
    connect(&mHand, &DrawingHand::changed, mPlayer, qOverload<>(&QWidget::update));
    const auto useCurve = [this] {
        mHand.setPressureCurve(PressureCurve::fromText(settings().value(pressureCurveSetting)));
    };
    useCurve();
    connect(&settings(), &Settings::changed, this, useCurve);
    connect(&mFrames, &FrameStore::failed, this, [this](const Error &error) { showError(error); });
    connect(mPlayer, &PlayerView::resized, this, &StudioWindow::updatePictureSize);
    connect(mTimeline, &TimelineView::scrubBegun, this, [this] {
        mWasPlaying = mPlayback.isPlaying();
        mPlayback.stop();
    });
    connect(mTimeline, &TimelineView::scrubbed, &mPlayback, &Playback::setFrame);
    connect(mTimeline, &TimelineView::scrubEnded, this, [this] {
        if (mWasPlaying)
            mPlayback.play();
    });
    connect(this, &MainWindowShell::filesDropped, this, [this](const QStringList &paths) {
        if (!paths.isEmpty())
            openPath(paths.first());
    });
    connect(this, &MainWindowShell::helpRequested, this, &StudioWindow::openManual);
    connect(&mLinkWatcher, &LinkWatcher::worthALook, this, [this] { lookForNewerPaintings(false); });
    connect(&mDoodle, &Document::changed, this, [this](const ChangeEvent &event) {
        if (event.as<DocumentReset>())
            mOffered.clear();
        if (event.as<DocumentReset>() || event.as<SceneChanged>())
            watchPaintings();
    });
    connect(&mUnsaved, &UnsavedWork::opened, this, &StudioWindow::findClip);
    connect(&mUnsaved.autosave(), &Autosave::aboutToWrite, this, [this] {
        mDoodle.setSnapshotFolder({});
        mDoodle.setPicture(mPlayer->grabPicture());
    });
    mUnsaved.autosave().setBusyCheck(
        [this] { return mPlayer->isBusy() || mTimeline->isDragging() || mHand.isDrawing(); });
    connect(this, &MainWindowShell::closing, &mPlayback, &Playback::stop);
    setStep(StudioStep::Place);
    applyStep();
}

void StudioWindow::connectTimeline()
{
    mRowsTimer.setSingleShot(true);
    mRowsTimer.setInterval(0);
    connect(&mRowsTimer, &QTimer::timeout, this, &StudioWindow::refreshRows);
    connect(&mState, &StudioState::lookChanged, &mRowsTimer, qOverload<>(&QTimer::start));
    connect(mTimeline, &TimelineView::rowChosen, this, [this](int id) { mState.choose(CanvasId{id}); });
    connect(mTimeline, &TimelineView::markMoved, this, [this](int id, const TimelineMark &mark, int frame) {
        if (const Canvas *canvas = mDoodle.canvas(CanvasId{id}))
            mDoodle.editCanvas(tr("Move keyframe"),
                               withMovedKeyframe(*canvas, keyframeKind(mark.kind), mark.frame, frame));
    });
    const auto remove = [this](int id, const TimelineMark &mark) {
        if (const Canvas *canvas = mDoodle.canvas(CanvasId{id}))
            mDoodle.editCanvas(tr("Take keyframe away"),
                               withoutKeyframe(*canvas, keyframeKind(mark.kind), mark.frame));
    };
    connect(mTimeline, &TimelineView::markRemoveRequested, this, remove);
    connect(mTimeline, &TimelineView::markMenuRequested, this,
            [this, remove](int id, const TimelineMark &mark, const QPoint &at) {
                QMenu menu;
                if (mark.kind == TimelineMarkKind::Position || mark.kind == TimelineMarkKind::Turn) {
                    QAction *straight = menu.addAction(tr("Go &straight to the next keyframe"));
                    straight->setCheckable(true);
                    straight->setChecked(mark.interpolatesNext);
                    connect(straight, &QAction::triggered, this, [this, id, mark](bool on) {
                        if (const Canvas *canvas = mDoodle.canvas(CanvasId{id}))
                            mDoodle.editCanvas(
                                on ? tr("Go straight") : tr("Follow the scene"),
                                withInterpolation(*canvas, keyframeKind(mark.kind), mark.frame, on));
                    });
                }
                menu.addAction(icon("edit-delete"), tr("&Take keyframe away"), this,
                               [remove, id, mark] { remove(id, mark); });
                menu.exec(at);
            });
    connect(mTimeline, &TimelineView::drawingChosen, this,
            [this](int id, int) { mState.choose(CanvasId{id}); });
}

void StudioWindow::refreshRows()
{
    mTimeline->setRows(mDoodle.isEmpty() ? QList<TimelineRow>() : timelineRows(mState));
}

void StudioWindow::goToKeyframe(int direction)
{
    const Canvas *canvas = mState.chosenCanvas();
    if (!canvas)
        return;
    std::optional<int> nearest;
    const auto consider = [&](int frame) {
        const int way = (frame - mState.frame()) * direction;
        if (way > 0 && (!nearest || way < (*nearest - mState.frame()) * direction))
            nearest = frame;
    };
    for (const CanvasKeyframe &key : canvas->keyframes.positions)
        consider(key.frame);
    for (const DepthKeyframe &key : canvas->keyframes.depths)
        consider(key.frame);
    for (const TurnKeyframe &key : canvas->keyframes.turns)
        consider(key.frame);
    for (const ScaleKeyframe &key : canvas->keyframes.scales)
        consider(key.frame);
    if (nearest)
        mState.requestFrame(*nearest);
}

void StudioWindow::applyStep()
{
    mHandles.setAdding(step() == StudioStep::Place);
    const bool isDrawing = step() == StudioStep::Draw;
    mPlayer->setTool(isDrawing ? static_cast<PlayerTool *>(&mDirect) : &mHandles);
    // The panel stands where the inspector was: numbers would only be in the way of drawing.
    mDrawing->setVisible(isDrawing);
    if (!isStartPageShown())
        setInspectorVisible(!isDrawing);
    if (isDrawing && !mState.chosenCanvas() && !mDoodle.scene().canvases.empty())
        mState.choose(mDoodle.scene().canvases.back().id);
    switch (step()) {
    case StudioStep::Place:
        setHint(tr("Drag out a box on the picture: a canvas will stand there in the scene."));
        break;
    case StudioStep::Pin:
        setHint(tr("Go to a frame where the canvas is wrong and drag it back: it is pinned there."));
        break;
    case StudioStep::Draw:
        setHint(tr("Draw on the canvas from the front, or straight on the picture."));
        break;
    }
    mPlayer->update();
}

StudioStep StudioWindow::step() const
{
    return StudioStep(mSteps->current());
}

void StudioWindow::setStep(StudioStep step)
{
    mSteps->setCurrent(int(step));
}

void StudioWindow::updatePictureSize()
{
    if (mDoodle.isEmpty())
        return;
    // As many lines as are seen; in steps, so that moving the splitter does not decode everything anew.
    const double seen = mPlayer->pictureRect().height() * devicePixelRatioF();
    int lines = fewestLines;
    while (lines < seen && lines < mostLines)
        lines += 120;
    if (mFrames.setMostLines(lines))
        mPreview.forget();
    showFrame(mPlayback.frame());
}

void StudioWindow::showFrame(int frame)
{
    mFrames.want(frame, mPlayback.rate() < 0.0 ? -1 : 1);
    mPreview.want(frame, mPlayback.isPlaying());
    mState.setFrame(frame);
    mTimeline->setFrame(frame);
    showPicture();
}

void StudioWindow::showPicture()
{
    const int frame = mPlayback.frame();
    QImage raw = mFrames.frame(frame);
    const bool isExact = !raw.isNull();
    if (!isExact)
        raw = mFrames.nearest(frame);
    const bool isFirst = mPlayer->picture().isNull() && isExact;
    mDrawing->view().setPicture(raw);
    const QImage film = mPreview.isNeeded() ? mPreview.picture(frame) : QImage();
    if (mPreview.isUpToDate(frame))
        mHand.forgetLastMark();
    // Until the film's frame is made its drawings are painted over the clip's own.
    mCanvases.setDrawingsVisible(film.isNull());
    if (!film.isNull())
        mPlayer->setPicture(film);
    else if (!raw.isNull())
        mPlayer->setPicture(raw);
    if (isFirst)
        emit clipShown();
}

void StudioWindow::onDocumentChanged(const ChangeEvent &event)
{
    if (event.as<ShotChanged>() || event.as<DocumentReset>()) {
        showSceneWords();
        actions().action(QStringLiteral("file.pack"))->setChecked(mDoodle.packsAnalysis());
    }
}

void StudioWindow::showSceneWords()
{
    if (mDoodle.isEmpty()) {
        mTransport->setSceneWords({}, {});
        return;
    }
    const std::shared_ptr<const Shot> shot = mDoodle.shot();
    if (!shot) {
        mTransport->setSceneWords(tr("The scene is being looked at; you can place and draw already."), {});
        return;
    }
    switch (shot->knowledge) {
    case CameraKnowledge::SolvedCameras:
        mTransport->setSceneWords(tr("The camera's way was found: canvases stand firmly in the scene."),
                                  tr("Positions and distances were measured from how the picture shifts."));
        break;
    case CameraKnowledge::RotationOnly:
        mTransport->setSceneWords(
            tr("The camera turns on the spot: distances are guessed."),
            tr("Set the distance of a canvas by hand where it hides or shows wrongly."));
        break;
    case CameraKnowledge::Tripod:
        mTransport->setSceneWords(
            tr("The camera stands still: distances are guessed."),
            tr("Set the distance of a canvas by hand where it hides or shows wrongly."));
        break;
    }
}

} // namespace ductus
