// From strokes to a smooth field of the whole shape, and from a field to its surface near the strokes.
#pragma once

#include "surfacing/proxy/contour.h"
#include "surfacing/proxy/hermite_field.h"
#include "surfacing/proxy/proxy.h"

namespace ductus {

/// The variational fit to a well-spread subset of \a strokePoints. For solids, points of the wrap far from
/// all strokes say where about the surface is there.
Result<HermiteField> wholeShapeField(const std::vector<Vec3> &strokePoints, const Wrap &wrap, bool isOpen,
                                     double lambda, const ProxyOptions &options, const JobControl &control);

struct FieldSurface
{
    TriangleMesh mesh;
    double cappedShare = 0.0; // of the closed contour's area that is where the neighbourhood ends, not where
                              // the field is zero: about half for an open sheet, none for a sound solid
};

/// The zero set of \a field near \a seeds, in the neighbourhood of the wrap: closed for a solid, ending with
/// the neighbourhood for an open sheet. \a cell: of the contouring grid.
Result<FieldSurface> surfaceOfField(const ScalarField &field, const std::vector<Vec3> &seeds,
                                    const Wrap &wrap, bool isOpen, double cell, const ProxyOptions &options,
                                    const JobControl &control);

} // namespace ductus
