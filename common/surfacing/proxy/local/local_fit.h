// Local VIPSS: the variational fit of variational_fit.h for thousands of points without normals, in time
// linear in their number. Natural-neighbour VIPSS [Xia, Ju 2025] fits the Delaunay neighbours of every point
// and blends by Sibson weights; here fewer and larger patches (patches.h) are fitted with their normals,
// which makes a whole piece of surface, thin sheets with both sides included, agree within itself, leaves
// signs to be found among thousands of patches and not among tens of thousands of points (patch_signs.h), and
// is blended without a tetrahedralisation (local_field.h).
#pragma once

#include "surfacing/proxy/local/local_field.h"
#include "surfacing/proxy/local/local_fit_options.h"

namespace ductus {

struct LocalFit
{
    LocalField field;
    std::vector<Vec3> normals; // unit, outwards, one a point
    double noise = 0.0;        // points are thought to lie this far off; 0 where lambda was given
    double lambda = 0.0;
    int patchCount = 0;
    int unfittedPatches = 0; // left to their neighbours and the rough field
};

/// \a points: well spread (no two much nearer than the rest), unit frame. \a rough: a field of the whole
/// shape that says where outside is.
Result<LocalFit> fitLocally(const std::vector<Vec3> &points, const HermiteField &rough,
                            const LocalFitOptions &options, const JobControl &control);

} // namespace ductus
