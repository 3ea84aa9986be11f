#include "doodling/reconstruction/cameras/camera_path.h"

#include "doodling/reconstruction/cameras/bundle_adjustment.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr double growthUntilAdjusting = 1.4;
constexpr int mostRays = 14;             // sightings a point is found from
constexpr double sightingSpread = 0.4;   // pixels, of a track
constexpr double mostDepthSpread = 0.25; // of the usual inverse depth: vaguer points wait for more frames

double medianOf(std::vector<double> values)
{
    if (values.empty())
        return 0.0;
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

class PathGrower
{
public:
    PathGrower(const std::vector<PointTrack> &tracks, int frameCount, bool isRotationOnly,
               const CameraPathOptions &options, const JobControl &control)
        : mTracks(tracks), mTracksIn(std::size_t(frameCount)), mIsRotationOnly(isRotationOnly),
          mOptions(options), mControl(control)
    {
        mPath.cameras.resize(std::size_t(frameCount));
        mPath.isKnown.assign(std::size_t(frameCount), false);
        mPath.points.resize(tracks.size());
        for (std::size_t i = 0; i < tracks.size(); ++i)
            for (int t = tracks[i].firstFrame; t < tracks[i].endFrame(); ++t)
                mTracksIn[std::size_t(t)].push_back(int(i));
    }

    void start(int frame, const ShotCamera &camera)
    {
        mPath.cameras[std::size_t(frame)] = camera;
        mPath.isKnown[std::size_t(frame)] = true;
        mMostMiss = mOptions.mostMiss * std::max(1.0, 2.0 * camera.centre.x() / 854.0);
    }

    CameraPath grow()
    {
        addPoints();
        adjust(false);
        fillBetween();
        int adjusted = knownCount();
        for (int frame = nextFrame(); frame >= 0 && !mControl.isCancelled(); frame = nextFrame()) {
            if (!placeFrame(frame))
                break;
            addPoints();
            if (knownCount() >= growthUntilAdjusting * adjusted + 1) {
                adjust(knownCount() >= 6);
                adjusted = knownCount();
            }
        }
        for (int round = 0; round < 2 && !mControl.isCancelled(); ++round) {
            addPoints();
            adjust(true, true);
        }
        rate();
        return std::move(mPath);
    }

private:
    int frameCount() const { return int(mPath.cameras.size()); }
    int knownCount() const { return int(std::count(mPath.isKnown.begin(), mPath.isKnown.end(), true)); }
    const ShotCamera &camera(int frame) const { return mPath.cameras[std::size_t(frame)]; }

    // Frames between the two of the start, which are known first.
    void fillBetween()
    {
        const auto first =
            std::find(mPath.isKnown.begin(), mPath.isKnown.end(), true) - mPath.isKnown.begin();
        int last = frameCount() - 1;
        while (!mPath.isKnown[std::size_t(last)])
            --last;
        for (int frame = int(first) + 1; frame < last; ++frame)
            placeFrame(frame);
        addPoints();
        adjust(false);
    }

    // The unknown neighbour of the known frames with most known points.
    int nextFrame() const
    {
        int best = -1, mostSeen = -1;
        for (int t = 0; t < frameCount(); ++t) {
            const bool hasNeighbour = (t > 0 && mPath.isKnown[std::size_t(t) - 1]) ||
                                      (t + 1 < frameCount() && mPath.isKnown[std::size_t(t) + 1]);
            if (mPath.isKnown[std::size_t(t)] || !hasNeighbour)
                continue;
            const int seen = int(sightingsIn(t).size());
            if (seen > mostSeen) {
                mostSeen = seen;
                best = t;
            }
        }
        return best;
    }

    std::vector<PointSighting> sightingsIn(int frame) const
    {
        std::vector<PointSighting> sightings;
        for (int i : mTracksIn[std::size_t(frame)])
            if (mPath.points[std::size_t(i)])
                sightings.push_back({*mPath.points[std::size_t(i)], mTracks[std::size_t(i)].at(frame)});
        return sightings;
    }

    bool placeFrame(int frame)
    {
        const std::vector<PointSighting> sightings = sightingsIn(frame);
        int near = -1;
        for (int gap = 1; near < 0 && gap < frameCount(); ++gap)
            for (int t : {frame - gap, frame + gap})
                if (near < 0 && t >= 0 && t < frameCount() && mPath.isKnown[std::size_t(t)])
                    near = t;
        if (near < 0)
            return false;
        ShotCamera placed = camera(near);
        const CameraFit fit = fitCamera(placed, sightings, mIsRotationOnly, mMostMiss);
        if (fit.inliers < mOptions.fewestPoints)
            return false;
        mPath.cameras[std::size_t(frame)] = placed;
        mPath.isKnown[std::size_t(frame)] = true;
        return true;
    }

    // Frames a track is seen in and known, evenly thinned.
    std::vector<int> knownFramesOf(const PointTrack &track) const
    {
        std::vector<int> frames;
        for (int t = track.firstFrame; t < track.endFrame(); ++t)
            if (mPath.isKnown[std::size_t(t)])
                frames.push_back(t);
        if (int(frames.size()) <= mostRays)
            return frames;
        std::vector<int> thinned;
        for (int i = 0; i < mostRays; ++i)
            thinned.push_back(frames[std::size_t(i) * (frames.size() - 1) / (mostRays - 1)]);
        return thinned;
    }

    // One over the usual distance of the points from the first camera.
    double usualInverseDepth() const
    {
        int frame = 0;
        while (frame + 1 < frameCount() && !mPath.isKnown[std::size_t(frame)])
            ++frame;
        std::vector<double> inverses;
        for (const auto &point : mPath.points)
            if (point && point->w() > 1e-9 * point->norm()) {
                const double depth = camera(frame).depthOf(point->head<3>() / point->w());
                if (depth > 0.0)
                    inverses.push_back(1.0 / depth);
            }
        return medianOf(std::move(inverses));
    }

    void addPoints()
    {
        const double usual = mIsRotationOnly ? 0.0 : usualInverseDepth();
        for (std::size_t i = 0; i < mTracks.size(); ++i) {
            if (mPath.points[i])
                continue;
            const std::vector<int> frames = knownFramesOf(mTracks[i]);
            if (mIsRotationOnly ? frames.empty() : frames.size() < 2)
                continue;
            mPath.points[i] =
                mIsRotationOnly ? directionOf(mTracks[i], frames) : pointOf(mTracks[i], frames, usual);
        }
    }

    std::optional<HomogeneousPoint> directionOf(const PointTrack &track, const std::vector<int> &frames) const
    {
        Vec3 sum = Vec3::Zero();
        for (int t : frames)
            sum += camera(t).rayOf(track.at(t)).normalized();
        const HomogeneousPoint point(sum.x(), sum.y(), sum.z(), 0.0);
        if (missOf(track, point, frames) > 2.0 * mMostMiss)
            return std::nullopt;
        return point;
    }

    std::optional<HomogeneousPoint> pointOf(const PointTrack &track, const std::vector<int> &frames,
                                            double usual) const
    {
        const int reference = frames[frames.size() / 2];
        std::vector<RaySighting> rays;
        for (int t : frames)
            if (t != reference)
                rays.push_back({&camera(t), track.at(t), 1.0});
        const InverseDepthFit fit =
            fitInverseDepth(camera(reference), track.at(reference), rays, usual, mMostMiss);
        if (!(fit.information > 0.0) || fit.miss > mMostMiss)
            return std::nullopt;
        const double spread = sightingSpread / std::sqrt(fit.information);
        if (usual > 0.0 && spread > mostDepthSpread * std::max(usual, fit.inverseDepth))
            return std::nullopt;
        if (fit.inverseDepth < -2.0 * spread)
            return std::nullopt;
        const double inverse = std::max(fit.inverseDepth, 0.0);
        const Vec3 place =
            camera(reference).position() * inverse + camera(reference).rayOf(track.at(reference));
        return HomogeneousPoint(place.x(), place.y(), place.z(), inverse);
    }

    double missOf(const PointTrack &track, const HomogeneousPoint &point,
                  const std::vector<int> &frames) const
    {
        std::vector<double> misses;
        for (int t : frames) {
            const std::optional<Vec2> seen = projected(camera(t), point);
            misses.push_back(seen ? (*seen - track.at(t)).norm() : 1e6);
        }
        // Not the worst one: a track may slip at its end. Not the median: what moves slowly must be found
        // out.
        std::sort(misses.begin(), misses.end());
        return misses.empty() ? 0.0 : misses[misses.size() * 3 / 4];
    }

    std::vector<int> adjustedFrames(int most) const
    {
        std::vector<int> known;
        for (int t = 0; t < frameCount(); ++t)
            if (mPath.isKnown[std::size_t(t)])
                known.push_back(t);
        if (int(known.size()) <= most)
            return known;
        std::vector<int> thinned;
        for (int i = 0; i < most; ++i)
            thinned.push_back(known[std::size_t(i) * (known.size() - 1) / std::size_t(most - 1)]);
        return thinned;
    }

    void adjust(bool solvesFocal, bool isLast = false)
    {
        const std::vector<int> frames =
            adjustedFrames(isLast ? mOptions.mostAdjustedFrames : mOptions.mostAdjustedFrames / 2);
        Bundle bundle;
        std::vector<int> cameraOf(std::size_t(frameCount()), -1);
        for (int t : frames) {
            cameraOf[std::size_t(t)] = int(bundle.cameras.size());
            bundle.cameras.push_back(camera(t));
        }
        const std::vector<int> chosen = adjustedTracks(cameraOf);
        for (int i : chosen) {
            const PointTrack &track = mTracks[std::size_t(i)];
            for (int t = track.firstFrame; t < track.endFrame(); ++t)
                if (cameraOf[std::size_t(t)] >= 0)
                    bundle.sightings.push_back(
                        {cameraOf[std::size_t(t)], int(bundle.points.size()), track.at(t)});
            bundle.points.push_back(*mPath.points[std::size_t(i)]);
        }
        BundleOptions options;
        options.isRotationOnly = mIsRotationOnly;
        options.solvesFocal = solvesFocal;
        options.iterations = isLast ? 25 : 10;
        const double usual = mIsRotationOnly ? 0.0 : usualInverseDepth();
        options.usualDepth = usual > 0.0 ? 1.0 / usual : 0.0;
        const Vec2 centre = bundle.cameras.front().centre;
        options.likelyFocal = mOptions.likelyFocalShare * 2.0 * centre.maxCoeff();
        if (!adjustBundle(bundle, options, mControl))
            return;
        for (std::size_t k = 0; k < frames.size(); ++k)
            mPath.cameras[std::size_t(frames[k])] = bundle.cameras[k];
        for (std::size_t k = 0; k < chosen.size(); ++k)
            mPath.points[std::size_t(chosen[k])] = bundle.points[k];
        refitOthers(cameraOf, bundle.cameras.front().focal);
        dropWhatMoves();
    }

    // The longest of those seen in several of the frames.
    std::vector<int> adjustedTracks(const std::vector<int> &cameraOf) const
    {
        std::vector<std::pair<int, int>> counted;
        for (std::size_t i = 0; i < mTracks.size(); ++i) {
            int count = 0;
            if (mPath.points[i])
                for (int t = mTracks[i].firstFrame; t < mTracks[i].endFrame(); ++t)
                    count += cameraOf[std::size_t(t)] >= 0;
            if (count >= 2)
                counted.emplace_back(-count, int(i));
        }
        std::sort(counted.begin(), counted.end());
        if (int(counted.size()) > mOptions.mostAdjustedPoints)
            counted.resize(std::size_t(mOptions.mostAdjustedPoints));
        std::vector<int> chosen;
        for (const auto &[count, track] : counted)
            chosen.push_back(track);
        return chosen;
    }

    void refitOthers(const std::vector<int> &cameraOf, double focal)
    {
        for (int t = 0; t < frameCount(); ++t) {
            if (!mPath.isKnown[std::size_t(t)] || cameraOf[std::size_t(t)] >= 0)
                continue;
            mPath.cameras[std::size_t(t)].focal = focal;
            fitCamera(mPath.cameras[std::size_t(t)], sightingsIn(t), mIsRotationOnly, mMostMiss);
        }
    }

    void dropWhatMoves()
    {
        for (std::size_t i = 0; i < mTracks.size(); ++i) {
            if (!mPath.points[i])
                continue;
            const std::vector<int> frames = knownFramesOf(mTracks[i]);
            if (missOf(mTracks[i], *mPath.points[i], frames) > mMostMiss)
                mPath.points[i].reset();
        }
    }

    void rate()
    {
        std::size_t explained = 0, all = 0;
        std::vector<double> medians;
        std::vector<int> explainedIn(mTracksIn.size(), 0);
        for (std::size_t i = 0; i < mTracks.size(); ++i) {
            all += mTracks[i].pixels.size();
            if (!mPath.points[i])
                continue;
            for (int t = mTracks[i].firstFrame; t < mTracks[i].endFrame(); ++t) {
                if (!mPath.isKnown[std::size_t(t)])
                    continue;
                const std::optional<Vec2> seen = projected(camera(t), *mPath.points[i]);
                const double miss = seen ? (*seen - mTracks[i].at(t)).norm() : 1e6;
                explained += miss < mMostMiss;
                explainedIn[std::size_t(t)] += miss < mMostMiss;
                medians.push_back(miss);
            }
        }
        mPath.explainedShare = all > 0 ? double(explained) / double(all) : 0.0;
        mPath.leastFrameShare = 1.0;
        for (std::size_t t = 0; t < mTracksIn.size(); ++t)
            mPath.leastFrameShare = std::min(
                mPath.leastFrameShare, double(explainedIn[t]) / std::max(1.0, double(mTracksIn[t].size())));
        mPath.medianMiss = medianOf(std::move(medians));
    }

    const std::vector<PointTrack> &mTracks;
    std::vector<std::vector<int>> mTracksIn; // by frame
    bool mIsRotationOnly;
    double mMostMiss = 1.5;
    const CameraPathOptions &mOptions;
    const JobControl &mControl;
    CameraPath mPath;
};

} // namespace

bool CameraPath::isComplete() const
{
    return std::find(isKnown.begin(), isKnown.end(), false) == isKnown.end();
}

CameraPath growCameraPath(const std::vector<PointTrack> &tracks, int frameCount, const FirstPair &start,
                          const CameraPathOptions &options, const JobControl &control)
{
    PathGrower grower(tracks, frameCount, false, options, control);
    grower.start(start.first, start.firstCamera);
    grower.start(start.second, start.secondCamera);
    return grower.grow();
}

CameraPath growTurningPath(const std::vector<PointTrack> &tracks, int frameCount, const ShotCamera &lens,
                           const CameraPathOptions &options, const JobControl &control)
{
    PathGrower grower(tracks, frameCount, true, options, control);
    grower.start(frameCount / 2, lens);
    return grower.grow();
}

} // namespace ductus
