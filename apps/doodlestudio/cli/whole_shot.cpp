#include "doodlestudio/cli/whole_shot.h"

#include <cstdio>

namespace ductus {

std::shared_ptr<const Shot> availableShot(const OpenedDoodle &doodle, const JobControl &control)
{
    const std::shared_ptr<const Shot> &known = doodle.content->shot();
    if (!known->isLeftInCache)
        return known;
    ShotOptions options;
    options.cache = userAnalysisCache();
    options.clipDigest = doodle.content->clip().digest;
    options.known = known.get();
    std::optional<Shot> cached = shotFromCache(options, control);
    return cached ? std::make_shared<const Shot>(std::move(*cached)) : known;
}

Result<std::shared_ptr<const Shot>> wholeShot(const OpenedDoodle &doodle, const std::filesystem::path &clip,
                                              const JobControl &control)
{
    std::shared_ptr<const Shot> known = availableShot(doodle, control.part(0.0, 0.1));
    if (!known->isLeftInCache)
        return known;
    std::fputs(
        "\ndoodlestudio: What was found out about the clip is not complete in the cache; what is missing "
        "is found again.\n",
        stderr);
    Result<std::unique_ptr<Clip>> opened = openItsClip(doodle, clip, control.part(0.1, 0.12));
    if (!opened)
        return opened.error();
    const Result<AnalysedShot> analysed =
        analysedShot(**opened, clip.empty() ? doodle.clip : clip, userAnalysisCache(), known.get(),
                     control.part(0.12, 1.0));
    if (!analysed)
        return analysed.error();
    tellOf(*analysed);
    return analysed->shot;
}

void tellOf(const AnalysedShot &analysed)
{
    if (analysed.report.damaged > 0)
        std::fprintf(stderr, "\ndoodlestudio: %d damaged pieces of the cache were made again.\n",
                     analysed.report.damaged);
    if (analysed.cacheProblem)
        std::fprintf(stderr, "\ndoodlestudio: The cache cannot be used, so nothing is kept there: %s\n",
                     analysed.cacheProblem->message().c_str());
}

} // namespace ductus
