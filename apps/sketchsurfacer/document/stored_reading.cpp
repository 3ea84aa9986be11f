#include "sketchsurfacer/document/stored_reading.h"

#include "geometry/point_tree.h"
#include "surfacing/pipeline/ambiguity.h"
#include "surfacing/refinement/refinement.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

int countOf(int degree) // monomialCount begins with 1
{
    return degree < 0 ? 0 : degree == 0 ? 1 : monomialCount(degree);
}

// Monomials of degree k get \a unit to the k-th: what lengths of another unit do to them.
void scaleMonomials(int degree, double unit, double *theta)
{
    for (int k = 0; k <= degree; ++k)
        for (int i = countOf(k - 1); i < countOf(k); ++i)
            theta[i] *= std::pow(unit, k);
}

ImplicitPolynomial modelFrom(const StoredReadingModel &stored, const UnitFrame &frame)
{
    ImplicitPolynomial model;
    model.degree = stored.degree;
    model.origin = frame.unitFromInput(stored.origin);
    model.theta = Eigen::Map<const Eigen::VectorXd>(stored.coefficients.data(),
                                                    Eigen::Index(stored.coefficients.size()));
    scaleMonomials(model.degree, frame.diagonal, model.theta.data());
    return model;
}

} // namespace

StoredReading storedReading(const SurfacingState &labelled)
{
    const LabelSolution *solution = labelled.labels.get();
    while (solution->before)
        solution = solution->before.get();
    const UnitFrame &frame = labelled.sketch->frame;
    StoredReading reading;
    reading.labels = solution->segmentation.labels;
    for (const Vec3 &p : labelled.proxy->proxy.mesh.vertices)
        reading.points.push_back(frame.inputFromUnit(p));
    for (const ImplicitPolynomial &model : solution->segmentation.models) {
        StoredReadingModel stored;
        stored.degree = model.degree;
        stored.origin = frame.inputFromUnit(model.origin);
        stored.coefficients.assign(model.theta.begin(), model.theta.end());
        scaleMonomials(stored.degree, 1.0 / frame.diagonal, stored.coefficients.data());
        reading.models.push_back(std::move(stored));
    }
    return reading;
}

Result<SurfacingState> withReading(const SurfacingState &prepared, const StoredReading &reading,
                                   const JobControl &control)
{
    if (reading.points.empty() || reading.labels.size() != reading.points.size())
        return Error{ErrorCode::Malformed, "Restoring the chosen reading", "its regions are not in the file",
                     "Choose Edit > Surface anew", ""};
    const UnitFrame &frame = prepared.sketch->frame;
    const TriangleMesh &proxy = prepared.proxy->proxy.mesh;
    std::vector<Vec3> points;
    for (const Vec3 &p : reading.points)
        points.push_back(frame.unitFromInput(p));
    const PointTree tree(std::move(points));
    std::vector<int> modelOf(reading.models.size(), -1); // only those that are used
    Segmentation segmentation;
    for (const Vec3 &p : proxy.vertices) {
        const auto stored = std::size_t(reading.labels[std::size_t(tree.nearest(p, 1).front())]);
        if (modelOf[stored] < 0) {
            modelOf[stored] = int(segmentation.models.size());
            segmentation.models.push_back(modelFrom(reading.models[stored], frame));
        }
        segmentation.labels.push_back(modelOf[stored]);
    }
    const SegmentationOptions &options = prepared.options.segmentation;
    const ScribbleDomain domain{
        proxy, prepared.proxy->topology, prepared.proxy->nearest, *prepared.association,
        frame, prepared.sketch->plane};
    // With its energies: other readings are compared with it.
    return withAlternative(prepared,
                           segmentationOf(wholeGraph(*prepared.association, prepared.proxy->topology),
                                          options, unscribbled(domain, segmentation, options).fit),
                           control);
}

Result<std::shared_ptr<const SurfacingState>> labelledReading(const SketchContent &content,
                                                              const JobControl &control)
{
    const ChosenReading &reading = *content.reading;
    if (reading.labelled)
        return reading.labelled;
    std::optional<TriangleMesh> proxy;
    if (content.givenProxy)
        proxy = *content.givenProxy;
    const Result<SurfacingState> prepared =
        prepareSurfacing(*reading.strokes, proxy, content.options, control.part(0.0, 0.8));
    if (!prepared)
        return prepared.error();
    Result<SurfacingState> labelled = withReading(*prepared, *reading.stored, control.part(0.8, 1.0));
    if (!labelled)
        return labelled.error();
    return std::make_shared<const SurfacingState>(std::move(*labelled));
}

} // namespace ductus
