#include "painting/coverage/stroke_segments.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ductus {

namespace {

/// A place of the centreline, in the element's space; directions are turned into the scene at the end, so
/// that mirrored strokes are exact mirror images.
struct Station
{
    Vec3 position;
    Vec3 normal;
    double radius = 0;
    Eigen::Vector3f colour;
    float opacity = 1;
    std::uint32_t index = 0;
    Vec3 across = Vec3::UnitX(); // U
};

std::vector<Station> stationsOf(const StrokeShape &stroke, const std::optional<Eigen::Vector3f> &colour)
{
    std::vector<Station> stations;
    for (std::size_t i = 0; i < stroke.points.size(); ++i) {
        const PaintedPoint &point = stroke.points[i];
        const Station station{point.position.cast<double>(),
                              point.normal.cast<double>(),
                              point.halfWidth,
                              colour.value_or(point.colour),
                              point.opacity,
                              std::uint32_t(i)};
        if (!stations.empty()) {
            Station &last = stations.back();
            // What 32-bit positions cannot tell apart, and what could not be seen.
            const double same = std::max(1e-6 * station.position.cwiseAbs().maxCoeff(),
                                         1e-5 * std::max(last.radius, station.radius));
            if ((station.position - last.position).norm() <= same) {
                last.radius = std::max(last.radius, station.radius);
                continue;
            }
        }
        stations.push_back(station);
    }
    return stations;
}

class Building
{
public:
    Building(const StrokeShape &stroke, const Eigen::Affine3d &sceneFromElement, std::uint32_t element,
             const std::optional<Eigen::Vector3f> &colour, std::vector<SegmentData> &segments)
        : mSection(stroke.section), mTransform(sceneFromElement), mElement(element),
          mScale(std::cbrt(std::abs(sceneFromElement.linear().determinant()))),
          mStations(stationsOf(stroke, colour)), mSegments(segments)
    {
    }

    void run()
    {
        if (mStations.size() == 1)
            makeDab();
        const std::size_t count = mStations.size();
        for (std::size_t i = 0; i + 1 < count; ++i) {
            mLengths.push_back((mStations[i + 1].position - mStations[i].position).norm());
            mChords.push_back((mStations[i + 1].position - mStations[i].position) / mLengths.back());
        }
        for (std::size_t i = 0; i < count; ++i) {
            const Vec3 sum = (i > 0 ? mChords[i - 1] : Vec3(Vec3::Zero())) +
                             (i + 1 < count ? mChords[i] : Vec3(Vec3::Zero()));
            const Vec3 tangent = sum.norm() > 1e-3 ? Vec3(sum.normalized()) : mChords[std::min(i, count - 2)];
            orient(i, tangent);
            mTangents.push_back(tangent);
            mSmooth.push_back(i > 0 && i + 1 < count && isSmooth(i));
        }
        for (std::size_t i = 0; i + 1 < count; ++i)
            mTurns.push_back(turn(i));
        for (std::size_t i = 0; i + 1 < count; ++i) {
            if (i > 0 && !mSmooth[i] && mSection != StrokeSection::Ribbon)
                addKnuckle(i);
            addBetween(i);
        }
    }

private:
    void makeDab()
    {
        Station &only = mStations.front();
        if (mSection == StrokeSection::Round) {
            if (only.radius > 0)
                mSegments.push_back(begun(only, only));
            mStations.clear();
            return;
        }
        const Vec3 normal = only.normal.norm() > 1e-7 ? only.normal.normalized() : Vec3(Vec3::UnitY());
        const Vec3 half = std::max(only.radius, 1e-12) * normal.unitOrthogonal();
        mStations.push_back(only);
        mStations.front().position -= half;
        mStations.back().position += half;
    }

    void orient(std::size_t i, const Vec3 &tangent)
    {
        Vec3 across = mStations[i].normal.cross(tangent);
        if (across.norm() < 1e-6 && i > 0) // without a normal of use: as the one before
            across = mStations[i - 1].across - mStations[i - 1].across.dot(tangent) * tangent;
        mStations[i].across = across.norm() < 1e-6 ? tangent.unitOrthogonal() : across.normalized();
    }

    /// Whether both sides may be cut at the mitre plane: it meets no other joint's inside the stroke, and the
    /// sections of both sides agree there to half a hundredth of the half width.
    bool isSmooth(std::size_t i) const
    {
        const double cosine = mChords[i - 1].dot(mChords[i]), radius = mStations[i].radius;
        if (cosine < 0.5)
            return false;
        const double tilt = std::sqrt(std::max(0.0, (1 - cosine) / (1 + cosine))); // tan of half the bend
        const double widestTilt = tilt * std::max({radius, mStations[i - 1].radius, mStations[i + 1].radius});
        const double before = (radius - mStations[i - 1].radius) / mLengths[i - 1];
        const double after = (mStations[i + 1].radius - radius) / mLengths[i];
        if (mSection != StrokeSection::Round) // flat ends are closed: their sections need not agree
            return widestTilt <= 0.5 * std::min(mLengths[i - 1], mLengths[i]);
        if (tilt > 0.01 && std::max(std::abs(before), std::abs(after)) > 0.9)
            return false; // one ball swallows the other
        return widestTilt <= 0.5 * std::min(mLengths[i - 1], mLengths[i]) &&
               std::abs(after - before) * tilt <= 0.005;
    }

