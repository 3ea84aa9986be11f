#include "sketchsurfacer/ui/viewport/sketch_view.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr int restMilliseconds =
    180;                            // after the last change the picture is drawn once more, with smooth edges
constexpr double quickFrame = 14.0; // milliseconds; where smooth edges cost so little they are always drawn
constexpr int flightMilliseconds = 350;
constexpr double markNearness = 0.1;   // of the diagonal: how much is seen around a place that is pointed out
constexpr std::size_t manyDots = 8000; // that would run together

double distanceToSegment(const QPointF &p, const QPointF &a, const QPointF &b, double *share)
{
    const QPointF ab = b - a, ap = p - a;
    const double length2 = QPointF::dotProduct(ab, ab);
    *share = length2 > 0.0 ? std::clamp(QPointF::dotProduct(ap, ab) / length2, 0.0, 1.0) : 0.0;
    const QPointF off = ap - *share * ab;
    return std::hypot(off.x(), off.y());
}

SceneItem meshOfMode(ViewMode mode)
{
    switch (mode) {
    case ViewMode::Proxy:
        return SceneItem::Proxy;
    case ViewMode::Regions:
        return SceneItem::Regions;
    case ViewMode::Deviation:
        return SceneItem::Deviation;
    case ViewMode::Sketch:
    case ViewMode::Surface:
        break;
    }
    return SceneItem::Surface;
}

} // namespace

SketchView::SketchView(QWidget *parent) : VtkWidget(parent)
{
    setObjectName(QStringLiteral("canvas"));
    setAccessibleName(tr("Canvas"));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(320, 240);
    addRenderer(mScene.mainRenderer());
    addRenderer(mScene.leftRenderer());
    mOverlay = new ViewOverlay(*this);
    mAtRest.setSingleShot(true);
    mAtRest.setInterval(restMilliseconds);
    connect(&mAtRest, &QTimer::timeout, this, &SketchView::drawSmoothly);
    mFlight.setStartValue(0.0);
    mFlight.setEndValue(1.0);
    mFlight.setDuration(flightMilliseconds);
    mFlight.setEasingCurve(QEasingCurve::InOutCubic);
    setDark(true);
}

SketchView::~SketchView() = default;

void SketchView::setExtent(const Box3 &box, UpAxis up, double metresPerUnit)
{
    mExtent = box;
    mMetresPerUnit = metresPerUnit;
    mScene.setExtent(box);
    mCamera.setUpAxis(up);
    if (!mFramed && !box.isEmpty())
        frameAll();
    moved();
}

SceneItem SketchView::shownMesh() const
{
    const SceneItem item = meshOfMode(mMode);
    return item == SceneItem::Regions && mAmbiguityShown && mScene.has(SceneItem::Ambiguity)
               ? SceneItem::Ambiguity
               : item;
}

double SketchView::strokeRadius() const
{
    return mExtent.isEmpty() ? 0.001 : mExtent.diagonal() / 620;
}

void SketchView::rebuildTubes()
{
    mTubesAreOld = true;
    showItems();
}

void SketchView::buildTubes()
{
    mTubesAreOld = false;
    ShadedMesh tubes, sketch;
    // Thinner where a surface is what one looks at.
    const bool isAlone = mMode == ViewMode::Sketch || !mScene.has(shownMesh());
    const double radius = strokeRadius();
    std::vector<Vec3> dots;
    std::vector<Rgba> dotColours, sketchDotColours;
    for (const ViewLine &line : mStrokes) {
        const auto &colours = isAlone || line.coloursOnMesh.empty() ? line.colours : line.coloursOnMesh;
        if (line.points.size() == 1 && line.points.front().allFinite()) {
            dots.push_back(line.points.front());
            dotColours.push_back(colours.front());
            sketchDotColours.push_back(line.colours.front());
            continue;
        }
        appendTube(line.points, radius * line.width * (isAlone ? 1.0 : 0.8), colours, 6, tubes);
        if (mDivider)
            appendTube(line.points, radius * line.width, line.colours, 6, sketch);
    }
    mScene.setMesh(SceneItem::Strokes, tubes);
    mScene.setMesh(SceneItem::Sketch, sketch);
    const double pixels = devicePixelRatioF() * (dots.size() > manyDots ? 2.0 : 3.0);
    mScene.setDots(SceneItem::Dots, dots, dotColours, pixels);
    mScene.setDots(SceneItem::SketchDots, mDivider ? dots : std::vector<Vec3>(), sketchDotColours, pixels);
    showStrokeItems();
}

