#include "doodlestudio/ui/drawing/frame_strip.h"

#include "doodlestudio/ui/canvases/mark_painter.h"
#include "doodling/canvas/edit_doodle.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/theme.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

namespace ductus {

namespace {

constexpr QSize thumbSize(52, 40);
constexpr int usualHold = 4; // video frames: calm to look at, few to draw

} // namespace

FrameStrip::FrameStrip(StudioState &state, QWidget *parent) : QWidget(parent), mState(state)
{
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 4, 8, 6);
    layout->setSpacing(4);
    auto *area = new QScrollArea;
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setFixedHeight(thumbSize.height() + 28);
    area->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setFocusPolicy(Qt::NoFocus);
    auto *row = new QWidget;
    mFrames = new QHBoxLayout(row);
    mFrames->setContentsMargins(0, 0, 0, 0);
    mFrames->setSpacing(4);
    area->setWidget(row);
    layout->addWidget(area);
    buildControls();
    layout->addWidget(mControls);
    connect(&state, &StudioState::lookChanged, this, &FrameStrip::refresh);
    connect(&state, &StudioState::frameChanged, this, &FrameStrip::refresh);
    connect(&state, &StudioState::onionChanged, this, &FrameStrip::refresh);
    refresh();
}

void FrameStrip::buildControls()
{
    mControls = new QWidget;
    auto *layout = new QHBoxLayout(mControls);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    mOnion = new QToolButton;
    mOnion->setObjectName(QStringLiteral("onion"));
    mOnion->setText(tr("Onion skin"));
    mOnion->setCheckable(true);
    mOnion->setProperty("framed", true);
    mOnion->setIcon(icon("stack"));
    mOnion->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    mOnion->setToolTip(tr("Onion skin (O). The drawings before shine through in red, those after in blue."));
    layout->addWidget(mOnion);
    mOnionCount = new QSpinBox;
    mOnionCount->setRange(1, 5);
    mOnionCount->setMinimumWidth(64);
    mOnionCount->setAccessibleName(tr("Drawings that shine through"));
    mOnionCount->setToolTip(tr("How many drawings before and after shine through."));
    layout->addWidget(mOnionCount);
    layout->addStretch(1);
    auto *holdLabel = new QLabel(tr("Held"));
    mHold = new QSpinBox;
    mHold->setObjectName(QStringLiteral("hold"));
    mHold->setRange(1, 250);
    mHold->setMinimumWidth(72);
    mHold->setAccessibleName(tr("Video frames this drawing is held"));
    mHold->setToolTip(tr("For how many frames of the film this drawing is seen."));
    holdLabel->setBuddy(mHold);
    layout->addWidget(holdLabel);
    layout->addWidget(mHold);
    mRepeat = new QComboBox;
    mRepeat->setObjectName(QStringLiteral("repeat"));
    mRepeat->setAccessibleName(tr("After the last drawing"));
    mRepeat->setToolTip(tr("What comes after the last drawing."));
    mRepeat->addItems({tr("Loop"), tr("There and back"), tr("Once"), tr("Keep the last")});
    layout->addWidget(mRepeat);
    connect(mOnion, &QToolButton::toggled, this, &FrameStrip::setOnionSkin);
    connect(mOnionCount, &QSpinBox::valueChanged, this, [this](int count) {
        if (!mIsRefreshing)
            mState.setOnionSkin({mState.onionSkin().isOn, count});
    });
    connect(mHold, &QSpinBox::valueChanged, this, [this](int hold) {
        const Canvas *canvas = mState.chosenCanvas();
        if (!mIsRefreshing && canvas)
            edit(tr("Hold drawing"), withHold(canvas->doodle, mState.drawingOf(*canvas), hold));
    });
    connect(mRepeat, &QComboBox::activated, this, [this](int index) {
        if (const Canvas *canvas = mState.chosenCanvas()) {
            Doodle doodle = canvas->doodle;
            doodle.repeat = DoodleRepeat(index);
            edit(tr("Change repeat"), std::move(doodle));
        }
    });
}

void FrameStrip::edit(const QString &text, Result<Doodle> doodle)
{
    mState.document().editDoodle(text, mState.chosen(), std::move(doodle));
}

void FrameStrip::addDrawing()
{
    const Canvas *canvas = mState.chosenCanvas();
    if (!canvas)
        return;
    const int index = mState.drawingOf(*canvas);
    Doodle doodle = canvas->doodle;
    // A drawing that was there all the time becomes the first of an animation, which begins where it is seen.
    if (doodle.frames.size() == 1 && doodle.frames[0].hold < usualHold)
        doodle.frames[0].hold = usualHold;
    edit(tr("Add drawing"), withInsertedFrame(doodle, index + 1, doodle.frames[std::size_t(index)].hold));
    if (const Canvas *changed = mState.chosenCanvas())
        mState.goToDrawing(*changed, index + 1);
}

