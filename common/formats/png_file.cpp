#include "formats/png_file.h"

#include "formats/atomic_file.h"

#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <new>
#include <png.h>
#include <string>

namespace ductus {

namespace {

constexpr png_uint_32 largestSide = 32768;
constexpr std::uint64_t mostPixels = std::uint64_t(1) << 27;
constexpr std::size_t largestPngFile = std::size_t(1) << 30;

/// Everything a libpng callback or an error jump touches. libpng leaves by longjmp, which runs no
/// destructors: so the functions that call setjmp own nothing but what stands here, and this lives in their
/// callers.
struct PngJob
{
    std::span<const std::byte> input;
    std::size_t read = 0;
    std::vector<std::byte> output;
    bool outOfMemory = false;
    char problem[200] = "";
};

[[noreturn]] void onError(png_structp png, png_const_charp message)
{
    PngJob &job = *static_cast<PngJob *>(png_get_error_ptr(png));
    std::snprintf(job.problem, sizeof job.problem, "%s", message);
    png_longjmp(png, 1);
}

/// Warnings are about ancillary chunks (colour profiles, text), which are not used here.
void onWarning(png_structp, png_const_charp) {}

void readBytes(png_structp png, png_bytep target, png_size_t count)
{
    PngJob &job = *static_cast<PngJob *>(png_get_io_ptr(png));
    if (job.input.size() - job.read < count)
        png_error(png, "the file ends in the middle of the picture");
    std::memcpy(target, job.input.data() + job.read, count);
    job.read += count;
}

void writeBytes(png_structp png, png_bytep source, png_size_t count)
{
    PngJob &job = *static_cast<PngJob *>(png_get_io_ptr(png));
    const auto *bytes = reinterpret_cast<const std::byte *>(source);
    try {
        job.output.insert(job.output.end(), bytes, bytes + count);
    } catch (const std::bad_alloc &) {
        job.outOfMemory = true;
    }
    // Outside of the handler: a jump out of a catch block would never free the exception.
    if (job.outOfMemory)
        png_error(png, "out of memory");
}

void flushBytes(png_structp) {}

/// False with job.problem set on failure.
bool encode(png_structp png, png_infop info, PngJob &job, const Image &image)
{
    if (setjmp(png_jmpbuf(png)))
        return false;
    png_set_write_fn(png, &job, writeBytes, flushBytes);
    png_set_IHDR(png, info, png_uint_32(image.width), png_uint_32(image.height), 8, PNG_COLOR_TYPE_RGBA,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    for (int y = 0; y < image.height; ++y)
        png_write_row(png, image.pixels.data() + std::size_t(y) * std::size_t(image.width) * 4);
    png_write_end(png, info);
    return true;
}

/// Reads the header and sets up the conversion of every kind of PNG to 8-bit RGBA.
bool decodeHeader(png_structp png, png_infop info, PngJob &job)
{
    if (setjmp(png_jmpbuf(png)))
        return false;
    png_set_read_fn(png, &job, readBytes);
    png_set_user_limits(png, largestSide, largestSide);
    png_set_chunk_malloc_max(png, png_alloc_size_t(8) << 20);
    png_set_chunk_cache_max(png, 128);
    png_read_info(png, info);
    png_set_expand(png);
    png_set_scale_16(png);
    png_set_gray_to_rgb(png);
    png_set_add_alpha(png, 255, PNG_FILLER_AFTER);
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
    return true;
}

bool decodeRows(png_structp png, png_infop info, png_bytepp rows)
{
    if (setjmp(png_jmpbuf(png)))
        return false;
    png_read_image(png, rows);
    png_read_end(png, info);
    return true;
}

/// A libpng structure with its info, freed on every way out.
class PngStruct
{
public:
    enum Direction { Read, Write };
    PngStruct(Direction direction, PngJob &job) : mDirection(direction)
    {
        png = direction == Read ? png_create_read_struct(PNG_LIBPNG_VER_STRING, &job, onError, onWarning)
                                : png_create_write_struct(PNG_LIBPNG_VER_STRING, &job, onError, onWarning);
        info = png ? png_create_info_struct(png) : nullptr;
    }
    ~PngStruct()
    {
        if (mDirection == Read)
            png_destroy_read_struct(&png, &info, nullptr);
        else
            png_destroy_write_struct(&png, &info);
    }
    PngStruct(const PngStruct &) = delete;
    PngStruct &operator=(const PngStruct &) = delete;
    bool ok() const { return png && info; }

    png_structp png = nullptr;
    png_infop info = nullptr;

private:
    Direction mDirection;
};

const char *const reading = "Reading the picture";
const char *const writing = "Writing the picture";
const char *const exportAgain = "Save the picture again as PNG";

Error outOfMemory(const char *attempted)
{
    return {ErrorCode::TooLarge, attempted, "the memory does not suffice", "Use a smaller picture", ""};
}

Result<Image> decodeChecked(std::span<const std::byte> bytes)
{
    if (bytes.size() < 8 || png_sig_cmp(reinterpret_cast<png_const_bytep>(bytes.data()), 0, 8) != 0)
        return Error{ErrorCode::Malformed, reading,
                     bytes.empty() ? "the file is empty" : "this is no PNG picture", exportAgain, ""};
    PngJob job;
    job.input = bytes;
    PngStruct structure(PngStruct::Read, job);
    if (!structure.ok())
        return outOfMemory(reading);
    if (!decodeHeader(structure.png, structure.info, job))
        return Error{ErrorCode::Malformed, reading, job.problem, exportAgain, ""};
    const png_uint_32 width = png_get_image_width(structure.png, structure.info);
    const png_uint_32 height = png_get_image_height(structure.png, structure.info);
    const std::string size = std::to_string(width) + " x " + std::to_string(height);
    if (std::uint64_t(width) * height > mostPixels)
        return Error{ErrorCode::TooLarge, reading, "the picture is " + size + " pixels large",
                     "Use a picture of at most 134 million pixels", ""};
    // Deflate packs at most 1032 to 1, and a row of one-bit pixels takes an eighth of a byte a pixel: a file
    // too short for its own header is refused before its pixels are allocated.
    if (std::uint64_t(width) * height / 8 > std::uint64_t(bytes.size()) * 1032)
        return Error{ErrorCode::Malformed, reading,
                     "the file is too short for a picture of " + size + " pixels", exportAgain, ""};
    if (png_get_rowbytes(structure.png, structure.info) != std::size_t(width) * 4)
        return Error{ErrorCode::Unsupported, reading, "the pixels have an unknown layout", exportAgain, ""};
    Image image{int(width), int(height)};
    std::vector<png_bytep> rows(height);
    for (png_uint_32 y = 0; y < height; ++y)
        rows[y] = image.pixels.data() + std::size_t(y) * width * 4;
    if (!decodeRows(structure.png, structure.info, rows.data()))
        return Error{ErrorCode::Malformed, reading, job.problem, exportAgain, ""};
    return image;
}

Result<std::vector<std::byte>> encodeChecked(const Image &image)
{
    if (image.width <= 0 || image.height <= 0 || image.width > int(largestSide) ||
        image.height > int(largestSide))
        return Error{ErrorCode::InvalidArgument, writing,
                     "a picture of " + std::to_string(image.width) + " x " + std::to_string(image.height) +
                         " pixels cannot be written",
                     "Choose a size from 1 to 32768 pixels a side", ""};
    if (image.pixels.size() != std::size_t(image.width) * std::size_t(image.height) * 4)
        return Error{ErrorCode::InvalidArgument, writing, "the pixels do not match the size of the picture",
                     "", ""};
    PngJob job;
    PngStruct structure(PngStruct::Write, job);
    if (!structure.ok())
        return outOfMemory(writing);
    if (!encode(structure.png, structure.info, job, image))
        return job.outOfMemory ? outOfMemory(writing)
                               : Error{ErrorCode::WriteFailed, writing, job.problem, "", ""};
    return std::move(job.output);
}

} // namespace

Result<std::vector<std::byte>> encodePng(const Image &image)
{
    return encodeChecked(image);
}

Result<Image> decodePng(std::span<const std::byte> bytes)
{
    try {
        return decodeChecked(bytes);
    } catch (const std::bad_alloc &) {
        return outOfMemory(reading);
    }
}

Result<void> writePng(const Image &image, const std::filesystem::path &path)
{
    const Result<std::vector<std::byte>> bytes = encodePng(image);
    if (!bytes) {
        Error error = bytes.error();
        error.place = path.string();
        return error;
    }
    return writeFileAtomically(path, *bytes, writing);
}

Result<Image> readPng(const std::filesystem::path &path)
{
    const Result<std::string> bytes = readWholeFile(path, largestPngFile, reading);
    if (!bytes)
        return bytes.error();
    Result<Image> image = decodePng(std::as_bytes(std::span(*bytes)));
    if (image)
        return image;
    Error error = image.error();
    error.place = path.filename().string();
    return error;
}

} // namespace ductus