    /// Fills the wedge between two flat ends at a sharp bend.
    void addKnuckle(std::size_t i)
    {
        Station from = mStations[i], to = from;
        const double half = from.radius * std::sqrt(std::max(0.0, (1 - mChords[i - 1].dot(mChords[i])) / 2));
        if (mSection == StrokeSection::Round || half <= 1e-3 * from.radius)
            return;
        from.position -= half * mTangents[i];
        to.position += half * mTangents[i];
        addFlat(from, to, mTangents[i], mTangents[i], true, true);
    }

    void addBetween(std::size_t i)
    {
        const Station &a = mStations[i], &b = mStations[i + 1];
        if (a.radius == 0 && b.radius == 0)
            return;
        const Vec3 &chord = mChords[i];
        const bool joinedA = mSmooth[i], joinedB = mSmooth[i + 1];
        const Vec3 &planeA = joinedA ? mTangents[i] : chord, &planeB = joinedB ? mTangents[i + 1] : chord;
        if (mSection == StrokeSection::Round) {
            SegmentData segment = begun(a, b);
            segment.clipA = joinedA ? direction(planeA) : Eigen::Vector3f(Eigen::Vector3f::Zero());
            segment.clipB = joinedB ? direction(planeB) : Eigen::Vector3f(Eigen::Vector3f::Zero());
            mSegments.push_back(segment);
            return;
        }
        const Vec3 acrossB = a.across.dot(b.across) < 0 ? Vec3(-b.across) : b.across;
        const int parts = std::max(1, int(std::ceil(mTurns[i] * 90 / std::numbers::pi - 1e-6)));
        const bool openA = joinedA && isOpen(i), openB = joinedB && isOpen(i + 1);
        for (int k = 0; k < parts; ++k) {
            const Station from = between(a, b, acrossB, double(k) / parts);
            const Station to = between(a, b, acrossB, double(k + 1) / parts);
            const auto plane = [&](int j) -> Vec3 {
                return ((1 - double(j) / parts) * planeA + double(j) / parts * planeB).normalized();
            };
            addFlat(from, to, plane(k), plane(k + 1), !(k == 0 && openA), !(k + 1 == parts && openB));
        }
    }

    /// By how much U turns from a station to the next, radians.
    double turn(std::size_t i) const
    {
        return std::acos(std::min(1.0, std::abs(mStations[i].across.dot(mStations[i + 1].across))));
    }

    /// Whether flat neighbours meet so exactly at a shared plane that it need not be skin.
    bool isOpen(std::size_t i) const
    {
        return mChords[i - 1].dot(mChords[i]) > 0.998 && std::max(mTurns[i - 1], mTurns[i]) < 0.03;
    }

    static Station between(const Station &a, const Station &b, const Vec3 &acrossB, double t)
    {
        Station station = a;
        station.position = (1 - t) * a.position + t * b.position;
        station.radius = (1 - t) * a.radius + t * b.radius;
        station.colour = float(1 - t) * a.colour + float(t) * b.colour;
        station.opacity = float(1 - t) * a.opacity + float(t) * b.opacity;
        station.across = ((1 - t) * a.across + t * acrossB).normalized();
        return station;
    }

    void addFlat(const Station &from, const Station &to, const Vec3 &planeA, const Vec3 &planeB, bool capA,
                 bool capB)
    {
        SegmentData segment = begun(from, to);
        if (mSection == StrokeSection::Ribbon) {
            segment.u = direction(from.across);
            segment.v = direction(to.across);
            mSegments.push_back(segment);
            return;
        }
        const Vec3 along = (planeA + planeB).normalized();
        Vec3 across = from.across + to.across;
        across -= across.dot(along) * along;
        across = across.norm() > 1e-6 ? Vec3(across.normalized()) : along.unitOrthogonal();
        segment.u = direction(across);
        segment.v = direction(along.cross(across));
        segment.clipA = direction(planeA);
        segment.clipB = direction(planeB);
        segment.caps = (capA ? SegmentData::capAtA : 0) | (capB ? SegmentData::capAtB : 0);
        mSegments.push_back(segment);
    }

    SegmentData begun(const Station &a, const Station &b) const
    {
        SegmentData segment;
        segment.a = (mTransform * a.position).cast<float>();
        segment.b = (mTransform * b.position).cast<float>();
        segment.radiusA = float(mScale * a.radius);
        segment.radiusB = float(mScale * b.radius);
        segment.section = std::uint32_t(mSection);
        segment.opacityA = a.opacity;
        segment.opacityB = b.opacity;
        segment.colourA = a.colour;
        segment.colourB = b.colour;
        segment.element = mElement;
        segment.pointIndex = a.index;
        return segment;
    }

    Eigen::Vector3f direction(const Vec3 &inElement) const
    {
        return (mTransform.linear() * inElement / mScale).normalized().cast<float>();
    }

    StrokeSection mSection;
    Eigen::Affine3d mTransform;
    std::uint32_t mElement;
    double mScale;
    std::vector<Station> mStations;
    std::vector<Vec3> mChords, mTangents; // unit: from each station to the next; mean direction at each
    std::vector<double> mLengths, mTurns;
    std::vector<bool> mSmooth; // joints at which neighbours share a plane
    std::vector<SegmentData> &mSegments;
};

} // namespace

void appendStrokeSegments(const StrokeShape &stroke, const Eigen::Affine3d &sceneFromElement,
                          std::uint32_t element, const std::optional<Eigen::Vector3f> &colour,
                          std::vector<SegmentData> &segments)
{
    if (!stroke.points.empty())
        Building(stroke, sceneFromElement, element, colour, segments).run();
}

} // namespace ductus
