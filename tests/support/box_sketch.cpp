#include "support/box_sketch.h"

#include "strokes/resample.h"

#include <cmath>

namespace ductus {

Stroke straightStroke(const Vec3 &a, const Vec3 &b, double step)
{
    Stroke stroke;
    stroke.points = resampled(std::vector<Vec3>{a, b}, step);
    return stroke;
}

StrokeSet boxSketch(const BoxSketchOptions &options)
{
    StrokeSet set;
    for (int axis = 0; axis < 3; ++axis)
        for (double t : {-1.0, -options.lineShare, options.lineShare, 1.0})
            for (double side : {-1.0, 1.0})
                for (int other : {1, 2}) {
                    if (std::abs(t) == 1.0 && other == 2)
                        continue; // an edge belongs to two faces
                    Vec3 a, b;
                    a[axis] = -1.0;
                    b[axis] = 1.0;
                    a[(axis + other) % 3] = b[(axis + other) % 3] = side;
                    a[(axis + 3 - other) % 3] = b[(axis + 3 - other) % 3] = t;
                    if (options.isLeftOut && options.isLeftOut(a, b))
                        continue;
                    Stroke stroke = straightStroke(a.cwiseProduct(options.halfBox),
                                                   b.cwiseProduct(options.halfBox), options.step);
                    stroke.id.value = int(set.strokes.size());
                    set.strokes.push_back(std::move(stroke));
                }
    return set;
}

} // namespace ductus
