#include "doodling/reconstruction/depth/shot_depth.h"

#include "base/parallel.h"
#include "doodling/reconstruction/depth/ground_guess.h"
#include "doodling/reconstruction/depth/moving_cells.h"
#include "doodling/reconstruction/depth/object_depth.h"
#include "doodling/reconstruction/depth/still_depth.h"
#include "doodling/reconstruction/frame_records.h"

#include <algorithm>

namespace ductus {

namespace {

constexpr char attempted[] = "Finding how far away things are";
constexpr double colourSigma = 12.0; // grey levels
constexpr int batch = 8;             // frames worked on side by side
constexpr int mostReach = 32;        // frames to each side that a frame's depth is found from

std::vector<float> disparitiesOf(const DepthMap &map)
{
    std::vector<float> disparities(map.disparities.size());
    for (std::size_t i = 0; i < disparities.size(); ++i)
        disparities[i] = float(map.cellDisparity(i));
    return disparities;
}

DepthMap withObjects(const DepthMap &still, const std::vector<std::uint8_t> &objects,
                     const ObjectDisparities &contacts)
{
    std::vector<float> all = disparitiesOf(still);
    for (std::size_t i = 0; i < objects.size(); ++i)
        if (objects[i] != 0 && contacts[objects[i]] > 0.0f)
            all[i] = contacts[objects[i]];
    DepthMap map = depthMapOf(still.width, still.height, still.cellSize, all);
    map.objects = objects;
    return map;
}

class DepthFinder
{
public:
    DepthFinder(Clip &clip, const ShotOptions &options, ShotStore *store, Shot &shot,
                const JobControl &control)
        : mClip(clip), mOptions(options), mStore(store), mShot(shot), mControl(control),
          mGrid(shot.forward.front()), mFrames(shot.frameCount())
    {
    }

    Result<void> find()
    {
        if (Result<void> found = findObjects(); !found)
            return found;
        if (Result<void> found = findStill(); !found)
            return found;
        smoothOverTime(mContacts);
        for (int t = 0; t < mFrames; ++t)
            if (Result<void> put = putDepth(t); !put)
                return put;
        if (mStore)
            for (RecordKind kind : {RecordKind::Moving, RecordKind::Still})
                mStore->removeAll(kind); // they served to go on where a run was stopped
        return {};
    }

private:
    // Of the frames first.. that \a isWanted; the others' stay empty.
    Result<std::vector<EdgeWeights>> edgesOf(int first, const std::vector<bool> &isWanted)
    {
        std::vector<Image> images(isWanted.size());
        for (std::size_t i = 0; i < isWanted.size(); ++i) {
            if (mControl.isCancelled())
                return cancelledError(attempted);
            if (!isWanted[i])
                continue;
            Result<Image> image = mClip.frame(first + int(i), mOptions.mostLines);
            if (!image)
                return image.error();
            images[i] = std::move(*image);
        }
        std::vector<EdgeWeights> edges(isWanted.size());
        parallelFor(0, isWanted.size(), [&](std::size_t i) {
            if (isWanted[i])
                edges[i] = edgeWeights(images[i], int(mGrid.cellSize), colourSigma);
        });
        return edges;
    }