void SketchView::showStrokeItems()
{
    for (const SceneItem item : {SceneItem::Strokes, SceneItem::Dots})
        mScene.setVisible(item, mStrokesShown || mMode == ViewMode::Sketch);
    for (const SceneItem item : {SceneItem::Sketch, SceneItem::SketchDots})
        mScene.setVisible(item, true);
}

void SketchView::setStrokes(const std::vector<ViewLine> &lines)
{
    mStrokes = lines;
    rebuildTubes();
}

void SketchView::setScribbles(const std::vector<ViewLine> &lines)
{
    ShadedMesh tubes;
    for (const ViewLine &line : lines)
        appendTube(line.points, 1.9 * strokeRadius() * line.width, line.colours, 8, tubes);
    mScene.setMesh(SceneItem::Scribbles, tubes);
    showItems();
}

void SketchView::setMesh(SceneItem item, const ViewMesh &mesh)
{
    const bool hadMesh = mScene.has(shownMesh());
    mMeshes[std::size_t(item)] = mesh;
    mScene.setMesh(item, mesh.shaded);
    if (mScene.has(shownMesh()) != hadMesh)
        rebuildTubes(); // strokes look otherwise alone
    else
        showItems();
}

void SketchView::setCreases(const std::vector<std::vector<Vec3>> &lines)
{
    mScene.setCreases(lines, devicePixelRatioF());
    showItems();
}

void SketchView::setGround(const GroundShadow &shadow)
{
    mScene.setGround(shadow);
    showItems();
}

void SketchView::setMode(ViewMode mode)
{
    if (mode == mMode)
        return;
    mMode = mode;
    rebuildTubes();
    emit modeChanged(mode);
}

void SketchView::setStrokesShown(bool shown)
{
    mStrokesShown = shown;
    showItems();
}

void SketchView::setScribblesShown(bool shown)
{
    mScribblesShown = shown;
    showItems();
}

void SketchView::setAmbiguityShown(bool shown)
{
    if (shown == mAmbiguityShown)
        return;
    mAmbiguityShown = shown;
    showItems();
}

void SketchView::setComparison(std::optional<double> divider)
{
    const bool starts = divider.has_value() != mDivider.has_value();
    mDivider = divider;
    if (starts)
        rebuildTubes();
    moved();
}

void SketchView::setDark(bool dark)
{
    mDark = dark;
    if (dark)
        mScene.setBackground({52, 57, 64, 255}, {24, 26, 30, 255});
    else
        mScene.setBackground({250, 251, 252, 255}, {214, 219, 226, 255});
    update();
    mOverlay->update();
}

void SketchView::showItems()
{
    const SceneItem mesh = shownMesh();
    for (const SceneItem item : {SceneItem::Proxy, SceneItem::Regions, SceneItem::Surface,
                                 SceneItem::Deviation, SceneItem::Ambiguity})
        mScene.setVisible(item, mMode != ViewMode::Sketch && item == mesh);
    const bool hasSurface =
        mMode == ViewMode::Surface || mMode == ViewMode::Deviation || mMode == ViewMode::Regions;
    mScene.setVisible(SceneItem::Creases, hasSurface && mScene.has(mesh) && mesh != SceneItem::Regions);
    showStrokeItems();
    mScene.setVisible(SceneItem::Scribbles, hasSurface && (mScribblesShown || mMode == ViewMode::Regions));
    mScene.setVisible(SceneItem::Ground, true);
    moved();
}

void SketchView::drawSmoothly()
{
    mIsSmooth = true;
    update();
}

void SketchView::moved()
{
    const bool isQuick = mIsSmooth && frameCount() > 0 && lastFrameMilliseconds() < quickFrame;
    mIsSmooth = isQuick;
    if (!isQuick)
        mAtRest.start();
    update();
    mOverlay->update();
    emit cameraMoved();
}

void SketchView::setPreset(ViewPreset preset)
{
    mCamera.setPreset(preset);
    frameAll();
}

void SketchView::setPerspective(bool on)
{
    mCamera.setPerspective(on);
    moved();
}

void SketchView::frameAll()
{
    mCamera.setViewport(QSizeF(size()));
    mCamera.frame(mExtent);
    mFramed = isVisible() && !mExtent.isEmpty(); // the size before the first show is not the final one
    moved();
}

void SketchView::orbitBy(const QPointF &pixels)
{
    mCamera.orbit(pixels);
    moved();
}

void SketchView::zoomBy(double factor)
{
    mCamera.zoom(factor, QPointF(0.5 * width(), 0.5 * height()));
    moved();
}

void SketchView::turnBy(double rounds)
{
    mCamera.turn(rounds);
    moved();
}

