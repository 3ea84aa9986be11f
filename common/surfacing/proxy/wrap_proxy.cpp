#include "surfacing/proxy/wrap_proxy.h"

#include "geometry/alpha_wrap.h"

#include <algorithm>
#include <cmath>

namespace ductus {

Result<Wrap> wrapStrokes(const std::vector<Vec3> &points, const WrapOptions &options, const JobControl &control)
{
    Wrap best;
    double bestVolume = 0.0;
    const std::size_t count = options.alphas.size();
    const bool isChosen = options.tightness >= 0.0;
    const std::size_t only = std::size_t(std::lround(std::clamp(options.tightness, 0.0, 1.0) * double(count - 1)));
    for (std::size_t i = isChosen ? only : 0; i < count; ++i) {
        if (control.isCancelled())
            return cancelledError("Wrapping the strokes");
        control.progress(double(i) / double(count), "Wrapping the strokes");
        Result<TriangleMesh> mesh = alphaWrap(points, {options.alphas[i], options.offset});
        if (!mesh) {
            if (best.mesh.isEmpty())
                return mesh.error();
            break;
        }
        const double volume = signedVolume(*mesh);
        if (!best.mesh.isEmpty() && volume < options.keptVolume * bestVolume)
            break;
        best = {std::move(*mesh), options.alphas[i]};
        bestVolume = volume;
        if (isChosen)
            break;
    }
    return best;
}

} // namespace ductus
