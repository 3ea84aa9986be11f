// What a sweep's results look like, side by side on one sheet: regions in colour with the strokes on top, the
// case below in words.
#pragma once

#include "benchmarks/surfacing/benchmark_context.h"
#include "imaging/image.h"
#include "strokes/stroke.h"

namespace ductus {

class ContactSheet
{
public:
    /// context.pictures/NAME.png; where no pictures are asked for nothing is drawn.
    ContactSheet(const BenchmarkContext &context, const std::string &name)
        : mFile(context.pictures.empty() ? std::filesystem::path() : context.pictures / (name + ".png"))
    {
    }

    void add(const std::string &caption, const TriangleMesh &mesh, const std::vector<int> &triangleRegions,
             const StrokeSet &strokes);
    void addFailure(const std::string &caption);
    /// Number of failures, which are told on stderr.
    int write() const;

private:
    struct Cell
    {
        std::string caption;
        Image picture;
    };

    std::filesystem::path mFile;
    std::vector<Cell> mCells;
};

} // namespace ductus
