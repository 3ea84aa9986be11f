#include "doodlestudio/ui/window/studio_window.h"

#include "document/recovery/state_folder.h"
#include "doodlestudio/ui/player/player_view.h"
#include "doodlestudio/ui/timeline/timeline_view.h"
#include "doodlestudio/ui/timeline/transport_bar.h"
#include "widgets/controls/segmented_switch.h"
#include "widgets/shell/message_bar.h"
#include "widgets/theme/icons.h"

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
      mUnsaved(*this, mDoodle, stateFolder(QStringLiteral("doodlestudio"), QStringLiteral("autosave"))),
      mRecent(*services.settings,
              QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + QStringLiteral("/recent"))
{
    buildCanvas();
    setDocument(&mDoodle);
    addFileActions();
    addPlayActions();
    fillMenus();
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
    mSplitter = new QSplitter(Qt::Horizontal);
    mSplitter->setChildrenCollapsible(false);
    mSplitter->addWidget(mPlayer);
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

void StudioWindow::connectParts()
{
    connect(&mDoodle, &Document::changed, this, &StudioWindow::onDocumentChanged);
    connect(&mPlayback, &Playback::frameChanged, this, &StudioWindow::showFrame);
    connect(&mFrames, &FrameStore::frameReady, this, [this](int frame) {
        if (frame == mPlayback.frame())
            showFrame(frame);
    });
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
    connect(&mUnsaved, &UnsavedWork::opened, this, &StudioWindow::findClip);
    connect(&mUnsaved.autosave(), &Autosave::aboutToWrite, this, [this] {
        mDoodle.setSnapshotFolder({});
        mDoodle.setPicture(mPlayer->grabPicture());
    });
    mUnsaved.autosave().setBusyCheck([this] { return mPlayer->isBusy() || mTimeline->isDragging(); });
    connect(this, &MainWindowShell::closing, &mPlayback, &Playback::stop);
    setStep(StudioStep::Place);
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
    mFrames.setMostLines(lines);
    showFrame(mPlayback.frame());
}

void StudioWindow::showFrame(int frame)
{
    mFrames.want(frame, mPlayback.rate() < 0.0 ? -1 : 1);
    QImage picture = mFrames.frame(frame);
    const bool isExact = !picture.isNull();
    if (!isExact)
        picture = mFrames.nearest(frame);
    const bool isFirst = mPlayer->picture().isNull() && isExact;
    if (!picture.isNull())
        mPlayer->setPicture(picture);
    mTimeline->setFrame(frame);
    if (isFirst)
        emit clipShown();
}

void StudioWindow::onDocumentChanged(const ChangeEvent &event)
{
    if (event.as<ShotChanged>() || event.as<DocumentReset>())
        showSceneWords();
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
