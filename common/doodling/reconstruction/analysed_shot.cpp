#include "doodling/reconstruction/analysed_shot.h"

#include "doodling/clip/clip_digest.h"

namespace ductus {

Result<AnalysedShot> analysedShot(const std::filesystem::path &clip, AnalysisCache cache, const Shot *known,
                                  const JobControl &control)
{
    Result<std::unique_ptr<Clip>> opened = openClip(clip, control.part(0.0, 0.02));
    if (!opened)
        return opened.error();
    return analysedShot(**opened, clip, std::move(cache), known, control.part(0.02, 1.0));
}

Result<AnalysedShot> analysedShot(Clip &clip, const std::filesystem::path &path, AnalysisCache cache,
                                  const Shot *known, const JobControl &control,
                                  std::vector<ShotCamera> cameras)
{
    AnalysedShot analysed;
    ShotOptions options;
    options.givenCameras = std::move(cameras);
    options.known = known;
    options.report = &analysed.report;
    if (cache.isOn()) {
        Result<std::string> digest = clipDigest(path, control.part(0.0, 0.01));
        if (!digest)
            return digest.error();
        analysed.digest = std::move(*digest);
        options.clipDigest = analysed.digest;
        options.cache = std::move(cache);
    }
    Result<Shot> shot = reconstructShot(clip, options, control.part(0.01, 1.0));
    if (!shot && shot.error().code == ErrorCode::WriteFailed) {
        analysed.cacheProblem = shot.error();
        options.cache = {};
        analysed.report = {};
        shot = reconstructShot(clip, options, control.part(0.01, 1.0));
    }
    if (!shot)
        return shot.error();
    analysed.shot = std::make_shared<const Shot>(std::move(*shot));
    return analysed;
}

} // namespace ductus