void SketchView::showMark(const ViewMark &mark)
{
    const ViewMesh &mesh = pickMesh();
    const double apart = mark.other ? (mark.at - *mark.other).norm() : 0.0;
    const Vec3 radius = Vec3::Constant(std::max(markNearness * mExtent.diagonal(), 1.2 * apart));
    Box3 around;
    around.add(mark.centre() - radius);
    around.add(mark.centre() + radius);
    ViewCamera camera = mCamera;
    if (mesh.tree)
        camera.lookFrom(freeDirection(mark, *mesh.tree, -mCamera.forward(), mExtent.diagonal() / 500));
    camera.frame(around);
    mOverlay->setMark(mark);
    flyTo(camera);
}

bool SketchView::clearMark()
{
    const bool had = mOverlay->mark().has_value();
    mOverlay->setMark(std::nullopt);
    return had;
}

void SketchView::flyTo(const ViewCamera &camera)
{
    mFlight.stop();
    mFlight.disconnect(this);
    connect(&mFlight, &QVariantAnimation::valueChanged, this,
            [this, from = mCamera, camera](const QVariant &share) {
                mCamera = from.towards(camera, share.toDouble());
                moved();
            });
    mFlight.start();
}

QImage SketchView::smoothPicture()
{
    const bool before = std::exchange(mIsSmooth, true);
    QImage picture = grabFramebuffer();
    mIsSmooth = before;
    return picture;
}

const ViewMesh &SketchView::pickMesh() const
{
    static const ViewMesh none;
    return mMode == ViewMode::Sketch ? none : mMeshes[std::size_t(shownMesh())];
}

std::optional<RayHit> SketchView::surfaceAt(const QPointF &position) const
{
    const ViewMesh &mesh = pickMesh();
    if (!mesh.tree || mesh.tree->isEmpty())
        return std::nullopt;
    const ViewRay ray = mCamera.ray(position);
    return mesh.tree->firstHit(ray.origin, ray.direction);
}

int SketchView::strokeAt(const QPointF &position, double reach, int except) const
{
    int best = -1;
    double nearest = reach;
    const auto consider = [&](std::size_t line, const Vec3 &at, double pixels) {
        if (pixels >= nearest)
            return;
        const ViewRay ray = mCamera.ray(*mCamera.project(at));
        const ViewMesh &mesh = pickMesh();
        const double depth = (at - ray.origin).norm();
        const double inSurface = mExtent.diagonal() / 100;
        if (mesh.tree && mesh.tree->isBlocked(ray.origin, ray.direction, 0.0, depth - inSurface))
            return;
        nearest = pixels;
        best = int(line);
    };
    for (std::size_t i = 0; i < mStrokes.size(); ++i) {
        if (int(i) == except)
            continue;
        const std::vector<Vec3> &points = mStrokes[i].points;
        std::optional<QPointF> before;
        for (std::size_t k = 0; k < points.size(); ++k) {
            const std::optional<QPointF> here = mCamera.project(points[k]);
            double share = 0.0;
            if (before && here) {
                const double d = distanceToSegment(position, *before, *here, &share);
                consider(i, points[k - 1] + share * (points[k] - points[k - 1]), d);
            } else if (here && points.size() == 1) {
                consider(i, points[k], distanceToSegment(position, *here, *here, &share));
            }
            before = here;
        }
    }
    return best;
}

void SketchView::setTool(ViewTool *tool)
{
    if (mTool)
        mTool->cancel(*this);
    mTool = tool;
    mDrag = Drag::None;
    setCursor(tool ? tool->cursor() : QCursor(Qt::ArrowCursor));
    mOverlay->update();
}

bool SketchView::cancelTool()
{
    if (mDrag == Drag::Tool)
        mDrag = Drag::None;
    const bool had = mTool && mTool->cancel(*this);
    mOverlay->update();
    return had;
}

void SketchView::prepareFrame()
{
    if (!mFramed && !mExtent.isEmpty()) {
        mCamera.setViewport(QSizeF(size()));
        mCamera.frame(mExtent);
        mFramed = true;
    }
    if (mTubesAreOld)
        buildTubes();
    mScene.setSmoothEdges(mIsSmooth);
    mScene.follow(mCamera, mMode == ViewMode::Sketch ? std::nullopt : mDivider);
}

void SketchView::resizeEvent(QResizeEvent *event)
{
    VtkWidget::resizeEvent(event);
    mCamera.setViewport(QSizeF(size()));
    mOverlay->setGeometry(rect());
    emit cameraMoved();
}

} // namespace ductus
