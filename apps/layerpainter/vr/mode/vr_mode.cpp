#include "layerpainter/vr/mode/vr_mode.h"

#include "document/words/engine_words.h"
#include "layerpainter/document/default_view.h"
#include "layerpainter/vr/draw/eye_camera.h"

#include <QOpenGLExtraFunctions>

namespace ductus {

namespace {

constexpr int idleMilliseconds = 40, patienceMilliseconds = 3000, mirrorMilliseconds = 33;

} // namespace

VrMode::VrMode(PainterWindow &window, QObject *parent) : QObject(parent), mWindow(window), mTools(window)
{
    mTools.setTick([this](Hand hand, double strength, double seconds) { tick(hand, strength, seconds); });
    mIdle.setInterval(idleMilliseconds);
    connect(&mIdle, &QTimer::timeout, this, &VrMode::takeEvents);
    mPatience.setSingleShot(true);
    mPatience.setInterval(patienceMilliseconds);
    connect(&mPatience, &QTimer::timeout, this, [this] { end(std::nullopt); });
    mMirrorPace.setInterval(mirrorMilliseconds);
    connect(&mMirrorPace, &QTimer::timeout, this, [this] { mWindow.view().update(); });
    connect(&mWindow.painting(), &PaintingDocument::refused, this, [this](const Error &error) {
        if (mPanels)
            mPanels->tell(engineWords(error.problem));
    });
    connect(&mWindow.painting(), &Document::changed, this, [this](const ChangeEvent &event) {
        if (isActive() && event.as<DocumentReset>())
            placeFirst();
    });
}

VrMode::~VrMode()
{
    release();
}

Result<void> VrMode::start()
{
    if (isActive())
        return {};
    Result<void> made = createParts();
    if (!made) {
        release();
        return made;
    }
    placeFirst();
    ++mRun;
    mWaiter = std::make_unique<FrameWaiter>(*mSession, [this, run = mRun](Result<FrameTime> time) {
        QMetaObject::invokeMethod(
            this,
            [this, run, time] {
                if (run == mRun)
                    onFrame(time);
            },
            Qt::QueuedConnection);
    });
    if (mContext->shareContext()) {
        mWindow.view().setStandIn(
            [this](unsigned framebuffer, const QSize &size) { drawMirror(framebuffer, size); });
        mMirrorPace.start();
    }
    mFrameCount = 0;
    mGapClock.invalidate();
    mIdle.start();
    takeEvents();
    return {};
}

Result<void> VrMode::createParts()
{
    Result<std::unique_ptr<HeadsetRuntime>> runtime = HeadsetRuntime::find();
    if (!runtime)
        return runtime.error();
    mRuntime = std::move(*runtime);
    if (Result<void> made = makeContext(); !made)
        return made;
    Result<std::unique_ptr<HeadsetSession>> session = HeadsetSession::create(*mRuntime);
    if (!session)
        return session.error();
    mSession = std::move(*session);
    Result<std::unique_ptr<HandActions>> actions = HandActions::create(*mRuntime, *mSession);
    if (!actions)
        return actions.error();
    mActions = std::move(*actions);
    Result<std::unique_ptr<EyePainter>> painter = EyePainter::create(*mRuntime, *mSession);
    if (!painter)
        return painter.error();
    mPainter = std::move(*painter);
    mPanels = std::make_unique<RoomPanels>(mWindow);
    mPanels->setLeftHanded(isLeftHanded());
    connect(mPanels.get(), &RoomPanels::leftHandedWanted, this, &VrMode::setLeftHanded);
    connect(mPanels.get(), &RoomPanels::leaveWanted, this, &VrMode::stop);
    connect(mPanels.get(), &RoomPanels::entered, this, [this] { tick(mTools.paintingHand(), 0.15, 0); });
    return {};
}

// A context of our own, which shares textures with the view's so that the view can show what the eye sees.
Result<void> VrMode::makeContext()
{
    PaintingView &view = mWindow.view();
    if (!view.context())
        (void)view.grabFramebuffer(); // makes it
    mContext = std::make_unique<QOpenGLContext>();
    if (view.context()) {
        mContext->setFormat(view.context()->format());
        mContext->setShareContext(view.context());
    } else {
        mContext->setFormat(view.format());
    }
    mSurface = std::make_unique<QOffscreenSurface>();
    const bool isMade = mContext->create();
    mSurface->setFormat(mContext->format());
    mSurface->create();
    if (!isMade || !mContext->makeCurrent(mSurface.get()))
        return Error{ErrorCode::Unsupported,
                     "Entering VR",
                     "no OpenGL context could be made",
                     "Update the graphics driver",
                     {}};
    return {};
}

void VrMode::placeFirst()
{
    const Painting &painting = mWindow.painting().painting();
    mTools.setRoomFromScene(firstPlacement(mWindow.view().camera().key(), paintingBox(painting).diagonal(),
                                           painting.metresPerUnit));
}

void VrMode::setLeftHanded(bool leftHanded)
{
    mTools.setPaintingHand(leftHanded ? Hand::Left : Hand::Right);
    if (mPanels)
        mPanels->setLeftHanded(leftHanded);
}

void VrMode::stop()
{
    if (!isActive() || mPatience.isActive())
        return;
    mTools.perform(mCommands.endAll(), mInput);
    if (!mSession->isRunning() || !mSession->requestExit()) {
        // Not from inside a frame or a panel's button.
        QTimer::singleShot(0, this, [this, run = mRun] {
            if (run == mRun)
                end(std::nullopt);
        });
        return;
    }
    mPatience.start();
}

void VrMode::onFrame(Result<FrameTime> time)
{
    mIsWaiting = false;
    // A menu on a panel runs an event loop of its own: no frame inside a frame.
    if (!isActive() || mIsInFrame)
        return;
    if (!time) {
        end(time.error());
        return;
    }
    if (mGapClock.isValid())
        mLongestGap = std::max(mLongestGap, double(mGapClock.nsecsElapsed()) * 1e-6);
    mGapClock.start();
    mIsInFrame = true;
    const Result<void> drawn = drawFrame(*time);
    mIsInFrame = false;
    mLastFrameMilliseconds = double(mGapClock.nsecsElapsed()) * 1e-6;
    ++mFrameCount;
    if (!drawn) {
        end(drawn.error());
        return;
    }
    takeEvents();
    emit frameDone();
}

Result<void> VrMode::drawFrame(const FrameTime &time)
{
    if (Result<void> begun = mSession->begin(); !begun)
        return begun;
    if (!mContext->makeCurrent(mSurface.get()))
        return Error{ErrorCode::Unsupported, "Painting in VR", "the OpenGL context is gone", {}, {}};
    Result<std::vector<EyeView>> eyes = std::vector<EyeView>();
    if (time.shouldDraw)
        eyes = mSession->views(time.display);
    if (!eyes)
        return eyes.error();
    mInput.seconds = mLastDisplay > 0 ? std::min(0.1, double(time.display - mLastDisplay) * 1e-9) : 0;
    mLastDisplay = time.display;
    if (Result<void> read = mActions->read(time.display, mInput); !read)
        return read;
    readHands(time, *eyes);
    if (eyes->empty())
        return mSession->end(time.display, nullptr);
    mShapes.clear();
    mMarks.update(mWindow.painting().sharedPainting(), mWindow.view().seconds(), mWindow.view().selection(),
                  mPanels->hoveredLayer());
    mMarks.add(mShapes, mTools.roomFromScene());
    mPanels->rig().draw(mShapes);
    addHands(mShapes, mInput, mTools, mWindow.brush().colour, mPointed);
    return mPainter->draw(*mSession, time.display, *eyes, mTools.shown(), mWindow.view().seconds(),
                          mTools.roomFromScene(), mShapes);
}

void VrMode::readHands(const FrameTime &, const std::vector<EyeView> &eyes)
{
    if (!eyes.empty()) {
        mInput.head = roomPose(eyes.front().pose);
        mInput.head.position = 0.5 * (mInput.head.position + roomPose(eyes.back().pose).position);
    }
    PanelRig &rig = mPanels->rig();
    const Hand holding = other(mTools.paintingHand());
    const HandInput &holder = mInput.of(holding);
    if (holder.isTracked)
        rig.follow(holder.grip, mInput.head);
    mPointed = mTools.isPainting() ? std::nullopt : pointed();
    const HandSituation situation{mTools.mode(), mTools.paintingHand(), mPointed.has_value(),
                                  !mWindow.view().selection().empty()};
    const std::vector<HandCommand> commands = mCommands.read(mInput, situation);
    const bool isOnLayers = mPointed && mPointed->panel == RoomPanels::layerPlace;
    mTools.setDropLayer(isOnLayers ? mPanels->hoveredLayer() : std::nullopt);
    point(commands);
    mTools.perform(commands, mInput);
}

std::optional<PanelHit> VrMode::pointed() const
{
    const HandInput &hand = mInput.of(mTools.paintingHand());
    if (!hand.isTracked || !mPanels->rig().isShown())
        return std::nullopt;
    // Near a panel the tip counts, farther away the ray.
    constexpr double touchReach = 0.03; // metres
    if (const auto touched = mPanels->rig().touch(hand.aim.position, touchReach))
        return touched;
    return mPanels->rig().hit(hand.aim);
}

// What the hands do to the panels.
void VrMode::point(const std::vector<HandCommand> &commands)
{
    PanelRig &rig = mPanels->rig();
    const auto has = [&](HandCommand::Kind kind) {
        return std::ranges::any_of(commands, [kind](const HandCommand &c) { return c.kind == kind; });
    };
    for (const HandCommand &command : commands) {
        if (command.kind == HandCommand::Kind::TurnPanels)
            rig.turn(int(command.value));
        else if (command.kind == HandCommand::Kind::ShowPanels)
            rig.setShown(!rig.isShown());
    }
    constexpr double touchOn = 0.003, touchOff = 0.012; // metres above the panel
    const bool isTip = mPointed && mPointed->distance == 0;
    const bool pressesByTip =
        mPressed < 0 && isTip && mPointed->height <= touchOn && mPointed->height > -0.02;
    const bool liftsTip = mIsTouched && (!isTip || mPointed->height > touchOff);
    for (int i = 0; i < rig.count(); ++i) {
        const bool isHere = mPointed && mPointed->panel == i;
        PanelSurface &panel = rig.panel(i);
        if (isHere)
            panel.hover(mPointed->at);
        else if (mPressed != i)
            panel.leave();
        if (isHere && mPressed < 0 && (has(HandCommand::Kind::PressPanel) || pressesByTip)) {
            panel.press(mPointed->at);
            mPressed = i;
            mIsTouched = pressesByTip;
            tick(mTools.paintingHand(), 0.4, 0.01);
        } else if (mPressed == i && (mIsTouched ? liftsTip : has(HandCommand::Kind::ReleasePanel))) {
            panel.release(isHere ? mPointed->at : QPointF(-1, -1));
            mPressed = -1;
            mIsTouched = false;
        }
    }
}

void VrMode::takeEvents()
{
    if (!isActive())
        return;
    const Result<SessionNews> news = mSession->takeEvents();
    if (!news) {
        end(news.error());
        return;
    }
    if (news->lost) {
        end(Error{ErrorCode::ReadFailed,
                  "Painting in VR",
                  "the connection to the headset was lost",
                  "The painting is still here; connect the headset and enter VR again",
                  {}});
        return;
    }
    if (news->focusLost || news->stopped)
        mTools.perform(mCommands.endAll(), mInput);
    if (news->finished) {
        end(std::nullopt);
        return;
    }
    goOn();
}

// Asks for the next frame, or waits for events while there is none to be had.
void VrMode::goOn()
{
    if (!mSession->isRunning()) {
        if (!mIdle.isActive())
            mIdle.start();
        return;
    }
    mIdle.stop();
    if (!mIsWaiting) {
        mIsWaiting = true;
        mWaiter->request();
    }
}

void VrMode::end(const std::optional<Error> &error)
{
    if (!isActive())
        return;
    mTools.perform(mCommands.endAll(), mInput);
    release();
    emit ended(error ? QString::fromStdString(error->message()) : QString());
}

void VrMode::release()
{
    ++mRun;
    mIdle.stop();
    mPatience.stop();
    mMirrorPace.stop();
    if (mWaiter)
        mWindow.view().setStandIn({});
    mWaiter.reset();
    mIsWaiting = false;
    if (mContext && mSurface)
        mContext->makeCurrent(mSurface.get());
    mPointed.reset();
    mPressed = -1;
    mIsTouched = false;
    mShapes.clear();
    if (mPanels) {
        mPanels->rig().releaseTextures();
        mPanels.release()->deleteLater(); // one of its buttons may be what ends it
    }
    mPainter.reset();
    mActions.reset();
    mSession.reset();
    mRuntime.reset();
    if (mContext)
        mContext->doneCurrent();
    mContext.reset();
    mSurface.reset();
    mLastDisplay = 0;
}

double VrMode::takeLongestGapMilliseconds()
{
    return std::exchange(mLongestGap, 0.0);
}

// In the view's context: fills the window with the middle of what the eye sees.
void VrMode::drawMirror(unsigned framebuffer, const QSize &size)
{
    QOpenGLExtraFunctions *gl = mWindow.view().context()->extraFunctions();
    GLuint source = 0;
    gl->glGenFramebuffers(1, &source);
    gl->glBindFramebuffer(GL_READ_FRAMEBUFFER, source);
    gl->glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, mPainter->mirror(),
                               0);
    gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    const int width = mPainter->mirrorWidth(), height = mPainter->mirrorHeight();
    int w = width, h = height;
    if (w * size.height() > h * size.width())
        w = h * size.width() / std::max(1, size.height());
    else
        h = w * size.height() / std::max(1, size.width());
    const int x = (width - w) / 2, y = (height - h) / 2;
    gl->glBlitFramebuffer(x, y, x + w, y + h, 0, 0, size.width(), size.height(), GL_COLOR_BUFFER_BIT,
                          GL_LINEAR);
    gl->glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl->glDeleteFramebuffers(1, &source);
}

void VrMode::tick(Hand hand, double strength, double seconds)
{
    if (mActions && mSession && mSession->hasFocus())
        mActions->tick(hand, strength, seconds);
}

} // namespace ductus
