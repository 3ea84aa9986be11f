#include "layerpainter/ui/view/painting_view.h"

#include "layerpainter/document/default_view.h"
#include "painting/scene/element_placement.h"

#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QOpenGLFramebufferObject>
#include <QPainter>
#include <QSurfaceFormat>
#include <algorithm>
#include <unordered_set>

namespace ductus {

namespace {

// What nobody sees is left out: strokes smaller than half a pixel, points that matter less. While something
// moves pixels are larger, and so is what may be left out of them; large paintings are drawn by ribbons.
constexpr RenderOptions stillDetail{1, false, 0.5, 0.25};
constexpr RenderOptions movingDetail{1, false, 1.0, 1.0, 4.0, 200'000};

constexpr int smoothenMilliseconds = 40; // from a still frame until it is made smoother

} // namespace

/// Outlines and the tool's marks: a widget on top, so that the painting need not be drawn again for them.
class PaintingView::Overlay : public QWidget
{
public:
    explicit Overlay(PaintingView &view) : QWidget(&view), mView(view)
    {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        setAttribute(Qt::WA_NoSystemBackground);
    }

protected:
    void paintEvent(QPaintEvent *) override
    {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        mView.drawOverlay(painter);
    }

private:
    PaintingView &mView;
};

PaintingView::PaintingView(PaintingDocument &document, QWidget *parent)
    : QOpenGLWidget(parent), mDocument(document), mOverlay(new Overlay(*this))
{
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(4, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    setFormat(format);
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Canvas"));
    mClock.start();
    mStill.setSingleShot(true);
    mStill.setInterval(FramePace::stillMilliseconds);
    connect(&mStill, &QTimer::timeout, this, [this] {
        mPace.stop();
        update();
    });
    mSmoothen.setSingleShot(true);
    mSmoothen.setInterval(smoothenMilliseconds);
    connect(&mSmoothen, &QTimer::timeout, this, [this] {
        if (!mPace.isMoving())
            update();
    });
    connect(&mDocument, &Document::changed, this, [this](const ChangeEvent &event) {
        mPreview = nullptr;
        if (event.as<DocumentReset>()) {
            setSelection({});
            frameAll();
        } else {
            mPace.edit(double(mClock.elapsed()));
            if (mPace.isMoving())
                mStill.start();
        }
        changedView();
    });
}

PaintingView::~PaintingView()
{
    releaseGraphics();
}

void PaintingView::frameAll()
{
    const double aspect = mCamera.viewport().width() / mCamera.viewport().height();
    const CameraKey key = defaultView(mDocument.painting(), mSeconds, aspect);
    const Box3 box = paintingBox(mDocument.painting());
    const Vec3 way = key.rotation * -Vec3::UnitZ();
    const double depth = box.isEmpty() ? 3 : (box.centre() - key.eye).dot(way);
    mCamera.set(key, std::max(depth, 0.05 * std::max(box.diagonal(), 1e-3)));
    changedView();
    emit framed();
}

void PaintingView::setSeconds(double seconds, bool followCamera)
{
    if (seconds == mSeconds)
        return;
    mSeconds = seconds;
    const Painting &painting = mDocument.painting();
    if (followCamera && !painting.camera.keys.empty()) {
        const double distance = (mCamera.pivot() - mCamera.eye()).norm();
        mCamera.set(cameraAt(painting.camera, loopedTime(seconds, painting.loopSeconds)), distance);
        emit viewMoved();
    }
    movedView();
}

std::vector<std::pair<const Element *, Eigen::Affine3d>> PaintingView::shownElements(const Layer &layer) const
{
    const ElementPlacements placements(mDocument.painting(), mSeconds);
    std::vector<std::pair<const Element *, Eigen::Affine3d>> shown;
    for (const Element &element : layer.drawingAt(placements.timeSeconds()).elements)
        shown.emplace_back(&element, placements.sceneFromElement(layer, element).matrix());
    return shown;
}

void PaintingView::setTool(CanvasTool *tool)
{
    if (mTool)
        mTool->cancel(*this);
    mTool = tool;
    setCursor(tool ? tool->cursor() : Qt::OpenHandCursor);
    mOverlay->update();
}

bool PaintingView::cancelTool()
{
    const bool had = mTool && mTool->cancel(*this);
    mOverlay->update();
    return had;
}

void PaintingView::setPreview(std::shared_ptr<const Painting> preview)
{
    mPreview = std::move(preview);
    movedView();
}

void PaintingView::setSelection(std::vector<ElementId> selection)
{
    if (selection == mSelection)
        return;
    mSelection = std::move(selection);
    mOverlay->update();
    emit selectionChanged();
}

void PaintingView::setHoveredLayer(std::optional<LayerId> layer)
{
    mHovered = layer;
    mOverlay->update();
}

void PaintingView::setStandIn(std::function<void(unsigned, const QSize &)> draw)
{
    mStandIn = std::move(draw);
    changedView();
}

void PaintingView::setKeyedThing(std::optional<MovedThing> thing)
{
    mKeyed = thing;
    mOverlay->update();
}

void PaintingView::updateMarks()
{
    mOverlay->update();
}

void PaintingView::changedView()
{
    update();
    mOverlay->update();
}

void PaintingView::movedView()
{
    mPace.move();
    mStill.start();
    changedView();
}

void PaintingView::initializeGL()
{
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &PaintingView::releaseGraphics,
            Qt::UniqueConnection);
    Result<PaintingRenderer> renderer = PaintingRenderer::create({});
    if (renderer)
        mRenderer.emplace(std::move(*renderer));
    else
        emit graphicsFailed(renderer.error());
}

void PaintingView::releaseGraphics()
{
    if (!mRenderer)
        return;
    makeCurrent();
    mRenderer.reset();
    mUploaded.reset();
    mCoarse.reset();
    mPixel.reset();
    mSmooth.reset();
    doneCurrent();
}

StillScene PaintingView::stillScene() const
{
    return {mPreview ? mPreview : mDocument.sharedPainting(), mSeconds, mCamera.frame(),
            (QSizeF(size()) * devicePixelRatioF()).toSize()};
}

// As many frames more as a hand does not notice; what is there is shown.
void PaintingView::smoothen()
{
    QElapsedTimer clock;
    clock.start();
    mRenderer->setOptions(stillDetail);
    const QSize size = stillScene().size;
    while (!mSmooth->isDone() && clock.elapsed() < smoothenMilliseconds) {
        const RenderView view{mSmooth->nextCamera(), mSmooth->nextFramebuffer(), 0, 0, size.width(),
                              size.height()};
        if (const Result<void> drawn = mRenderer->render({&view, 1}); !drawn) {
            mSmooth->forget();
            emit graphicsFailed(drawn.error());
            return;
        }
        mSmooth->add();
        context()->functions()->glFinish(); // the clock needs what it really took
    }
    mSmooth->show(defaultFramebufferObject());
    if (!mSmooth->isDone())
        mSmoothen.start();
}

// Frames of a movement are drawn small and enlarged.
Result<void> PaintingView::drawFrame(int width, int height, int divisor)
{
    const GLuint window = defaultFramebufferObject();
    if (divisor == 1) {
        const RenderView view{mCamera.frame(), window, 0, 0, width, height};
        return mRenderer->render({&view, 1});
    }
    const QSize size(std::max(1, width / divisor), std::max(1, height / divisor));
    if (!mCoarse || mCoarse->size() != size)
        mCoarse = std::make_unique<QOpenGLFramebufferObject>(size);
    const RenderView view{mCamera.frame(), mCoarse->handle(), 0, 0, size.width(), size.height()};
    const Result<void> drawn = mRenderer->render({&view, 1});
    QOpenGLExtraFunctions *gl = context()->extraFunctions();
    gl->glBindFramebuffer(GL_READ_FRAMEBUFFER, mCoarse->handle());
    gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, window);
    gl->glBlitFramebuffer(0, 0, size.width(), size.height(), 0, 0, width, height, GL_COLOR_BUFFER_BIT,
                          GL_LINEAR);
    gl->glBindFramebuffer(GL_FRAMEBUFFER, window);
    return drawn;
}

void PaintingView::paintGL()
{
    if (!mRenderer)
        return;
    QElapsedTimer clock;
    clock.start();
    const StillScene scene = stillScene();
    const int w = scene.size.width(), h = scene.size.height();
    if (mStandIn) {
        mStandIn(defaultFramebufferObject(), {w, h});
        ++mFrameCount;
        return;
    }
    const std::shared_ptr<const Painting> &painting = scene.painting;
    if (!mSmooth)
        mSmooth = std::make_unique<SmoothStill>();
    if (!mPace.isMoving() && mSmooth->isOf(scene)) {
        smoothen();
        return;
    }
    mSmooth->forget();
    Result<void> drawn;
    // Looking what has changed takes its time with tens of thousands of strokes, and turning changes nothing.
    if (painting != mUploaded || mSeconds != mUploadedSeconds) {
        drawn = mRenderer->update(*painting, {mSeconds, {}});
        mUploaded = drawn ? painting : nullptr;
        mUploadedSeconds = mSeconds;
    }
    mDrawnDivisor = mPace.divisor();
    mRenderer->setOptions(mPace.isMoving() ? movingDetail : stillDetail);
    if (drawn)
        drawn = drawFrame(w, h, mDrawnDivisor);
    if (!drawn)
        emit graphicsFailed(drawn.error());
    context()->functions()->glFinish(); // drivers draw later; the pace needs what the frame really took
    mLastFrameMilliseconds = double(clock.nsecsElapsed()) * 1e-6;
    mPace.drawn(mLastFrameMilliseconds);
    ++mFrameCount;
    if (drawn && !mPace.isMoving() && mLastFrameMilliseconds < mMostSmoothenedMilliseconds) {
        mSmooth->begin(scene, defaultFramebufferObject());
        mSmoothen.start();
    }
}

void PaintingView::resizeEvent(QResizeEvent *event)
{
    QOpenGLWidget::resizeEvent(event);
    mOverlay->setGeometry(rect());
    mCamera.setViewport(size());
}

std::optional<PickedPoint> PaintingView::pick(const QPointF &position)
{
    if (!mRenderer || mFrameCount == 0 || !rect().contains(position.toPoint()))
        return std::nullopt;
    makeCurrent();
    const double ratio = devicePixelRatioF();
    int x = int(position.x() * ratio), y = int(position.y() * ratio);
    if (mDrawnDivisor > 1 || (mSmooth && mSmooth->hasShifted())) {
        // The one pixel that is asked for, as the sharp frame would have it.
        const double w = width() * ratio, h = height() * ratio;
        const FrameCamera whole = mCamera.frame();
        FrameCamera part = whole;
        part.left = whole.left + x / w * (whole.right - whole.left);
        part.right = whole.left + (x + 1) / w * (whole.right - whole.left);
        part.up = whole.up + y / h * (whole.down - whole.up);
        part.down = whole.up + (y + 1) / h * (whole.down - whole.up);
        if (!mPixel)
            mPixel = std::make_unique<QOpenGLFramebufferObject>(1, 1);
        const RenderView view{part, mPixel->handle(), 0, 0, 1, 1};
        mRenderer->setOptions(stillDetail);
        if (!mRenderer->render({&view, 1})) {
            doneCurrent();
            return std::nullopt;
        }
        x = y = 0;
    }
    const auto picked = mRenderer->pick(0, x, y);
    doneCurrent();
    return picked ? *picked : std::nullopt;
}

std::optional<ElementId> PaintingView::strokeNear(const QPointF &position, LayerId id, double reach)
{
    const Layer *layer = mDocument.painting().findLayer(id);
    if (!layer)
        return std::nullopt;
    std::optional<ElementId> best;
    for (const auto &[element, place] : shownElements(*layer)) {
        const auto *stroke = std::get_if<StrokeShape>(element->shape.get());
        if (!stroke)
            continue;
        std::optional<QPointF> last;
        for (const PaintedPoint &point : stroke->points) {
            const auto at = mCamera.project(place * point.position.cast<double>());
            if (at) {
                const QPointF from = last.value_or(*at), along = *at - from;
                const double length = QPointF::dotProduct(along, along);
                const double t =
                    length > 0 ? std::clamp(QPointF::dotProduct(position - from, along) / length, 0.0, 1.0)
                               : 0;
                const double distance = QLineF(position, from + t * along).length();
                if (distance <= reach) { // the later of two is on top
                    reach = distance;
                    best = element->id;
                }
            }
            last = at;
        }
    }
    return best;
}

QImage PaintingView::picture()
{
    mPace.stop();
    if (mSmooth)
        mSmooth->forget(); // the same picture every time, however long it was looked at
    return mFrameCount > 0 && !mDocument.isEmpty() ? grabFramebuffer() : QImage();
}

void PaintingView::traceElement(QPainter &painter, const Element &element, const Eigen::Affine3d &place) const
{
    const auto *stroke = std::get_if<StrokeShape>(element.shape.get());
    if (!stroke)
        return;
    QPolygonF line;
    for (const PaintedPoint &point : stroke->points)
        if (const auto at = mCamera.project(place * point.position.cast<double>()))
            line << *at;
    painter.drawPolyline(line);
}

void PaintingView::drawOverlay(QPainter &painter)
{
    const Painting &painting = mPreview ? *mPreview : mDocument.painting();
    const QColor accent = palette().color(QPalette::Highlight);
    if (!mHovered && mSelection.empty()) { // nothing to outline: large paintings cost time here
        if (mTool)
            mTool->draw(*this, painter);
        return;
    }
    const ElementPlacements placements(painting, mSeconds);
    const auto trace = [&](auto isWanted) {
        for (const auto &[colour, width] : {std::pair(QColor(0, 0, 0, 150), 3.5), std::pair(accent, 1.6)}) {
            painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
            for (const Layer *layer : painting.layers())
                for (const Element &element : layer->drawingAt(placements.timeSeconds()).elements)
                    if (isWanted(*layer, element))
                        traceElement(painter, element, placements.sceneFromElement(*layer, element).matrix());
        }
    };
    if (mHovered) {
        painter.fillRect(rect(), QColor(0, 0, 0, 90));
        trace([&](const Layer &layer, const Element &) { return layer.id == *mHovered; });
    }
    if (!mSelection.empty()) {
        const std::unordered_set<ElementId> chosen(mSelection.begin(), mSelection.end());
        trace([&](const Layer &, const Element &element) { return chosen.contains(element.id); });
    }
    if (mTool)
        mTool->draw(*this, painter);
}

} // namespace ductus
