#include "doodling/storage/doodle_content.h"

#include "doodling/scene/camera_numbers.h"
#include "doodling/storage/canvas_storage.h"
#include "doodling/storage/depth_storage.h"
#include "doodling/storage/flow_storage.h"
#include "doodling/storage/long_flow_storage.h"
#include "project/container/entry_name.h"

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

// Either all that is known of a frame is there, or nothing but cameras: the clip was not analysed yet, or
// what was found is in the cache.
bool isOfFrames(const Shot &shot, std::size_t frames)
{
    if (shot.cameras.size() != frames)
        return false;
    if (shot.forward.empty() && shot.backward.empty())
        return true;
    return shot.forward.size() + 1 == frames && shot.backward.size() + 1 == frames;
}

bool leavesOut(const Shot &shot, bool packsAnalysis)
{
    return shot.isLeftInCache || (shot.isCached() && !packsAnalysis);
}

struct StoredShot
{
    std::vector<StoredFlow> forward, backward;
    BufferPacker::Handle cameras = 0;
    StoredLongFlows longFlows;
    StoredDepths depths;
};

StoredShot addShot(const Shot &shot, bool packsAnalysis, BufferPacker &packer)
{
    StoredShot stored;
    std::vector<double> cameras;
    for (const ShotCamera &camera : shot.cameras)
        for (double number : numbersOf(camera))
            cameras.push_back(number);
    stored.cameras = packer.add<double>(cameras, {shot.cameras.size(), numbersACamera});
    if (shot.isDepthGiven || !leavesOut(shot, packsAnalysis))
        stored.depths = addDepths(shot, packer);
    if (leavesOut(shot, packsAnalysis))
        return stored;
    for (const CompactFlow &flow : shot.forward)
        stored.forward.push_back(addFlow(flow, packer));
    for (const CompactFlow &flow : shot.backward)
        stored.backward.push_back(addFlow(flow, packer));
    stored.longFlows = addLongFlows(shot, packer);
    return stored;
}

OrderedJson shotJson(const Shot &shot, bool packsAnalysis, const StoredShot &stored,
                     const BufferPacker &packer)
{
    OrderedJson json = {{"width", shot.width},
                        {"height", shot.height},
                        {"knowledge", nameOf(shot.knowledge)},
                        {"sceneDepth", shot.sceneDepth},
                        {"cameras", packer.reference(stored.cameras).toJson()},
                        {"forward", OrderedJson::array()},
                        {"backward", OrderedJson::array()},
                        {"features", OrderedJson::array()}}; // of version 1; nothing is read from them
    if (shot.nearestDisparity > 0.0)
        json["nearestDisparity"] = shot.nearestDisparity;
    if (shot.isDepthGiven)
        json["depthSource"] = "given";
    if (shot.isDepthGiven || !leavesOut(shot, packsAnalysis))
        writeDepths(shot, stored.depths, packer, json);
    if (leavesOut(shot, packsAnalysis)) {
        json["analysis"] = "cache";
        return json;
    }
    for (std::size_t t = 0; t < shot.forward.size(); ++t) {
        json["forward"].push_back(flowJson(shot.forward[t], stored.forward[t], packer));
        json["backward"].push_back(flowJson(shot.backward[t], stored.backward[t], packer));
    }
    writeLongFlows(shot, stored.longFlows, packer, json);
    return json;
}

std::vector<ShotCamera> camerasFromJson(const JsonReader &reader, ArrayLoader &arrays)
{
    const std::vector<double> numbers = arrays.load<double>(reader, "cameras", numbersACamera);
    std::vector<ShotCamera> cameras;
    for (std::size_t i = 0; i + numbersACamera <= numbers.size(); i += numbersACamera) {
        const std::optional<ShotCamera> camera =
            cameraOf(std::span<const double, numbersACamera>(numbers.data() + i, numbersACamera));
        if (!camera) {
            reader.failAt("cameras", "camera " + std::to_string(cameras.size()) + " is no camera");
            return {};
        }
        cameras.push_back(*camera);
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
    if (reader.has("nearestDisparity"))
        shot.nearestDisparity = reader.number("nearestDisparity", 1.0 / largest, largest);
    shot.isLeftInCache = reader.has("analysis");
    shot.isDepthGiven = reader.has("depthSource");
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
    if (!reader.failed())
        readLongFlows(reader, arrays, clip.frameCount, shot);
    if (!reader.failed())
        readDepths(reader, arrays, clip.frameCount, shot);
    // Motion that is here is as good as motion that is elsewhere.
    shot.isLeftInCache = shot.isLeftInCache && shot.forward.empty();
    const std::size_t frames = std::size_t(clip.frameCount);
    if (!reader.failed() && !isOfFrames(shot, frames))
        reader.fail("it was made of another number of frames than the clip has");
    return shot;
}

OrderedJson clipJson(const ClipReference &clip)
{
    OrderedJson json = {{"path", clip.path},
                        {"frameCount", clip.frameCount},
                        {"width", clip.width},
                        {"height", clip.height},
                        {"framesPerSecond", clip.framesPerSecond}};
    if (!clip.digest.empty())
        json["sha256"] = clip.digest;
    return json;
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
    if (clipReader.has("sha256"))
        clip.digest = clipReader.string("sha256", 64);
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
    const bool isPacked = !shot->forward.empty();
    return std::make_shared<const DoodleContent>(
        std::move(clip), std::move(shot),
        reader.unknown({"schema", "version", "minReader", "id", "clip", "shot", "scene"}), std::move(scene),
        isPacked);
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

std::vector<const UnknownMembers *> DoodleContent::unknownMembers() const
{
    std::vector<const UnknownMembers *> all = {&mUnknown};
    for (const Canvas &canvas : mScene->canvases)
        if (canvas.prop)
            for (const UnknownMembers *members : canvas.prop->painting->unknownMembers())
                all.push_back(members);
    return all;
}

OrderedJson DoodleContent::toJson(const Uuid &id, BufferPacker &packer) const
{
    const StoredShot stored = addShot(*mShot, mPacksAnalysis, packer);
    packer.startBuffer(); // drawing on changes buffers of its own only
    const StoredScene storedScene = addScene(*mScene, packer);
    packer.finish();
    OrderedJson json = {
        {"schema", doodleKindName}, {"version", doodleVersion},
        {"minReader", 1},           {"id", id.text()},
        {"clip", clipJson(mClip)},  {"shot", shotJson(*mShot, mPacksAnalysis, stored, packer)}};
    if (!mScene->canvases.empty())
        json["scene"] = sceneJson(*mScene, storedScene, packer);
    addUnknown(json, mUnknown);
    return json;
}

std::uint64_t packedAnalysisBytes(const Shot &shot)
{
    std::uint64_t bytes = 0;
    const auto add = [&](const CompactFlow &flow) { bytes += 5 * flow.cellCount(); };
    for (std::size_t t = 0; t < shot.forward.size(); ++t) {
        add(shot.forward[t]);
        add(shot.backward[t]);
    }
    for (const auto &[span, flows] : shot.longFlows) {
        add(flows.forward);
        add(flows.backward);
    }
    for (const SmallPicture &picture : shot.pictures)
        bytes += picture.lightness.size() + picture.colours.size();
    for (const DepthMap &depth : shot.depths)
        bytes += 2 * depth.disparities.size() + depth.objects.size();
    return bytes;
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
