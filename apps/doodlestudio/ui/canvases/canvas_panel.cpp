#include "doodlestudio/ui/canvases/canvas_panel.h"

#include "document/commands/change_value.h"
#include "doodlestudio/document/placing.h"
#include "doodling/canvas/edit_scene.h"
#include "widgets/controls/number_slider.h"
#include "widgets/controls/segmented_switch.h"
#include "widgets/theme/icons.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

namespace ductus {

CanvasPanel::CanvasPanel(StudioState &state, QWidget *parent) : QWidget(parent), mState(state)
{
    auto *outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    mEmpty = new QLabel;
    mEmpty->setWordWrap(true);
    mEmpty->setProperty("dim", true);
    outer->addWidget(mEmpty);
    mContent = new QWidget;
    auto *layout = new QVBoxLayout(mContent);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    outer->addWidget(mContent);
    buildPlace(layout);
    buildHiding(layout);
    connect(&state, &StudioState::chosenChanged, this, &CanvasPanel::refresh);
    connect(&state, &StudioState::lookChanged, this, &CanvasPanel::refresh);
    connect(&state, &StudioState::frameChanged, this, &CanvasPanel::refresh);
    refresh();
}

void CanvasPanel::buildPlace(QVBoxLayout *layout)
{
    mMotion = new SegmentedSwitch(
        tr("Motion"),
        {{tr("Stays"), tr("The canvas stands still in the scene; only the camera moves past it.")},
         {tr("Follows"), tr("The canvas follows what is under its middle.")}},
        false);
    mMotion->setObjectName(QStringLiteral("motion"));
    layout->addWidget(mMotion);
    connect(mMotion, &SegmentedSwitch::currentChanged, this, [this](int index) { setFollows(index == 1); });
    mPin = new QPushButton(icon("pin"), tr("Pin here"));
    mPin->setObjectName(QStringLiteral("pinHere"));
    mPin->setToolTip(tr("Holds the canvas where it is in this frame. In between it follows."));
    connect(mPin, &QPushButton::clicked, this, &CanvasPanel::pinHere);
    layout->addWidget(mPin);
    mKeyframes = new QLabel;
    mKeyframes->setProperty("dim", true);
    mKeyframes->setWordWrap(true);
    layout->addWidget(mKeyframes);
    mStraight = new QCheckBox(tr("Straight to the next pin"));
    mStraight->setObjectName(QStringLiteral("straight"));
    mStraight->setToolTip(
        tr("From the pin before this frame to the one after it the canvas goes straight and "
           "evenly instead of following what is seen: for where it is hidden too long."));
    layout->addWidget(mStraight);
    connect(mStraight, &QCheckBox::clicked, this, &CanvasPanel::setStraight);

    mDistance = new NumberSlider(tr("Distance"), {0.1, 100.0, 0.1, 10.0, 2, {}, true},
                                 tr("How far the canvas is from the camera. Nearer things hide it."));
    mDistance->setObjectName(QStringLiteral("distance"));
    layout->addWidget(mDistance);
    connect(mDistance, &NumberSlider::editBegun, this, [this] { mDrag = nextDrag(); });
    connect(mDistance, &NumberSlider::valueChanged, this, &CanvasPanel::editDistance);
    mSceneDistance = new QPushButton(tr("Distance from the scene"));
    mSceneDistance->setToolTip(tr("As far as what is under the middle of the canvas."));
    connect(mSceneDistance, &QPushButton::clicked, this, &CanvasPanel::useSceneDistance);
    layout->addWidget(mSceneDistance);
    mSize = new NumberSlider(tr("Size"), {5.0, 1000.0, 1.0, 100.0, 0, QStringLiteral("%"), true},
                             tr("The size of the canvas; its corner on the picture does the same."));
    layout->addWidget(mSize);
    connect(mSize, &NumberSlider::editBegun, this, [this] { mDrag = nextDrag(); });
    connect(mSize, &NumberSlider::valueChanged, this, &CanvasPanel::editSize);
    auto *face = new QPushButton(tr("Face the camera"));
    face->setToolTip(tr("Turns the canvas straight to the camera in this frame."));
    connect(face, &QPushButton::clicked, this, &CanvasPanel::faceCamera);
    layout->addWidget(face);
    mTurns = new QComboBox;
    mTurns->setObjectName(QStringLiteral("turning"));
    mTurns->setAccessibleName(tr("How it turns while it follows"));
    mTurns->setToolTip(tr("What the canvas does between the frames in which you turned it."));
    // In the order of CanvasTurning.
    mTurns->addItems(
        {tr("Turns with the way it goes"), tr("Keeps its direction"), tr("Turns with the thing it is on")});
    const QString teaches[] = {
        tr("Keeps its direction relative to its path, as a sign on a tram does in a bend."),
        tr("Looks where you turned it to, whatever happens."),
        tr("Turns as the picture turns around its middle, as a hat does on a dancer.")};
    for (int i = 0; i < mTurns->count(); ++i)
        mTurns->setItemData(i, teaches[i], Qt::ToolTipRole);
    layout->addWidget(mTurns);
    connect(mTurns, &QComboBox::activated, this, [this](int index) {
        change(tr("Change turning"), [index](Canvas &canvas) { canvas.turning = CanvasTurning(index); });
    });
}

void CanvasPanel::buildHiding(QVBoxLayout *layout)
{
    mIsHidden = new QCheckBox(tr("Hidden by what is in front"));
    mIsHidden->setObjectName(QStringLiteral("hiddenByScene"));
    mIsHidden->setToolTip(tr("Nearer things cover the canvas. Off: it is always seen."));
    layout->addWidget(mIsHidden);
    connect(mIsHidden, &QCheckBox::clicked, this, [this](bool on) {
        change(on ? tr("Let the scene hide the canvas") : tr("Show the canvas always"),
               [on](Canvas &canvas) { canvas.occlusion.isOn = on; });
    });
    mBias = new NumberSlider(tr("Depth play"), {-0.3, 0.5, 0.01, 0.03, 2},
                             tr("More: the canvas shows through what is only a little nearer."));
    layout->addWidget(mBias);
    connect(mBias, &NumberSlider::editBegun, this, [this] { mDrag = nextDrag(); });
    connect(mBias, &NumberSlider::valueChanged, this, [this](double value) {
        change(
            tr("Change depth play"), [value](Canvas &canvas) { canvas.occlusion.bias = value; }, mDrag);
    });
    auto *brushes = new QHBoxLayout;
    brushes->setSpacing(6);
    mInFront = new QPushButton(tr("In front here"));
    mInFront->setCheckable(true);
    mInFront->setToolTip(tr("Brush over the picture where the canvas must be seen."));
    mBehind = new QPushButton(tr("Behind here"));
    mBehind->setCheckable(true);
    mBehind->setToolTip(tr("Brush over the picture where the canvas must be hidden."));
    brushes->addWidget(mInFront);
    brushes->addWidget(mBehind);
    layout->addLayout(brushes);
    connect(mInFront, &QPushButton::clicked, this,
            [this](bool on) { setOcclusionBrush(on ? OcclusionBrush::InFront : OcclusionBrush::Off); });
    connect(mBehind, &QPushButton::clicked, this,
            [this](bool on) { setOcclusionBrush(on ? OcclusionBrush::Behind : OcclusionBrush::Off); });
    mForgetBrush = new QPushButton(tr("Forget what was brushed"));
    mForgetBrush->setToolTip(tr("Only the distance decides again what hides the canvas."));
    layout->addWidget(mForgetBrush);
    connect(mForgetBrush, &QPushButton::clicked, this, [this] {
        change(tr("Forget the brush"), [](Canvas &canvas) { canvas.occlusion.touches.clear(); });
    });
    mOpacity = new NumberSlider(tr("Opacity"), {0.0, 100.0, 1.0, 100.0, 0, QStringLiteral("%")},
                                tr("How much of the film shows through the drawing."));
    layout->addWidget(mOpacity);
    connect(mOpacity, &NumberSlider::editBegun, this, [this] { mDrag = nextDrag(); });
    connect(mOpacity, &NumberSlider::valueChanged, this, [this](double value) {
        change(
            tr("Change opacity"), [value](Canvas &canvas) { canvas.opacity = value / 100.0; }, mDrag);
    });
}

template <typename Change>
void CanvasPanel::change(const QString &text, Change change, quint64 drag)
{
    const Canvas *canvas = mState.chosenCanvas();
    if (!canvas)
        return;
    Canvas changed = *canvas;
    change(changed);
    mState.document().editCanvas(text, std::move(changed), drag);
}

void CanvasPanel::setOcclusionBrush(OcclusionBrush brush)
{
    mInFront->setChecked(brush == OcclusionBrush::InFront);
    mBehind->setChecked(brush == OcclusionBrush::Behind);
    emit occlusionBrushChosen(brush);
}

void CanvasPanel::setFollows(bool follows)
{
    const Canvas *canvas = mState.chosenCanvas();
    const std::optional<CanvasFrame> place = canvas ? mState.place(*canvas) : std::nullopt;
    if (!place || follows == (canvas->motion == CanvasMotion::Dynamic))
        return;
    if (follows)
        mState.document().editCanvas(tr("Let canvas follow"), following(*canvas, mState.frame(), *place));
    else
        mState.document().editCanvas(tr("Let canvas stay"), standingAt(*canvas, mState.frame(), *place));
}

void CanvasPanel::pinHere()
{
    const Canvas *canvas = mState.chosenCanvas();
    const std::optional<CanvasFrame> place = canvas ? mState.place(*canvas) : std::nullopt;
    if (!place)
        return;
    if (canvas->motion == CanvasMotion::Static)
        setFollows(true);
    else
        mState.document().editCanvas(tr("Pin canvas"), withMiddleAt(*canvas, mState.frame(), place->pixel));
}

std::optional<int> CanvasPanel::pinBefore() const
{
    const Canvas *canvas = mState.chosenCanvas();
    if (!canvas || canvas->motion != CanvasMotion::Dynamic)
        return std::nullopt;
    const auto &pins = canvas->keyframes.positions;
    for (std::size_t i = 0; i + 1 < pins.size(); ++i)
        if (pins[i].frame <= mState.frame() && mState.frame() < pins[i + 1].frame)
            return pins[i].frame;
    return std::nullopt;
}

void CanvasPanel::setStraight(bool straight)
{
    if (const std::optional<int> pin = pinBefore())
        mState.document().editCanvas(
            straight ? tr("Go straight") : tr("Follow the scene"),
            withInterpolation(*mState.chosenCanvas(), KeyframeKind::Position, *pin, straight));
}

void CanvasPanel::faceCamera()
{
    const Canvas *canvas = mState.chosenCanvas();
    const std::shared_ptr<const Shot> shot = mState.document().sceneShot();
    if (!canvas || mState.frame() >= shot->frameCount())
        return;
    const Eigen::Quaterniond camera(shot->cameras[std::size_t(mState.frame())].worldFromCamera.linear());
    mState.document().editCanvas(tr("Face the camera"), withTurnAt(*canvas, mState.frame(), camera));
}

void CanvasPanel::useSceneDistance()
{
    if (const Canvas *canvas = mState.chosenCanvas())
        mState.document().editCanvas(tr("Distance from the scene"), withSceneDistance(*canvas));
}

void CanvasPanel::editDistance(double depth)
{
    if (const Canvas *canvas = mState.chosenCanvas())
        mState.document().editCanvas(tr("Change distance"), withDistanceAt(*canvas, mState.frame(), depth),
                                     mDrag);
}

void CanvasPanel::editSize(double percent)
{
    if (const Canvas *canvas = mState.chosenCanvas())
        mState.document().editCanvas(tr("Size canvas"), withScaleAt(*canvas, mState.frame(), percent / 100.0),
                                     mDrag);
}

void CanvasPanel::refresh()
{
    const Canvas *canvas = mState.chosenCanvas();
    mEmpty->setVisible(!canvas);
    mContent->setVisible(canvas);
    if (!canvas) {
        mEmpty->setText(mState.document().scene().canvases.empty()
                            ? tr("Drag out a box on the picture: a canvas to draw on will stand there.")
                            : tr("Choose a canvas above or on the picture, or drag out a box for another "
                                 "one."));
        return;
    }
    const bool follows = canvas->motion == CanvasMotion::Dynamic;
    {
        const QSignalBlocker blocker(mMotion);
        mMotion->setCurrent(follows ? 1 : 0);
    }
    mPin->setText(follows ? tr("Pin here") : tr("Pin it here and follow"));
    const int pins = int(canvas->keyframes.positions.size());
    mKeyframes->setText(!follows ? tr("Stands still in the scene.")
                        : mState.follower().isUpToDate(canvas->id)
                            ? tr("Pinned in %n frame(s); drag it where it drifts.", nullptr, pins)
                            : tr("Following..."));
    mTurns->setVisible(follows);
    mTurns->setCurrentIndex(int(canvas->turning));
    const std::optional<int> pin = pinBefore();
    mStraight->setVisible(follows && pins > 1);
    mStraight->setEnabled(pin.has_value());
    mStraight->setChecked(
        pin &&
        std::any_of(canvas->keyframes.positions.begin(), canvas->keyframes.positions.end(),
                    [pin](const CanvasKeyframe &key) { return key.frame == *pin && key.interpolatesNext; }));
    if (const std::optional<CanvasFrame> place = mState.place(*canvas)) {
        if (place->depth > mDistance->range().maximum || place->depth < mDistance->range().minimum ||
            mDistance->range().maximum > 40.0 * place->depth) {
            NumberRange range = mDistance->range();
            range.minimum = place->depth / 12.0;
            range.maximum = place->depth * 12.0;
            range.defaultValue = place->depth;
            mDistance->setRange(range);
        }
        mDistance->setValue(place->depth);
        mSize->setValue(100.0 * place->scale);
    }
    const bool ownDepth = !canvas->keyframes.depths.empty() ||
                          std::any_of(canvas->keyframes.positions.begin(), canvas->keyframes.positions.end(),
                                      [](const CanvasKeyframe &key) { return key.depth.has_value(); });
    mSceneDistance->setEnabled(ownDepth);
    mIsHidden->setChecked(canvas->occlusion.isOn);
    mBias->setEnabled(canvas->occlusion.isOn);
    mBias->setValue(canvas->occlusion.bias);
    mForgetBrush->setVisible(!canvas->occlusion.touches.empty());
    mOpacity->setValue(100.0 * canvas->opacity);
}

} // namespace ductus
