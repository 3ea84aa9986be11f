#include "layerpainter/ui/panels/motion_bar.h"

#include "document/commands/change_value.h"
#include "layerpainter/film/film_plan.h"
#include "layerpainter/ui/panels/key_track.h"
#include "layerpainter/ui/panels/motion_tracks.h"
#include "layerpainter/ui/view/painting_view.h"
#include "widgets/controls/number_slider.h"
#include "widgets/theme/icons.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr double stillLength = 4; // seconds offered where nothing moves yet
constexpr int frameMilliseconds = 40;
constexpr double sameTime = 1e-3; // seconds

} // namespace

MotionBar::MotionBar(PaintingDocument &document, PaintingView &view, QWidget *parent)
    : QWidget(parent), mDocument(document), mView(view)
{
    auto *all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->setSpacing(0);
    auto *layout = new QHBoxLayout;
    all->addLayout(layout);
    mTracks = new MotionTracks(document, view);
    all->addWidget(mTracks);
    layout->setContentsMargins(12, 2, 12, 6);
    layout->setSpacing(8);
    mPlay = button(QStringLiteral("media-playback-start"), tr("Play"),
                   tr("Plays motion, drawings and camera path; again stops. Key Space."));
    mTrack = new KeyTrack;
    mText = new QLabel;
    mText->setMinimumWidth(90);
    QToolButton *keep = button(QStringLiteral("keyframe-add"), tr("Keep view"),
                               tr("Where you look from now becomes a key of the camera path, here in time."));
    mRemove = button(QStringLiteral("edit-delete"), tr("Remove key"),
                     tr("Takes away the camera's key under the playhead."));
    mFollow = button(QStringLiteral("peek"), tr("Through the camera"),
                     tr("The view follows the camera path while time goes on."));
    mFollow->setCheckable(true);
    mFollow->setChecked(true);
    mLength = new NumberSlider(tr("Loop"), {0, 60, 0.5, 0, 1, tr("s")},
                               tr("After this time all begins again; 0: no loop."));
    mLength->setMaximumWidth(260);
    layout->addWidget(mPlay);
    layout->addWidget(mTrack, 1);
    layout->addWidget(mText);
    for (QToolButton *each : {keep, mRemove, mFollow})
        layout->addWidget(each);
    layout->addWidget(mLength);

    connect(mPlay, &QToolButton::clicked, this, [this] { setPlaying(!isPlaying()); });
    connect(keep, &QToolButton::clicked, this, &MotionBar::keepView);
    connect(mRemove, &QToolButton::clicked, this, &MotionBar::removeKey);
    connect(mTrack, &KeyTrack::scrubbed, this, [this](double seconds) {
        setPlaying(false);
        show(seconds);
    });
    connect(mTracks, &MotionTracks::scrubbed, this, [this](double seconds) {
        setPlaying(false);
        show(seconds);
    });
    connect(mLength, &NumberSlider::editBegun, this, [this] { mDrag = nextDrag(); });
    connect(mLength, &NumberSlider::valueChanged, this, [this](double seconds) {
        act::SetScene edit;
        edit.loopSeconds = seconds;
        (void)mDocument.perform(edit, mDrag);
    });
    mTimer.setInterval(frameMilliseconds);
    mTimer.setTimerType(Qt::PreciseTimer);
    connect(&mTimer, &QTimer::timeout, this, &MotionBar::advance);
    connect(&mDocument, &Document::changed, this, [this](const ChangeEvent &event) {
        const auto *change = event.as<PaintingChanged>();
        if (!change) {
            setPlaying(false);
            show(0);
        }
        if (!change || change->scene || change->layers)
            refresh();
    });
    refresh();
    show(0);
}

QToolButton *MotionBar::button(const QString &iconName, const QString &name, const QString &teaches)
{
    auto *made = new QToolButton;
    made->setIcon(icon(iconName));
    made->setIconSize({20, 20});
    made->setAutoRaise(true);
    made->setAccessibleName(name);
    made->setToolTip(QStringLiteral("<b>%1</b><br>%2").arg(name, teaches));
    return made;
}

void MotionBar::setPlaying(bool playing)
{
    if (playing == isPlaying())
        return;
    mPlay->setIcon(
        icon(playing ? QStringLiteral("media-playback-pause") : QStringLiteral("media-playback-start")));
    mPlay->setAccessibleName(playing ? tr("Stop") : tr("Play"));
    if (!playing) {
        mTimer.stop();
        return;
    }
    if (mView.seconds() >= mTrack->length() - 1e-9)
        show(0);
    mClock.start();
    mTimer.start();
}

void MotionBar::setSeconds(double seconds)
{
    show(seconds);
}

void MotionBar::advance()
{
    // As much time as has passed: slow frames leave moments out instead of slowing the motion.
    const double seconds = mView.seconds() + double(mClock.restart()) / 1000;
    const double length = mTrack->length();
    show(seconds < length ? seconds : std::fmod(seconds, length));
}

void MotionBar::show(double seconds)
{
    mTrack->setSeconds(seconds);
    mTracks->setTime(seconds, mTrack->length());
    mText->setText(tr("%1 / %2 s").arg(seconds, 0, 'f', 2).arg(mTrack->length(), 0, 'f', 1));
    mRemove->setEnabled(mTrack->isOnCameraKey());
    mView.setSeconds(seconds, mFollow->isChecked());
}

void MotionBar::refresh()
{
    const Painting &painting = mDocument.painting();
    const double moves = motionSeconds(painting);
    // Room behind the last key for the next one.
    mTrack->setLength(painting.loopSeconds > 0 ? moves
                      : moves > 0              ? std::max(moves, stillLength)
                                               : stillLength);
    std::vector<TrackKey> keys;
    for (const CameraKey &key : painting.camera.keys)
        keys.push_back({key.timeSeconds, true});
    for (const Layer *layer : painting.layers())
        for (const PlacementKey &key : layer->motion)
            keys.push_back({key.timeSeconds, false});
    for (const MotionGroup &group : painting.motionGroups)
        for (const PlacementKey &key : group.keys)
            keys.push_back({key.timeSeconds, false});
    mTrack->setKeys(std::move(keys));
    mTracks->setTime(mView.seconds(), mTrack->length());
    mLength->setValue(painting.loopSeconds);
    mText->setText(tr("%1 / %2 s").arg(mView.seconds(), 0, 'f', 2).arg(mTrack->length(), 0, 'f', 1));
    mRemove->setEnabled(mTrack->isOnCameraKey());
}

void MotionBar::keepView()
{
    CameraKey key = mView.camera().key();
    key.timeSeconds = mView.seconds();
    std::vector<CameraKey> keys = mDocument.painting().camera.keys;
    std::erase_if(keys,
                  [&](const CameraKey &k) { return std::abs(k.timeSeconds - key.timeSeconds) < sameTime; });
    keys.insert(std::ranges::upper_bound(keys, key.timeSeconds, {}, &CameraKey::timeSeconds), key);
    (void)mDocument.perform(act::SetCamera{std::move(keys)});
}

void MotionBar::removeKey()
{
    std::vector<CameraKey> keys = mDocument.painting().camera.keys;
    const double now = mView.seconds();
    if (std::erase_if(keys, [&](const CameraKey &k) { return std::abs(k.timeSeconds - now) < sameTime; }) > 0)
        (void)mDocument.perform(act::SetCamera{std::move(keys)});
}

} // namespace ductus
