#include "formats/painting_file.h"

#include "formats/archive/zip_archive.h"
#include "formats/paintings/painting_readers.h"

#include <new>

namespace ductus {

namespace {

constexpr char attempted[] = "Reading the painting";
namespace fs = std::filesystem;

Error notAPainting(const std::string &name)
{
    return {ErrorCode::Unsupported, attempted, "this is neither a Quill project nor a .tilt sketch",
            "Choose the folder of a Quill project, its Quill.json, a .quill or a .tilt file", name};
}

Result<PaintingFile> readQuillArchive(const ZipArchive &archive, const PaintingReadOptions &options,
                                      const JobControl &control)
{
    Result<std::unique_ptr<ByteSource>> json = archive.entry("Quill.json");
    if (!json)
        return json.error();
    Result<std::unique_ptr<ByteSource>> qbin = archive.entry("Quill.qbin");
    if (!qbin && qbin.error().code != ErrorCode::FileNotFound)
        return qbin.error();
    return readQuill(**json, qbin ? qbin->get() : nullptr, options, control);
}

Result<PaintingFile> readQuillFolder(const fs::path &folder, const PaintingReadOptions &options,
                                     const JobControl &control)
{
    const std::string name = (folder.has_filename() ? folder : folder.parent_path()).filename().string();
    const auto nameOf = [&](const char *file) { return name.empty() ? file : name + "/" + file; };
    Result<std::unique_ptr<ByteSource>> json = openFileSource(folder / "Quill.json", nameOf("Quill.json"));
    if (!json)
        return json.error();
    Result<std::unique_ptr<ByteSource>> qbin = openFileSource(folder / "Quill.qbin", nameOf("Quill.qbin"));
    if (!qbin && qbin.error().code != ErrorCode::FileNotFound)
        return qbin.error();
    return readQuill(**json, qbin ? qbin->get() : nullptr, options, control);
}

/// The bytes before the zip in a .tilt file: "tilT", u16 size of this header, u16 version, 8 more.
Result<std::uint64_t> tiltPrefix(ByteSource &file)
{
    std::array<std::uint16_t, 4> header{};
    if (const auto done = file.read(0, std::as_writable_bytes(std::span(header))); !done)
        return done.error();
    if (header[2] < 16 || header[2] > file.size() || header[3] != 1)
        return Error{ErrorCode::Unsupported, attempted, "its header is of a kind that is not known",
                     "Save the sketch with a current Open Brush", file.name()};
    return std::uint64_t(header[2]);
}

Result<PaintingFile> readTiltArchive(const ZipArchive &archive, const PaintingReadOptions &options,
                                     const JobControl &control)
{
    Result<std::unique_ptr<ByteSource>> sketch = archive.entry("data.sketch");
    if (!sketch)
        return sketch.error();
    Result<std::unique_ptr<ByteSource>> metadata = archive.entry("metadata.json");
    if (!metadata && metadata.error().code != ErrorCode::FileNotFound)
        return metadata.error();
    return readTilt(**sketch, metadata ? metadata->get() : nullptr, options, control);
}

Result<PaintingFile> readTiltFolder(const fs::path &folder, const PaintingReadOptions &options,
                                    const JobControl &control)
{
    Result<std::unique_ptr<ByteSource>> sketch = openFileSource(folder / "data.sketch", "data.sketch");
    if (!sketch)
        return sketch.error();
    Result<std::unique_ptr<ByteSource>> metadata = openFileSource(folder / "metadata.json", "metadata.json");
    if (!metadata && metadata.error().code != ErrorCode::FileNotFound)
        return metadata.error();
    return readTilt(**sketch, metadata ? metadata->get() : nullptr, options, control);
}

Result<PaintingFile> readAnyPainting(const fs::path &path, const PaintingReadOptions &options,
                                     const JobControl &control)
{
    std::error_code code;
    const std::string name = path.filename().string();
    if (fs::is_directory(path, code)) {
        if (fs::exists(path / "Quill.json", code))
            return readQuillFolder(path, options, control);
        if (fs::exists(path / "data.sketch", code))
            return readTiltFolder(path, options, control);
        return notAPainting(path.string());
    }
    Result<std::unique_ptr<ByteSource>> file = openFileSource(path, name);
    if (!file)
        return file.error();
    std::array<char, 4> magic{};
    if ((*file)->size() < magic.size())
        return notAPainting(name);
    if (const auto done = (*file)->read(0, std::as_writable_bytes(std::span(magic))); !done)
        return done.error();
    const std::string_view head(magic.data(), magic.size());
    if (head.starts_with("PK")) {
        const Result<ZipArchive> archive = ZipArchive::open(path, 0, name);
        if (!archive)
            return archive.error();
        return readQuillArchive(*archive, options, control);
    }
    if (head == "tilT") {
        const Result<std::uint64_t> prefix = tiltPrefix(**file);
        if (!prefix)
            return prefix.error();
        const Result<ZipArchive> archive = ZipArchive::open(path, *prefix, name);
        if (!archive)
            return archive.error();
        return readTiltArchive(*archive, options, control);
    }
    if (path.extension() == ".json" || head.find('{') != std::string_view::npos) {
        // The project's files stand beside one another under their fixed names.
        Result<std::unique_ptr<ByteSource>> qbin =
            openFileSource(path.parent_path() / "Quill.qbin", "Quill.qbin");
        if (!qbin && qbin.error().code != ErrorCode::FileNotFound)
            return qbin.error();
        return readQuill(**file, qbin ? qbin->get() : nullptr, options, control);
    }
    return notAPainting(name);
}

template <typename Function>
Result<PaintingFile> guarded(const std::string &name, const Function &function)
{
    try {
        return function();
    } catch (const std::bad_alloc &) {
        return Error{ErrorCode::TooLarge, attempted, "the memory does not suffice for it",
                     "Read only the first frame, or split the painting", name};
    }
}

} // namespace

Eigen::Affine3d PaintingFileTransform::matrix() const
{
    Eigen::Vector3d flips = Eigen::Vector3d::Ones();
    if (flip != PaintingFileFlip::None)
        flips[int(flip) - int(PaintingFileFlip::X)] = -1;
    return Eigen::Translation3d(translation) * rotation * Eigen::Scaling(Eigen::Vector3d(scale * flips));
}

std::string PaintingFile::pathOf(int layer) const
{
    std::string path;
    for (; layer >= 0; layer = layers[std::size_t(layer)].parent)
        path = layers[std::size_t(layer)].name + (path.empty() ? "" : "/" + path);
    return path;
}

Eigen::Affine3d PaintingFile::sceneFromLayer(int layer) const
{
    Eigen::Affine3d transform = Eigen::Affine3d::Identity();
    for (; layer >= 0; layer = layers[std::size_t(layer)].parent)
        transform = layers[std::size_t(layer)].transform.matrix() * transform;
    return transform;
}

bool PaintingFile::isShown(int layer) const
{
    for (; layer >= 0; layer = layers[std::size_t(layer)].parent)
        if (!layers[std::size_t(layer)].visible)
            return false;
    return true;
}

Result<PaintingFile> readPainting(const fs::path &path, const PaintingReadOptions &options,
                                  const JobControl &control)
{
    return guarded(path.filename().string(), [&] { return readAnyPainting(path, options, control); });
}

Result<PaintingFile> parsePainting(std::string_view bytes, const std::string &name,
                                   const PaintingReadOptions &options, const JobControl &control)
{
    return guarded(name, [&]() -> Result<PaintingFile> {
        if (bytes.starts_with("tilT")) {
            const Result<std::uint64_t> prefix = tiltPrefix(*memorySource(bytes, name));
            if (!prefix)
                return prefix.error();
            const Result<ZipArchive> archive = ZipArchive::openMemory(bytes.substr(*prefix), name);
            if (!archive)
                return archive.error();
            return readTiltArchive(*archive, options, control);
        }
        if (!bytes.starts_with("PK"))
            return notAPainting(name);
        const Result<ZipArchive> archive = ZipArchive::openMemory(bytes, name);
        if (!archive)
            return archive.error();
        return readQuillArchive(*archive, options, control);
    });
}

} // namespace ductus