    Result<void> findObjects()
    {
        mObjects.resize(std::size_t(mFrames));
        for (int first = 0; first < mFrames; first += batch) {
            mControl.progress(0.4 * double(first) / mFrames, "Finding what moves by itself");
            std::vector<bool> isWanted;
            for (int t = first; t < std::min(first + batch, mFrames); ++t)
                isWanted.push_back(!takeMoving(t));
            const Result<std::vector<EdgeWeights>> edges = edgesOf(first, isWanted);
            if (!edges)
                return edges.error();
            parallelFor(0, isWanted.size(), [&](std::size_t i) {
                if (!isWanted[i] || mControl.isCancelled())
                    return;
                std::vector<std::uint8_t> &bytes = mObjects[std::size_t(first) + i];
                const OwnMotion motion = ownMotion(mShot, first + int(i));
                for (float likelihood : movingLikelihood(motion, (*edges)[i], mShot.width))
                    bytes.push_back(std::uint8_t(std::clamp(255.0f * likelihood, 0.0f, 255.0f)));
            });
            if (mControl.isCancelled())
                return cancelledError(attempted);
            for (std::size_t i = 0; i < isWanted.size(); ++i)
                if (isWanted[i])
                    if (Result<void> kept = keepMoving(first + int(i)); !kept)
                        return kept;
            mShot.forgetPages(first - mostReach - batch, first - mostReach);
        }
        mShot.forgetPages(0, mFrames);
        voteAlongFlow(mShot, mObjects);
        mObjects = numberedObjects(mShot, mObjects);
        return {};
    }

    bool takeMoving(int frame)
    {
        if (!mStore)
            return false;
        const std::shared_ptr<const MappedFile> file = mStore->read(RecordKind::Moving, frame);
        if (!file)
            return false;
        RecordReader reader(file);
        const SharedArray<std::uint8_t> bytes = reader.array<std::uint8_t>(mGrid.cellCount());
        if (reader.failed()) {
            mStore->refuse(RecordKind::Moving, frame);
            return false;
        }
        mObjects[std::size_t(frame)].assign(bytes.begin(), bytes.end());
        return true;
    }

    Result<void> keepMoving(int frame)
    {
        if (!mStore)
            return {};
        RecordWriter record;
        record.add<std::uint8_t>(mObjects[std::size_t(frame)]);
        const auto written = mStore->write(RecordKind::Moving, frame, record);
        return written ? Result<void>() : Result<void>(written.error());
    }

    // Depth of what stands still in all frames, and where objects touch it.
    Result<void> findStill()
    {
        mContacts.reserve(std::size_t(mFrames));
        std::vector<float> before;
        for (int first = 0; first < mFrames; first += batch) {
            mControl.progress(0.4 + 0.55 * double(first) / mFrames, attempted);
            const int count = std::min(batch, mFrames - first);
            std::vector<std::optional<DepthMap>> maps;
            std::vector<bool> isWanted;
            for (int t = first; t < first + count; ++t) {
                maps.push_back(takeMap(RecordKind::Still, t));
                isWanted.push_back(!maps.back());
            }
            Result<std::vector<StillFrame>> frames = stillFrames(first, isWanted);
            if (!frames)
                return frames.error();
            for (int i = 0; i < count; ++i) {
                const int t = first + i;
                std::optional<DepthMap> &map = maps[std::size_t(i)];
                if (!map)
                    map = depthMapOf(mGrid.width, mGrid.height, mGrid.cellSize,
                                     stillOf(t, (*frames)[std::size_t(i)], before));
                // As it is kept, so that a run that goes on finds the same.
                before = disparitiesOf(*map);
                mContacts.push_back(
                    contactDisparities(mObjects[std::size_t(t)], before, mGrid.width, mGrid.height));
                if (Result<void> kept = keepStill(t, std::move(*map), isWanted[std::size_t(i)]); !kept)
                    return kept;
            }
            mShot.forgetPages(first - mostReach - batch, first - mostReach);
        }
        mShot.forgetPages(0, mFrames);
        return {};
    }

    Result<std::vector<StillFrame>> stillFrames(int first, const std::vector<bool> &isWanted)
    {
        std::vector<StillFrame> frames(isWanted.size());
        if (mShot.knowledge != CameraKnowledge::SolvedCameras)
            return frames;
        Result<std::vector<EdgeWeights>> edges = edgesOf(first, isWanted);
        if (!edges)
            return edges.error();
        parallelFor(0, isWanted.size(), [&](std::size_t i) {
            if (isWanted[i] && !mControl.isCancelled())
                frames[i] = stillFrame(mShot, first + int(i), std::move((*edges)[i]),
                                       mObjects[std::size_t(first) + i]);
        });
        if (mControl.isCancelled())
            return cancelledError(attempted);
        return frames;
    }

