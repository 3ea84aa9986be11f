#include "doodling/storage/doodle_content.h"

#include "doodling/storage/canvas_storage.h"
#include "doodling/storage/depth_storage.h"
#include "doodling/storage/flow_storage.h"
#include "doodling/storage/long_flow_storage.h"
#include "project/container/entry_name.h"

#include <cmath>

namespace ductus {

namespace {

constexpr std::int64_t mostFrames = 1'000'000;
constexpr std::int64_t mostPixels = 65536; // a side
constexpr std::size_t longestPath = 4096;
constexpr double largest = 1e12;

constexpr std::pair<std::string_view, CameraKnowledge> knowledgeNames[] = {
    {"tripod", CameraKnowledge::Tripod},
    {"rotation", CameraKnowledge::RotationOnly},
    {"solved", CameraKnowledge::SolvedCameras}};

std::string_view nameOf(CameraKnowledge knowledge)
{
    for (const auto &[name, value] : knowledgeNames)
        if (value == knowledge)
            return name;
    return knowledgeNames[0].first;
}

// Either all that is known of a frame is there, or nothing but cameras: the clip was not analysed yet.
bool isOfFrames(const Shot &shot, std::size_t frames)
{
    if (shot.cameras.size() != frames)
        return false;
    if (shot.features.empty() && shot.forward.empty() && shot.backward.empty())
        return true;
    return shot.features.size() == frames && shot.forward.size() + 1 == frames &&
           shot.backward.size() + 1 == frames;
}

struct StoredShot
{
    std::vector<StoredFlow> forward, backward;
    std::vector<BufferPacker::Handle> features;
    BufferPacker::Handle cameras = 0;
    StoredLongFlows longFlows;
    StoredDepths depths;
};

// Rotation x y z w, position, focal length, centre of projection.
constexpr std::uint64_t numbersACamera = 10;

StoredShot addShot(const Shot &shot, BufferPacker &packer)
{
    StoredShot stored;
    std::vector<double> cameras;
    for (const ShotCamera &camera : shot.cameras) {
        const Eigen::Quaterniond rotation(camera.worldFromCamera.linear());
        const Vec3 position = camera.position();
        for (double number : {rotation.x(), rotation.y(), rotation.z(), rotation.w(), position.x(),
                              position.y(), position.z(), camera.focal, camera.centre.x(), camera.centre.y()})
            cameras.push_back(number);
    }
    stored.cameras = packer.add<double>(cameras, {shot.cameras.size(), numbersACamera});
    for (const FlowField &flow : shot.forward)
        stored.forward.push_back(addFlow(flow, packer));
    for (const FlowField &flow : shot.backward)
        stored.backward.push_back(addFlow(flow, packer));
    for (const FeatureGrid &grid : shot.features)
        stored.features.push_back(
            packer.add<std::uint8_t>(grid.values, {std::uint64_t(grid.width) * std::uint64_t(grid.height),
                                                   std::uint64_t(grid.channels)}));
    stored.longFlows = addLongFlows(shot, packer);
    stored.depths = addDepths(shot, packer);
    return stored;
}

OrderedJson shotJson(const Shot &shot, const StoredShot &stored, const BufferPacker &packer)
{
    OrderedJson json = {{"width", shot.width},
                        {"height", shot.height},
                        {"knowledge", nameOf(shot.knowledge)},
                        {"sceneDepth", shot.sceneDepth},
                        {"cameras", packer.reference(stored.cameras).toJson()},
                        {"forward", OrderedJson::array()},
                        {"backward", OrderedJson::array()},
                        {"features", OrderedJson::array()}};
    for (std::size_t t = 0; t < shot.forward.size(); ++t) {
        json["forward"].push_back(flowJson(shot.forward[t], stored.forward[t], packer));
        json["backward"].push_back(flowJson(shot.backward[t], stored.backward[t], packer));
    }
    for (std::size_t t = 0; t < shot.features.size(); ++t)
        json["features"].push_back({{"width", shot.features[t].width},
                                    {"height", shot.features[t].height},
                                    {"cellSize", shot.features[t].cellSize},
                                    {"channels", shot.features[t].channels},
                                    {"values", packer.reference(stored.features[t]).toJson()}});
    writeLongFlows(shot, stored.longFlows, packer, json);
    writeDepths(shot, stored.depths, packer, json);
    return json;
}

FeatureGrid featuresFromJson(const JsonReader &reader, ArrayLoader &arrays)
{
    FeatureGrid grid;
    grid.width = int(reader.integer("width", 1, mostPixels));
    grid.height = int(reader.integer("height", 1, mostPixels));
    grid.cellSize = int(reader.integer("cellSize", 1, 256));
    grid.channels = int(reader.integer("channels", 1, 4096));
    if (reader.failed())
        return {};
    grid.values = arrays.load<std::uint8_t>(reader, "values", std::uint64_t(grid.channels));
    if (!reader.failed() &&
        grid.values.size() != std::size_t(grid.width) * std::size_t(grid.height) * std::size_t(grid.channels))
        reader.fail("the features have another number of cells than width times height");
    return grid;
}

std::vector<ShotCamera> camerasFromJson(const JsonReader &reader, ArrayLoader &arrays)
{
    const std::vector<double> numbers = arrays.load<double>(reader, "cameras", numbersACamera);
    std::vector<ShotCamera> cameras;
    for (std::size_t i = 0; i + numbersACamera <= numbers.size(); i += numbersACamera) {
        const double *n = numbers.data() + i;
        const Eigen::Quaterniond rotation(n[3], n[0], n[1], n[2]);
        if (!(std::abs(rotation.norm() - 1.0) < 1e-6) || !(n[7] > 0.0)) {
            reader.failAt("cameras", "camera " + std::to_string(cameras.size()) + " is no camera");
            return {};
        }
        ShotCamera camera;
        camera.worldFromCamera.linear() = rotation.normalized().toRotationMatrix();
        camera.worldFromCamera.translation() = Vec3(n[4], n[5], n[6]);
        camera.focal = n[7];
        camera.centre = Vec2(n[8], n[9]);
        cameras.push_back(camera);
    }
    return cameras;
}

Shot shotFromJson(const JsonReader &reader, ArrayLoader &arrays, const ClipReference &clip)
{
    Shot shot;
    shot.width = int(reader.integer("width", 1, mostPixels));
    shot.height = int(reader.integer("height", 1, mostPixels));
    shot.knowledge = reader.oneOf<CameraKnowledge>("knowledge", knowledgeNames);
    shot.sceneDepth = reader.number("sceneDepth", 1e-9, largest);
    shot.clipWidth = clip.width;
    shot.clipHeight = clip.height;
    if (reader.failed())
        return shot;
    shot.cameras = camerasFromJson(reader, arrays);
    for (const JsonReader &flow : reader.elements("forward", std::size_t(mostFrames)))
        if (!reader.failed())
            shot.forward.push_back(flowFromJson(flow, arrays));
    for (const JsonReader &flow : reader.elements("backward", std::size_t(mostFrames)))
        if (!reader.failed())
            shot.backward.push_back(flowFromJson(flow, arrays));
    for (const JsonReader &grid : reader.elements("features", std::size_t(mostFrames)))
        if (!reader.failed())
            shot.features.push_back(featuresFromJson(grid, arrays));
    if (!reader.failed())
        readLongFlows(reader, arrays, clip.frameCount, shot);
    if (!reader.failed())
        readDepths(reader, arrays, clip.frameCount, shot);
    const std::size_t frames = std::size_t(clip.frameCount);
    if (!reader.failed() && !isOfFrames(shot, frames))
        reader.fail("it was made of another number of frames than the clip has");
    return shot;
}

std::shared_ptr<const DocumentContent> readDoodle(const JsonReader &reader, ArrayLoader &arrays)
{
    const JsonReader clipReader = reader.member("clip");
    ClipReference clip;
    clip.path = clipReader.string("path", longestPath);
    clip.frameCount = int(clipReader.integer("frameCount", 1, mostFrames));
    clip.width = int(clipReader.integer("width", 1, mostPixels));
    clip.height = int(clipReader.integer("height", 1, mostPixels));
    clip.framesPerSecond = clipReader.number("framesPerSecond", 1e-6, 1e6);
    if (reader.failed())
        return nullptr;
    auto shot = std::make_shared<const Shot>(shotFromJson(reader.member("shot"), arrays, clip));
    if (reader.failed())
        return nullptr;
    std::shared_ptr<const DoodleScene> scene;
    if (reader.has("scene"))
        scene = std::make_shared<const DoodleScene>(
            sceneFromJson(reader.member("scene"), arrays, clip.frameCount));
    if (reader.failed())
        return nullptr;
    return std::make_shared<const DoodleContent>(
        std::move(clip), std::move(shot),
        reader.unknown({"schema", "version", "minReader", "id", "clip", "shot", "scene"}), std::move(scene));
}

} // namespace

Result<void> DoodleContent::check(const std::string &place) const
{
    const auto refused = [&](const std::string &problem) {
        return Error{ErrorCode::InvalidArgument, "Writing the project", problem, "", place};
    };
    if (!isValidUtf8(mClip.path) || mClip.path.empty() || mClip.path.size() > longestPath)
        return refused("the path of the clip is empty, too long or not UTF-8");
    const std::size_t frames = std::size_t(mClip.frameCount);
    if (mClip.frameCount < 1 || !isOfFrames(*mShot, frames))
        return refused("the scene was made of another number of frames than the clip has");
    if (const std::string problem = sceneProblem(*mScene, mClip.frameCount); !problem.empty())
        return refused(problem);
    return {};
}

OrderedJson DoodleContent::toJson(const Uuid &id, BufferPacker &packer) const
{
    const StoredShot stored = addShot(*mShot, packer);
    packer.startBuffer(); // drawing on changes buffers of its own only
    const StoredScene storedScene = addScene(*mScene, packer);
    packer.finish();
    OrderedJson json = {{"schema", doodleKindName},
                        {"version", doodleVersion},
                        {"minReader", 1},
                        {"id", id.text()},
                        {"clip",
                         {{"path", mClip.path},
                          {"frameCount", mClip.frameCount},
                          {"width", mClip.width},
                          {"height", mClip.height},
                          {"framesPerSecond", mClip.framesPerSecond}}},
                        {"shot", shotJson(*mShot, stored, packer)}};
    if (!mScene->canvases.empty())
        json["scene"] = sceneJson(*mScene, storedScene, packer);
    addUnknown(json, mUnknown);
    return json;
}

DocumentKind doodleKind()
{
    return {doodleKindName, doodleVersion, readDoodle};
}

Result<std::shared_ptr<const DoodleContent>> doodleOf(const Project &project)
{
    for (const ProjectDocument &document : project.documents) {
        if (document.kind != doodleKindName)
            continue;
        if (auto content = std::dynamic_pointer_cast<const DoodleContent>(document.content))
            return content;
        if (document.neededVersion > 0)
            return Error{ErrorCode::NewerVersion, "Opening the doodles",
                         "they need a version of Ductus that reads doodle version " +
                             std::to_string(document.neededVersion),
                         "Install a newer version of Ductus", ""};
    }
    return Error{ErrorCode::TooLittleData, "Opening the doodles", "the project holds no filmed scene",
                 "Make one with: doodlestudio analyse CLIP -o P.ductus", ""};
}

} // namespace ductus
