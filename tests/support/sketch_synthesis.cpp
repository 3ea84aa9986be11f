#include "support/sketch_synthesis.h"

#include "base/assert.h"
#include "support/stroke_hand.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr double reachOfAnArm = 1.5; // diagonals; nobody of CASSIE's drew a longer stroke than 1.6

struct Interval
{
    double begin = 0.0;
    double end = 0.0;
    double length() const { return end - begin; }
};

/// A curve, or in mirror mode the part of it on the drawn half.
struct DrawnPart
{
    std::vector<Vec3> points;
    std::vector<std::size_t> curvePoints; // which points of the feature curve these are
    bool inPlane = false;                 // lies in the mirror plane: is its own image
};

/// The runs of \a points at or above the plane. A run of one point does not count.
std::vector<DrawnPart> partsOnDrawnHalf(const FeatureCurve &curve, const MirrorPlane &plane)
{
    constexpr double tolerance = 1e-7;
    std::vector<DrawnPart> parts;
    DrawnPart part;
    double farthest = 0.0;
    const auto finish = [&] {
        part.inPlane = farthest < tolerance;
        if (part.points.size() >= 2)
            parts.push_back(part);
        part = DrawnPart();
        farthest = 0.0;
    };
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
        const double distance = plane.signedDistance(curve.points[i]);
        if (distance < -tolerance) {
            finish();
            continue;
        }
        part.points.push_back(curve.points[i]);
        part.curvePoints.push_back(i);
        farthest = std::max(farthest, distance);
    }
    finish();
    // A closed curve that starts on the drawn half was cut at its start: put the two runs together again.
    if (parts.size() > 1 && curve.isClosed() && parts.front().curvePoints.front() == 0 &&
        parts.back().curvePoints.back() + 1 == curve.points.size()) {
        DrawnPart &last = parts.back(), &first = parts.front();
        last.points.insert(last.points.end(), first.points.begin() + 1, first.points.end());
        last.curvePoints.insert(last.curvePoints.end(), first.curvePoints.begin() + 1,
                                first.curvePoints.end());
        last.inPlane = last.inPlane && first.inPlane;
        parts.erase(parts.begin());
    }
    return parts;
}

class Draughtsman
{
public:
    Draughtsman(const Solid &solid, const SketchSynthesisOptions &options)
        : mSolid(solid), mOptions(options), mDiagonal(solid.diagonal())
    {
        mMirror = options.mirrorStrokes && solid.mirror ? &*solid.mirror : nullptr;
    }

    SyntheticSketch draw()
    {
        for (std::size_t c = 0; c < mSolid.curves.size(); ++c) {
            mRandom = Random(mOptions.seed).fork(c);
            mCovered.emplace_back(mSolid.curves[c].points.size(), 0);
            drawCurve(int(c));
            // The two ends of a closed curve are one point.
            std::vector<char> &covered = mCovered.back();
            if (mSolid.curves[c].isClosed())
                covered.front() = covered.back() = covered.front() || covered.back();
        }
        mSketch.truth.mesh = mSolid.mesh;
        mSketch.truth.triangleFaces = mSolid.triangleFaces;
        mSketch.truth.faceCount = mSolid.faceCount();
        mSketch.truth.mirror = mSolid.mirror;
        if (mMirror)
            coverImages();
        collectTruth();
        return std::move(mSketch);
    }

private:
    bool isWanted(const FeatureCurve &curve)
    {
        // Always the same draws, so that one option does not shift the random numbers of another.
        const double missing = mRandom.uniform(), share = mRandom.uniform();
        if (missing < mOptions.missingShare)
            return false;
        const bool sharp = std::count(curve.sharp.begin(), curve.sharp.end(), 1) > 0;
        if (curve.kind == CurveKind::Detail)
            return share < mOptions.detailShare;
        if (curve.kind == CurveKind::Flow || (curve.kind == CurveKind::Border && !sharp))
            return share < mOptions.flowShare;
        return true;
    }

