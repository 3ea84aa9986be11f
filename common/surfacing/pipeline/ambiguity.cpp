#include "surfacing/pipeline/ambiguity.h"

#include "surfacing/extraction/half_mesh.h"
#include "surfacing/refinement/refinement.h"

namespace ductus {

Result<Ambiguity> findAmbiguity(const SurfacingState &state, const AmbiguityOptions &options,
                                const JobControl &control)
{
    const TriangleMesh &proxy = state.proxy->proxy.mesh;
    const MeshTopology &topology = state.proxy->topology;
    const Result<std::vector<LabelSample>> samples =
        labelSamples(*state.association, topology, state.options.segmentation, options.samples, control);
    if (!samples)
        return samples.error();
    Ambiguity result;
    result.map = ambiguityOf(proxy, topology, *samples, options.map);
    result.shown = result.map.either;
    if (const std::optional<SymmetryPlane> &plane = state.sketch->plane) {
        const MirroredMesh whole = withMirrorImage(proxy, *plane, verticesInPlane(proxy, *plane));
        result.shown.resize(whole.mesh.vertices.size());
        for (std::size_t v = 0; v < whole.imageOfVertex.size(); ++v)
            result.shown[std::size_t(whole.imageOfVertex[v])] = result.map.either[v];
    }
    for (int i : alternatives(proxy, topology, state.labels->segmentation, *samples, options.alternatives))
        result.alternatives.push_back((*samples)[std::size_t(i)].segmentation);
    return result;
}

Result<SurfacingState> withAlternative(const SurfacingState &state, const Segmentation &alternative,
                                       const JobControl &control)
{
    const ScribbleDomain domain{state.proxy->proxy.mesh, state.proxy->topology, state.proxy->nearest,
                                *state.association,      state.sketch->frame,   state.sketch->plane};
    SurfacingState chosen = state;
    chosen.labels =
        std::make_shared<const LabelSolution>(unscribbled(domain, alternative, state.options.segmentation));
    return solveLabels(chosen, {}, state.options, control);
}

} // namespace ductus
