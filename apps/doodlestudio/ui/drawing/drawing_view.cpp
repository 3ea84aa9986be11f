#include "doodlestudio/ui/drawing/drawing_view.h"

#include "doodlestudio/ui/canvases/mark_painter.h"
#include "doodling/canvas/doodle_time.h"
#include "widgets/theme/theme.h"

#include <QEvent>
#include <QMouseEvent>
#include <QTabletEvent>

namespace ductus {

namespace {

constexpr double sheetMargin = 14.0;
// Red was, blue will be: as in every animation desk.
const QColor beforeTint(0xe5, 0x40, 0x40), afterTint(0x3c, 0x7c, 0xf0);

} // namespace

DrawingView::DrawingView(StudioState &state, DrawingHand &hand, QWidget *parent)
    : QWidget(parent), mState(state), mHand(hand)
{
    setObjectName(QStringLiteral("drawingView"));
    setAccessibleName(tr("Drawing"));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setTabletTracking(true);
    setCursor(Qt::CrossCursor);
    connect(&state, &StudioState::lookChanged, this, qOverload<>(&QWidget::update));
    connect(&state, &StudioState::frameChanged, this, qOverload<>(&QWidget::update));
    connect(&state, &StudioState::brushChanged, this, qOverload<>(&QWidget::update));
    connect(&hand, &DrawingHand::changed, this, qOverload<>(&QWidget::update));
}

void DrawingView::setPicture(const QImage &picture)
{
    mPicture = picture;
    if (isVisible())
        update();
}

void DrawingView::setUnderlay(double share)
{
    mUnderlay = share;
    update();
}

QRectF DrawingView::sheetRect() const
{
    const Canvas *canvas = mState.chosenCanvas();
    const QSizeF sheet = canvas ? QSizeF(canvas->size.x(), canvas->size.y()) : QSizeF(4, 3);
    const QRectF room = QRectF(rect()).adjusted(sheetMargin, sheetMargin, -sheetMargin, -sheetMargin);
    QRectF place(QPointF(0, 0), sheet.scaled(room.size(), Qt::KeepAspectRatio));
    place.moveCenter(room.center());
    return place;
}

QTransform DrawingView::viewFromCanvas() const
{
    const Canvas *canvas = mState.chosenCanvas();
    const QRectF sheet = sheetRect();
    const double scale = canvas ? sheet.width() / (canvas->size.x() * canvasGrain) : 1.0;
    return QTransform::fromTranslate(sheet.center().x(), sheet.center().y()).scale(scale, scale);
}

QPointF DrawingView::toView(const Vec2 &onCanvas) const
{
    return viewFromCanvas().map(toPoint(onCanvas) * canvasGrain);
}

Vec2 DrawingView::toCanvas(const QPointF &inView) const
{
    return toVec(viewFromCanvas().inverted().map(inView)) / canvasGrain;
}

void DrawingView::paintUnderlay(QPainter &painter, const Canvas &canvas)
{
    const std::shared_ptr<const Shot> shot = mState.document().sceneShot();
    const std::optional<QTransform> workingFromCanvas = mState.workingFromCanvas(canvas);
    if (mPicture.isNull() || !workingFromCanvas || mUnderlay <= 0.0)
        return;
    bool isInvertible = false;
    const QTransform canvasFromWorking = workingFromCanvas->inverted(&isInvertible);
    if (!isInvertible)
        return;
    painter.save();
    painter.setClipRect(sheetRect());
    painter.setOpacity(mUnderlay);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.setTransform(QTransform::fromScale(double(shot->width) / mPicture.width(),
                                               double(shot->height) / mPicture.height()) *
                         canvasFromWorking * viewFromCanvas());
    painter.drawImage(QPointF(0, 0), mPicture);
    painter.restore();
}

void DrawingView::paintOnion(QPainter &painter, const Canvas &canvas)
{
    const OnionSkin &onion = mState.onionSkin();
    if (!onion.isOn)
        return;
    for (const OnionLayer &layer :
         onionSkin(canvas.doodle, mState.drawingOf(canvas), onion.count, onion.count)) {
        QImage skin(size() * devicePixelRatioF(), QImage::Format_ARGB32_Premultiplied);
        skin.setDevicePixelRatio(devicePixelRatioF());
        skin.fill(Qt::transparent);
        QPainter paint(&skin);
        paint.setRenderHint(QPainter::Antialiasing);
        paint.save();
        paint.setTransform(viewFromCanvas(), true);
        paintMarks(paint, canvas.doodle.frames[std::size_t(layer.index)]);
        paint.restore();
        // All of one colour: what was drawn matters here, not in what.
        paint.setCompositionMode(QPainter::CompositionMode_SourceIn);
        paint.fillRect(rect(), layer.steps < 0 ? beforeTint : afterTint);
        paint.end();
        painter.setOpacity(layer.opacity);
        painter.drawImage(0, 0, skin);
        painter.setOpacity(1.0);
    }
}

void DrawingView::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const ThemeColours colours = coloursOf(palette());
    painter.fillRect(rect(), colours.window);
    const Canvas *canvas = mState.chosenCanvas();
    if (!canvas) {
        painter.setPen(colours.dim);
        painter.drawText(QRectF(rect()).adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("Draw straight on the picture: a canvas is made where you begin.\nOr choose a "
                            "canvas to see it from the front."));
        return;
    }
    painter.fillRect(sheetRect(), colours.isDark ? QColor(0x3a, 0x3e, 0x44) : QColor(0xff, 0xff, 0xff));
    paintUnderlay(painter, *canvas);
    paintOnion(painter, *canvas);
    painter.save();
    painter.setTransform(viewFromCanvas(), true);
    paintMarks(painter, canvas->doodle.frames[std::size_t(mState.drawingOf(*canvas))]);
    if (mHand.isDrawing())
        mHand.paint(painter);
    painter.restore();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(canvasColour(canvas->id), 1.5));
    painter.drawRect(sheetRect());
    if (mPointer && mState.brush().tool != DrawingTool::Text && mState.brush().tool != DrawingTool::Move) {
        const double radius = std::max(1.5, mHand.radius() * canvasGrain * viewFromCanvas().m11());
        painter.setPen(QPen(QColor(0, 0, 0, 150), 2.5));
        painter.drawEllipse(*mPointer, radius, radius);
        painter.setPen(QPen(QColor(255, 255, 255, 220), 1.0));
        painter.drawEllipse(*mPointer, radius, radius);
    }
}