    void drawCurve(int c)
    {
        const FeatureCurve &curve = mSolid.curves[c];
        if (!isWanted(curve))
            return;
        std::vector<DrawnPart> parts;
        if (mMirror) {
            parts = partsOnDrawnHalf(curve, *mMirror);
        } else {
            parts.push_back({curve.points, {}, false});
            for (std::size_t i = 0; i < curve.points.size(); ++i)
                parts.back().curvePoints.push_back(i);
        }
        for (const DrawnPart &part : parts)
            drawPart(c, part);
    }

    void drawPart(int c, const DrawnPart &part)
    {
        const ArcLengthCurve curve(part.points);
        for (const Interval &interval : pieces(curve)) {
            addStroke(c, part, curve, interval, Vec3::Zero());
            if (mRandom.uniform() >= mOptions.overdrawProbability)
                continue;
            const int more = mRandom.uniform() < 0.3 ? 2 : 1;
            for (int k = 0; k < more; ++k) {
                const double begin = interval.length() * mRandom.uniform(0.0, 0.25);
                const double end = interval.length() * mRandom.uniform(0.75, 1.0);
                const double x = mRandom.normal(), y = mRandom.normal(), z = mRandom.normal();
                const Vec3 offset = Vec3(x, y, z).normalized() * (mOptions.overdrawOffset * mDiagonal);
                addStroke(c, part, curve, {interval.begin + begin, interval.begin + end}, offset);
            }
        }
    }

    /// The parts of a curve that become a stroke each.
    std::vector<Interval> pieces(const ArcLengthCurve &curve)
    {
        std::vector<Interval> result;
        if (curve.isClosed()) {
            const double start = curve.length() * mRandom.uniform();
            result.push_back(
                {start, start + curve.length() + mDiagonal * mOptions.overshoot * mRandom.uniform(-1, 1)});
        } else {
            result.push_back({0.0, curve.length()});
        }
        for (int round = 0; round < 2; ++round)
            splitLong(result);
        cutGaps(result);
        for (Interval &interval : result) {
            const double reach = std::min(mOptions.overshoot * mDiagonal, 0.1 * interval.length());
            interval.begin += reach * mRandom.uniform(-1.0, 1.0);
            interval.end += reach * mRandom.uniform(-1.0, 1.0);
        }
        return result;
    }

    void splitLong(std::vector<Interval> &intervals)
    {
        std::vector<Interval> result;
        for (const Interval &interval : intervals) {
            const double chance = mRandom.uniform(), where = mRandom.uniform(0.35, 0.65);
            const bool tooLong =
                mOptions.splitProbability > 0.0 && interval.length() > reachOfAnArm * mDiagonal;
            const bool isSplit =
                chance < mOptions.splitProbability && interval.length() >= mOptions.splitLength * mDiagonal;
            if (!tooLong && !isSplit) {
                result.push_back(interval);
                continue;
            }
            const double cut = interval.begin + where * interval.length();
            result.push_back({interval.begin, cut});
            result.push_back({cut, interval.end});
        }
        intervals = result;
    }

    void cutGaps(std::vector<Interval> &intervals)
    {
        std::vector<Interval> result;
        for (const Interval &interval : intervals) {
            const double chance = mRandom.uniform(), where = mRandom.uniform(0.25, 0.75);
            const double gap = mOptions.gapLength * mDiagonal * mRandom.uniform(0.5, 1.5);
            if (chance >= mOptions.gapProbability || gap > 0.4 * interval.length()) {
                result.push_back(interval);
                continue;
            }
            const double centre = interval.begin + where * interval.length();
            result.push_back({interval.begin, centre - gap / 2});
            result.push_back({centre + gap / 2, interval.end});
        }
        intervals = result;
    }

    void addStroke(int c, const DrawnPart &part, const ArcLengthCurve &curve, const Interval &interval,
                   const Vec3 &offset)
    {
        HandOptions hand;
        hand.noise = mOptions.noise * mDiagonal;
        hand.jitter = mOptions.jitter * mDiagonal;
        hand.offset = offset;
        hand.wobbleLength = 0.4 * mDiagonal;
        // Short strokes are drawn slowly: a dozen points even round a knob.
        hand.step = std::min(mOptions.samplingStep * mDiagonal, interval.length() / 8.0);
        hand.unevenness = mOptions.unevenness;
        hand.plane = part.inPlane ? mMirror : nullptr;
        Stroke stroke = drawStroke(curve, interval.begin, interval.end, hand, mRandom);
        if (mSolid.curves[c].kind == CurveKind::Boundary)
            stroke.role = StrokeRole::Boundary;
        append(c, stroke);
        if (mMirror && !part.inPlane) {
            for (Vec3 &point : stroke.points)
                point = mMirror->mirrored(point);
            append(c, stroke);
        }
        for (std::size_t i = 0; i < part.points.size(); ++i)
            if (covers(curve, interval, curve.parameter(i)))
                mCovered[c][part.curvePoints[i]] = 1;
    }

