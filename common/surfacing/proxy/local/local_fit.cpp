#include "surfacing/proxy/local/local_fit.h"

#include "base/parallel.h"
#include "surfacing/proxy/local/patch_signs.h"
#include "surfacing/proxy/local/smoothing_choice.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr const char *attempted = "Fitting a smooth surface piece by piece";

// A member of a patch: which, and its place among the members.
struct Membership
{
    int patch, place;
};

std::vector<std::vector<Membership>> membershipsOf(const std::vector<Patch> &patches, std::size_t pointCount)
{
    std::vector<std::vector<Membership>> memberships(pointCount);
    for (std::size_t a = 0; a < patches.size(); ++a)
        for (std::size_t k = 0; k < patches[a].members.size(); ++k)
            memberships[std::size_t(patches[a].members[k])].push_back({int(a), int(k)});
    return memberships;
}

std::vector<PatchAgreement> agreementsOf(const std::vector<Patch> &patches, const std::vector<PatchFit> &fits,
                                         std::size_t pointCount)
{
    const auto memberships = membershipsOf(patches, pointCount);
    std::vector<std::vector<PatchAgreement>> ofPatch(patches.size());
    parallelFor(
        0, patches.size(),
        [&](std::size_t a) {
            std::vector<std::pair<int, double>> products; // other patch, n . n
            for (std::size_t k = 0; k < patches[a].members.size(); ++k)
                for (const Membership &other : memberships[std::size_t(patches[a].members[k])])
                    if (other.patch > int(a))
                        products.push_back(
                            {other.patch,
                             fits[a].normals[k].dot(
                                 fits[std::size_t(other.patch)].normals[std::size_t(other.place)])});
            std::stable_sort(products.begin(), products.end(),
                             [](const auto &x, const auto &y) { return x.first < y.first; });
            for (std::size_t i = 0; i < products.size();) {
                PatchAgreement edge{int(a), products[i].first, 0.0, 0.0};
                std::size_t shared = 0;
                for (; i < products.size() && products[i].first == edge.b; ++i, ++shared)
                    edge.agreement += products[i].second;
                // A single shared point may agree by chance; a few can not.
                edge.reliability = std::abs(edge.agreement) / (double(shared) + 2.0);
                ofPatch[a].push_back(edge);
            }
        },
        16);
    std::vector<PatchAgreement> all;
    for (const auto &edges : ofPatch)
        all.insert(all.end(), edges.begin(), edges.end());
    return all;
}

} // namespace

Result<LocalFit> fitLocally(const std::vector<Vec3> &points, const HermiteField &rough,
                            const LocalFitOptions &options, const JobControl &control)
{
    control.progress(0.0, attempted);
    const PointTree tree(points);
    std::vector<Patch> patches = coverWithPatches(tree, options.patches);
    LocalFit fit;
    Result<Smoothing> smoothing =
        options.lambda ? Smoothing{*options.lambda, 0.0} : chooseSmoothing(patches, points, control);
    if (!smoothing)
        return smoothing.error();
    fit.noise = smoothing->noise;
    fit.lambda = smoothing->lambda;

    std::vector<Vec3> roughNormals(points.size());
    parallelFor(
        0, points.size(),
        [&](std::size_t i) {
            rough.valueAndGradient(points[i], roughNormals[i]);
            roughNormals[i] = roughNormals[i].stableNormalized();
        },
        64);

    std::vector<std::optional<PatchFit>> tried(patches.size());
    parallelFor(0, patches.size(), [&](std::size_t a) {
        std::vector<Vec3> prior;
        for (int i : patches[a].members)
            prior.push_back(roughNormals[std::size_t(i)]);
        if (Result<PatchFit> fitted = fitPatch(patches[a], points, fit.lambda, prior, control))
            tried[a] = std::move(*fitted);
        if (a % 64 == 0)
            control.progress(0.1 + 0.8 * double(a) / double(patches.size()), attempted);
    });
    if (control.isCancelled())
        return cancelledError(attempted);
    std::vector<PatchFit> fits;
    std::vector<Patch> fitted;
    for (std::size_t a = 0; a < patches.size(); ++a)
        if (tried[a]) {
            fits.push_back(std::move(*tried[a]));
            fitted.push_back(std::move(patches[a]));
        }
    fit.patchCount = int(patches.size());
    fit.unfittedPatches = int(patches.size() - fitted.size());
    if (fitted.empty())
        return Error{ErrorCode::NoSolution, attempted, "no piece could be fitted", "Give a proxy mesh", ""};

    constexpr double roughShare = 0.2; // what the rough field counts beside the patches' agreement
    std::vector<double> roughAgreement(fitted.size(), 0.0);
    for (std::size_t a = 0; a < fitted.size(); ++a)
        for (std::size_t k = 0; k < fitted[a].members.size(); ++k)
            roughAgreement[a] +=
                roughShare * fits[a].normals[k].dot(roughNormals[std::size_t(fitted[a].members[k])]);
    const std::vector<int> signs = consistentSigns(agreementsOf(fitted, fits, points.size()), roughAgreement);

    std::vector<HermiteField> fields;
    for (std::size_t a = 0; a < fitted.size(); ++a)
        fields.push_back(signs[a] < 0 ? fits[a].field.negated() : std::move(fits[a].field));
    fit.field = LocalField(fitted, std::move(fields), rough);
    fit.normals.resize(points.size());
    parallelFor(
        0, points.size(), [&](std::size_t i) { fit.normals[i] = fit.field.normal(points[i]); }, 64);
    return fit;
}

} // namespace ductus