void DrawingView::mousePressEvent(QMouseEvent *event)
{
    setFocus(Qt::MouseFocusReason);
    if (event->button() == Qt::LeftButton)
        mHand.press({toCanvas(event->position()), 1.0, false});
}

void DrawingView::mouseMoveEvent(QMouseEvent *event)
{
    mPointer = event->position();
    mHand.move({toCanvas(event->position()), 1.0, false});
    update();
}

void DrawingView::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton)
        mHand.release({toCanvas(event->position()), 1.0, false});
}

void DrawingView::tabletEvent(QTabletEvent *event)
{
    const HandPoint point{toCanvas(event->position()), event->pressure(),
                          event->pointerType() == QPointingDevice::PointerType::Eraser};
    mPointer = event->position();
    if (event->type() == QEvent::TabletPress && event->button() == Qt::LeftButton) {
        setFocus(Qt::MouseFocusReason);
        mHand.press(point);
    } else if (event->type() == QEvent::TabletMove) {
        mHand.move(point);
        update();
    } else if (event->type() == QEvent::TabletRelease && event->button() == Qt::LeftButton) {
        // The pen leaves the paper without pressure: the line keeps the one it had.
        mHand.release({point.onCanvas, std::max(0.05, point.pressure), point.isEraser});
    } else {
        event->ignore();
        return;
    }
    event->accept();
}

void DrawingView::leaveEvent(QEvent *)
{
    mPointer.reset();
    update();
}

void DrawingView::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::PaletteChange)
        update();
    QWidget::changeEvent(event);
}

} // namespace ductus
