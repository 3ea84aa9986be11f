// Blobs of Quill.qbin: drawings and pictures. quill-and-tilt.md section 1.
#pragma once

#include "formats/archive/byte_source.h"
#include "formats/painting_file.h"

namespace ductus {

/// What reading drawings put right or must respect, over all drawings of a file.
struct QuillDrawingTally
{
    std::int64_t maxPoints = 0;
    std::int64_t points = 0;
    std::int64_t clampedValues = 0;  // colours and opacities outside 0..1, negative widths
    std::int64_t unknownBrushes = 0; // read as round
};

struct QuillDrawingRead
{
    PaintingFileDrawing drawing;
    std::uint64_t end = 0; // the first byte behind it
};

/// Malformed with the byte for what reaches beyond the file and for numbers that are not finite; TooLarge
/// beyond maxPoints. No memory is taken before the bytes are known to be there.
Result<QuillDrawingRead> readQuillDrawing(ByteSource &qbin, std::uint64_t offset, QuillDrawingTally &tally,
                                          const JobControl &control);

/// Unsupported for pictures larger than \a maxPixels or of a layout that is not known.
Result<Image> readQuillPicture(ByteSource &qbin, std::uint64_t offset, std::int64_t maxPixels);

} // namespace ductus
