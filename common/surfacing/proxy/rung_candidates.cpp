#include "surfacing/proxy/rung_candidates.h"

#include <algorithm>

namespace ductus {

namespace {

// Looser wraps than \a wrap, evenly spread over the family, its neighbour first.
std::vector<double> looserAlphas(const Wrap &wrap, const ProxyOptions &options)
{
    std::vector<double> looser;
    for (const double alpha : options.wrap.alphas)
        if (alpha > wrap.alpha)
            looser.push_back(alpha);
    std::sort(looser.begin(), looser.end());
    const std::size_t step = (looser.size() + std::size_t(options.disorder.looserWraps) - 1) /
                             std::size_t(options.disorder.looserWraps);
    std::vector<double> some;
    for (std::size_t i = step; step > 0 && i <= looser.size(); i += step)
        some.push_back(looser[i - 1]);
    return some;
}

bool isBetter(const RungCandidate &candidate, const RungCandidate &than)
{
    return candidate.rung && (!than.rung || candidate.rung->disorder < than.rung->disorder);
}

// A wrap that has fallen in between strokes far apart puts points of a surface inside the shape, and the
// field turns inside out there: a solid's contour then runs out of the neighbourhood. A looser wrap holds it
// where nothing is drawn.
RungCandidate calmestSolid(RungCandidate best, ProxyKind kind, const StrokeSet &strokes,
                           const std::vector<Vec3> &drawn, const ProxyOptions &options,
                           const JobControl &control)
{
    if (options.wrap.tightness >= 0.0 || options.disorder.looserWraps < 1)
        return best;
    const Wrap first = best.ground.wrap;
    for (const double alpha : looserAlphas(first, options)) {
        const bool isFarLooser = alpha > options.disorder.loosest * first.alpha;
        const double enough = isFarLooser ? options.disorder.hopeless : options.disorder.most;
        if (control.isCancelled() || (best.rung && best.rung->disorder <= enough))
            break;
        WrapOptions looser = options.wrap;
        looser.alphas = {alpha};
        looser.tightness = 0.0;
        Result<Wrap> wrap = wrapStrokes(drawn, looser, JobControl());
        if (!wrap)
            continue;
        ProxyGround held = groundOn(std::move(*wrap), strokes, drawn, false, options);
        Result<ProxyRung> rung = makeRung(kind, held, best.lambda, options, control);
        RungCandidate candidate{std::move(held), best.lambda, std::move(rung)};
        if (isBetter(candidate, best))
            best = std::move(candidate);
    }
    return best;
}

// Strokes that were meant to be one curve but miss each other become two walls, with tunnels between them.
// More smoothing takes them for one; the finished proxy is drawn back to the strokes.
RungCandidate withoutTunnels(RungCandidate best, ProxyKind kind, const std::vector<ProxyGround> &grounds,
                             const ProxyOptions &options, const JobControl &control)
{
    const double first = best.lambda;
    for (const double smoothing : options.disorder.smoothings)
        for (const ProxyGround &ground : grounds) {
            if (control.isCancelled() || !best.rung || best.rung->tunnels == 0)
                return best;
            const double lambda = smoothing * first;
            RungCandidate candidate{ground, lambda, makeRung(kind, ground, lambda, options, control)};
            if (isBetter(candidate, best))
                best = std::move(candidate);
        }
    return best;
}

} // namespace

RungCandidate calmest(ProxyKind kind, const ProxyGround &ground, const StrokeSet &strokes,
                      const std::vector<Vec3> &drawn, double lambda, const ProxyOptions &options,
                      const JobControl &control)
{
    RungCandidate best{ground, lambda, makeRung(kind, ground, lambda, options, control)};
    std::vector<ProxyGround> grounds{ground};
    if (!ground.isOpen) {
        best = calmestSolid(std::move(best), kind, strokes, drawn, options, control);
        if (best.ground.wrap.alpha != ground.wrap.alpha)
            grounds.insert(grounds.begin(), best.ground);
    }
    return withoutTunnels(std::move(best), kind, grounds, options, control);
}

} // namespace ductus
