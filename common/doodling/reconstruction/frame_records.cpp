#include "doodling/reconstruction/frame_records.h"

#include <cmath>

namespace ductus {

namespace {

constexpr double mostCells = 16384; // a side

bool isCount(double number, double most)
{
    return number >= 0.0 && number <= most && number == std::floor(number);
}

// Width, height and cell size of a grid.
struct GridFacts
{
    int width = 0, height = 0;
    double cellSize = 1.0;

    std::size_t cells() const { return std::size_t(width) * std::size_t(height); }
};

std::optional<GridFacts> gridFrom(RecordReader &reader)
{
    const SharedArray<double> numbers = reader.array<double>(3);
    if (reader.failed() || !isCount(numbers[0], mostCells) || !isCount(numbers[1], mostCells) ||
        !(numbers[2] >= 1.0 && numbers[2] <= 256.0))
        return std::nullopt;
    return GridFacts{int(numbers[0]), int(numbers[1]), numbers[2]};
}

void add(RecordWriter &writer, const CompactFlow &flow)
{
    writer.addNumbers({double(flow.width), double(flow.height), flow.cellSize});
    writer.add<std::int16_t>(flow.motions);
    writer.add<std::uint8_t>(flow.confidences);
}

std::optional<CompactFlow> flowFrom(RecordReader &reader)
{
    const std::optional<GridFacts> grid = gridFrom(reader);
    if (!grid)
        return std::nullopt;
    CompactFlow flow;
    flow.width = grid->width;
    flow.height = grid->height;
    flow.cellSize = grid->cellSize;
    flow.motions = reader.array<std::int16_t>(2 * grid->cells());
    flow.confidences = reader.array<std::uint8_t>(grid->cells());
    return reader.failed() ? std::nullopt : std::optional(std::move(flow));
}

} // namespace

RecordWriter recordOf(const FrameMotion &motion)
{
    RecordWriter writer;
    const SmallPicture &picture = motion.picture;
    writer.addNumbers({double(motion.width), double(motion.height), double(picture.width),
                       double(picture.height), double(picture.colourWidth), double(picture.colourHeight),
                       double(motion.longFlows.size())});
    writer.add<std::uint8_t>(picture.lightness);
    writer.add<std::uint8_t>(picture.colours);
    add(writer, motion.forward);
    add(writer, motion.backward);
    for (const auto &[gap, flows] : motion.longFlows) {
        writer.addNumbers({double(gap)});
        add(writer, flows.forward);
        add(writer, flows.backward);
    }
    return writer;
}

std::optional<FrameMotion> motionFrom(RecordReader &reader)
{
    const SharedArray<double> head = reader.array<double>(7);
    if (reader.failed())
        return std::nullopt;
    for (double number : head)
        if (!isCount(number, 65536.0))
            return std::nullopt;
    FrameMotion motion;
    motion.width = int(head[0]);
    motion.height = int(head[1]);
    SmallPicture &picture = motion.picture;
    picture.width = int(head[2]);
    picture.height = int(head[3]);
    picture.colourWidth = int(head[4]);
    picture.colourHeight = int(head[5]);
    picture.lightness = reader.array<std::uint8_t>(std::size_t(picture.width) * std::size_t(picture.height));
    picture.colours =
        reader.array<std::uint8_t>(2 * std::size_t(picture.colourWidth) * std::size_t(picture.colourHeight));
    std::optional<CompactFlow> forward = flowFrom(reader), backward = flowFrom(reader);
    if (!forward || !backward)
        return std::nullopt;
    motion.forward = std::move(*forward);
    motion.backward = std::move(*backward);
    for (int i = 0; i < int(head[6]); ++i) {
        const SharedArray<double> gap = reader.array<double>(1);
        if (reader.failed() || !isCount(gap[0], 65536.0))
            return std::nullopt;
        std::optional<CompactFlow> ahead = flowFrom(reader), back = flowFrom(reader);
        if (!ahead || !back)
            return std::nullopt;
        motion.longFlows[int(gap[0])] = {std::move(*ahead), std::move(*back)};
    }
    return reader.isAtEnd() ? std::optional(std::move(motion)) : std::nullopt;
}

RecordWriter recordOf(const DepthMap &depth)
{
    RecordWriter writer;
    writer.addNumbers({double(depth.width), double(depth.height), depth.cellSize});
    writer.addNumbers({depth.mostDisparity, double(depth.objects.size())});
    writer.add<std::uint16_t>(depth.disparities);
    writer.add<std::uint8_t>(depth.objects);
    return writer;
}

std::optional<DepthMap> depthFrom(RecordReader &reader)
{
    const std::optional<GridFacts> grid = gridFrom(reader);
    const SharedArray<double> numbers = reader.array<double>(2);
    if (!grid || reader.failed() || !(numbers[0] > 0.0) || !std::isfinite(numbers[0]))
        return std::nullopt;
    DepthMap depth;
    depth.width = grid->width;
    depth.height = grid->height;
    depth.cellSize = grid->cellSize;
    depth.mostDisparity = numbers[0];
    depth.disparities = reader.array<std::uint16_t>(grid->cells());
    depth.objects = reader.array<std::uint8_t>(numbers[1] > 0.0 ? grid->cells() : 0);
    return reader.isAtEnd() ? std::optional(std::move(depth)) : std::nullopt;
}

} // namespace ductus