    static bool covers(const ArcLengthCurve &curve, const Interval &interval, double s)
    {
        for (const double turn : {0.0, 1.0})
            if (const double t = s + turn * curve.length();
                (turn == 0.0 || curve.isClosed()) && t >= interval.begin && t <= interval.end)
                return true;
        return false;
    }

    void append(int c, Stroke stroke)
    {
        stroke.id = StrokeId{int(mSketch.strokes.strokes.size())};
        mSketch.strokes.strokes.push_back(std::move(stroke));
        mSketch.strokeCurves.push_back(c);
    }

    /// A point whose mirror image was drawn is drawn: curves that cross the plane, and the twins on the other
    /// half.
    void coverImages()
    {
        std::vector<Vec3> covered;
        for (std::size_t c = 0; c < mCovered.size(); ++c)
            for (std::size_t i = 0; i < mCovered[c].size(); ++i)
                if (mCovered[c][i])
                    covered.push_back(mMirror->mirrored(mSolid.curves[c].points[i]));
        const auto byX = [](const Vec3 &a, const Vec3 &b) { return a.x() < b.x(); };
        std::sort(covered.begin(), covered.end(), byX);
        constexpr double tolerance = 1e-6;
        for (std::size_t c = 0; c < mCovered.size(); ++c) {
            for (std::size_t i = 0; i < mCovered[c].size(); ++i) {
                const Vec3 &point = mSolid.curves[c].points[i];
                if (mCovered[c][i] || mMirror->signedDistance(point) > tolerance)
                    continue;
                auto it =
                    std::lower_bound(covered.begin(), covered.end(), point - Vec3(tolerance, 0, 0), byX);
                for (; it != covered.end() && it->x() <= point.x() + tolerance; ++it)
                    if ((*it - point).norm() < tolerance)
                        mCovered[c][i] = 1;
            }
        }
    }

    /// Runs of curve points that satisfy the condition, as polylines of at least two points.
    template <typename Condition>
    static void addRuns(const std::vector<Vec3> &points, const Condition &condition,
                        std::vector<std::vector<Vec3>> &runs)
    {
        std::vector<Vec3> run;
        for (std::size_t i = 0; i <= points.size(); ++i) {
            if (i < points.size() && condition(i)) {
                run.push_back(points[i]);
                continue;
            }
            if (run.size() >= 2)
                runs.push_back(run);
            run.clear();
        }
    }

    void collectTruth()
    {
        GroundTruth &truth = mSketch.truth;
        for (std::size_t c = 0; c < mSolid.curves.size(); ++c) {
            const FeatureCurve &curve = mSolid.curves[c];
            addRuns(
                curve.points, [&](std::size_t i) { return curve.sharp[i] != 0; }, truth.creases);
            addRuns(
                curve.points, [&](std::size_t i) { return curve.sharp[i] != 0 && mCovered[c][i] != 0; },
                truth.drawnCreases);
            if (curve.kind == CurveKind::Boundary)
                truth.boundaries.push_back(curve.points);
        }
    }

    const Solid &mSolid;
    const SketchSynthesisOptions &mOptions;
    double mDiagonal = 0.0;
    const MirrorPlane *mMirror = nullptr;
    Random mRandom{0};
    std::vector<std::vector<char>> mCovered; // one a curve, one a point: some stroke runs along here
    SyntheticSketch mSketch;
};

} // namespace

SyntheticSketch synthesizeSketch(const Solid &solid, const SketchSynthesisOptions &options)
{
    return Draughtsman(solid, options).draw();
}

} // namespace ductus