    std::vector<float> stillOf(int frame, const StillFrame &still, const std::vector<float> &before) const
    {
        if (mShot.knowledge != CameraKnowledge::SolvedCameras)
            return guessedDisparities(mShot, frame, mGrid);
        return stillDisparities(mShot, frame, still, mObjects[std::size_t(frame)], before);
    }

    std::optional<DepthMap> takeMap(RecordKind kind, int frame)
    {
        const std::shared_ptr<const MappedFile> file = mStore ? mStore->read(kind, frame) : nullptr;
        if (!file)
            return std::nullopt;
        RecordReader reader(file);
        std::optional<DepthMap> map = depthFrom(reader);
        if (!map || map->width != mGrid.width || map->height != mGrid.height) {
            mStore->refuse(kind, frame);
            return std::nullopt;
        }
        return map;
    }

    Result<void> keepStill(int frame, DepthMap map, bool isNew)
    {
        if (!mStore) {
            mShot.depths.push_back(std::move(map));
            return {};
        }
        if (!isNew)
            return {};
        const auto written = mStore->write(RecordKind::Still, frame, recordOf(map));
        return written ? Result<void>() : Result<void>(written.error());
    }

    Result<void> putDepth(int frame)
    {
        const std::size_t t = std::size_t(frame);
        if (!mStore) {
            mShot.depths[t] = withObjects(mShot.depths[t], mObjects[t], mContacts[t]);
            return {};
        }
        const std::optional<DepthMap> still = takeMap(RecordKind::Still, frame);
        if (!still)
            return Error{ErrorCode::WriteFailed, attempted, "what was just found is gone from the cache",
                         "Try again", ""};
        const Result<std::shared_ptr<const MappedFile>> file =
            mStore->write(RecordKind::Depth, frame, recordOf(withObjects(*still, mObjects[t], mContacts[t])));
        if (!file)
            return file.error();
        RecordReader reader(*file);
        std::optional<DepthMap> map = depthFrom(reader);
        DUCTUS_ASSERT(map);
        mShot.depths.push_back(std::move(*map));
        mShot.depthFiles.push_back(*file);
        mShot.forgetPages(frame, frame);
        return {};
    }

    Clip &mClip;
    const ShotOptions &mOptions;
    ShotStore *mStore;
    Shot &mShot;
    const JobControl &mControl;
    const CompactFlow mGrid;
    int mFrames;
    std::vector<std::vector<std::uint8_t>> mObjects; // first likelihoods, then numbers; one a frame
    std::vector<ObjectDisparities> mContacts;        // one a frame
};

} // namespace

bool takeDepth(ShotStore &store, Shot &shot)
{
    std::vector<DepthMap> depths;
    std::vector<std::shared_ptr<const MappedFile>> files;
    if (shot.forward.empty())
        return true; // a single picture: all of it at the scene's depth
    const CompactFlow &grid = shot.forward.front();
    for (int t = 0; t < shot.frameCount(); ++t) {
        std::shared_ptr<const MappedFile> file = store.read(RecordKind::Depth, t);
        if (!file)
            return false;
        RecordReader reader(file);
        std::optional<DepthMap> map = depthFrom(reader);
        if (!map || map->width != grid.width || map->height != grid.height) {
            store.refuse(RecordKind::Depth, t);
            return false;
        }
        file->forgetPages();
        depths.push_back(std::move(*map));
        files.push_back(std::move(file));
    }
    shot.depths = std::move(depths);
    shot.depthFiles = std::move(files);
    return true;
}

Result<void> findDepth(Clip &clip, const ShotOptions &options, ShotStore *store, Shot &shot,
                       const JobControl &control)
{
    if (shot.forward.empty() || (store && takeDepth(*store, shot)))
        return {};
    if (options.report)
        options.report->depthsMade = shot.frameCount();
    return DepthFinder(clip, options, store, shot, control).find();
}

} // namespace ductus