void FrameStrip::duplicateDrawing()
{
    const Canvas *canvas = mState.chosenCanvas();
    if (!canvas)
        return;
    const int index = mState.drawingOf(*canvas);
    edit(tr("Duplicate drawing"), withDuplicatedFrame(canvas->doodle, index));
    if (const Canvas *changed = mState.chosenCanvas())
        mState.goToDrawing(*changed, index + 1);
}

void FrameStrip::removeDrawing()
{
    if (const Canvas *canvas = mState.chosenCanvas())
        edit(tr("Take drawing away"), withoutFrame(canvas->doodle, mState.drawingOf(*canvas)));
}

void FrameStrip::step(int drawings)
{
    const Canvas *canvas = mState.chosenCanvas();
    if (!canvas)
        return;
    const int count = int(canvas->doodle.frames.size());
    mState.goToDrawing(*canvas, ((mState.drawingOf(*canvas) + drawings) % count + count) % count);
}

void FrameStrip::setOnionSkin(bool on)
{
    if (!mIsRefreshing && on != mState.onionSkin().isOn)
        mState.setOnionSkin({on, mState.onionSkin().count});
}

QImage FrameStrip::thumbnail(const Canvas &canvas, int index) const
{
    const double ratio = devicePixelRatioF();
    QImage image(thumbSize * ratio, QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(ratio);
    const ThemeColours colours = coloursOf(palette());
    image.fill(mixed(colours.raised, colours.text, 0.25));
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    const double scale = std::min(thumbSize.width() / canvas.size.x(), thumbSize.height() / canvas.size.y());
    painter.translate(thumbSize.width() / 2.0, thumbSize.height() / 2.0);
    painter.scale(scale / canvasGrain, scale / canvasGrain);
    paintMarks(painter, canvas.doodle.frames[std::size_t(index)]);
    return image;
}

void FrameStrip::refresh()
{
    const Canvas *canvas = mState.chosenCanvas();
    mControls->setEnabled(canvas);
    mIsRefreshing = true;
    mOnion->setChecked(mState.onionSkin().isOn);
    mOnionCount->setValue(mState.onionSkin().count);
    const int count = canvas ? int(canvas->doodle.frames.size()) : 0;
    // Buttons are kept: focus and a press in progress stay where they are.
    while (mFrames->count() > 0 && mFrames->count() != count + 2) {
        QLayoutItem *item = mFrames->takeAt(0);
        if (item->widget())
            item->widget()->deleteLater();
        delete item;
    }
    if (mFrames->count() == 0 && canvas) {
        for (int i = 0; i <= count; ++i) {
            auto *button = new QToolButton;
            button->setAutoRaise(true);
            if (i < count) {
                button->setObjectName(QStringLiteral("drawing%1").arg(i + 1));
                button->setCheckable(true);
                button->setText(QString::number(i + 1));
                button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
                button->setIconSize(thumbSize);
                button->setAccessibleName(tr("Drawing %1").arg(i + 1));
                connect(button, &QToolButton::clicked, this, [this, i] {
                    if (const Canvas *chosen = mState.chosenCanvas())
                        mState.goToDrawing(*chosen, i);
                    refresh();
                });
            } else {
                button->setObjectName(QStringLiteral("addDrawing"));
                button->setIcon(icon("list-add"));
                button->setIconSize({24, 24});
                button->setFixedSize(40, thumbSize.height() + 20);
                button->setAccessibleName(tr("Add drawing"));
                button->setToolTip(tr("Add drawing. An empty one after this: draw the next moment on it."));
                connect(button, &QToolButton::clicked, this, &FrameStrip::addDrawing, Qt::QueuedConnection);
            }
            mFrames->addWidget(button);
        }
        mFrames->addStretch(1);
    }
    for (int i = 0; i < count; ++i) {
        auto *button = qobject_cast<QToolButton *>(mFrames->itemAt(i)->widget());
        if (!button)
            continue;
        button->setChecked(i == mState.drawingOf(*canvas));
        const auto &marks = canvas->doodle.frames[std::size_t(i)].marks;
        mShown.resize(std::size_t(count));
        if (isVisible() && (button->icon().isNull() || marks != mShown[std::size_t(i)])) {
            button->setIcon(QPixmap::fromImage(thumbnail(*canvas, i)));
            mShown[std::size_t(i)] = marks;
        }
        button->setToolTip(
            tr("Drawing %1, held for %n frame(s)", nullptr, canvas->doodle.frames[std::size_t(i)].hold)
                .arg(i + 1));
    }
    if (canvas) {
        mHold->setValue(canvas->doodle.frames[std::size_t(mState.drawingOf(*canvas))].hold);
        mRepeat->setCurrentIndex(int(canvas->doodle.repeat));
    }
    mIsRefreshing = false;
}

} // namespace ductus
