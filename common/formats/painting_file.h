// Reading paintings other programs made: Quill projects (a folder with Quill.json and Quill.qbin, or the zip
// of one) and .tilt sketches of Tilt Brush and Open Brush. Strokes stay strokes: centreline, width, colour,
// order. Facts: quill-and-tilt.md.
#pragma once

#include "base/job_control.h"
#include "base/result.h"
#include "imaging/image.h"

#include <Eigen/Geometry>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ductus {

enum class PaintingFileKind { Quill, Tilt };

/// The shape of a stroke's cross section (quill-and-tilt.md section 2).
enum class PaintingFileSection { Ribbon, Round, Ellipse, Cube };

/// A point of the centreline, in the layer's space and unit. The members stand as in Quill.qbin.
struct PaintingFilePoint
{
    Eigen::Vector3f position = Eigen::Vector3f::Zero();
    Eigen::Vector3f normal = Eigen::Vector3f::UnitY(); // orients the cross section
    Eigen::Vector3f viewDirection =
        -Eigen::Vector3f::UnitZ(); // from the painter's eye when it was drawn; zero: unknown
    Eigen::Vector3f colour = Eigen::Vector3f::Zero(); // linear RGB, 0..1
    float opacity = 1;                                // 0..1
    float halfWidth = 0;                              // >= 0
};

struct PaintingFileStroke
{
    PaintingFileSection section = PaintingFileSection::Round;
    bool fadesSeenFromAside = false; // Quill's rotational opacity
    std::uint32_t id = 0;            // as in the file; not always unique
    std::uint32_t group = 0;         // strokes the painter grouped, of .tilt; 0: none
    std::string brush;               // the program's own name of the brush, if it has one
    std::vector<PaintingFilePoint> points;
    std::vector<float> pressure;     // 0..1, one a point, or empty
    std::vector<double> timeSeconds; // one a point, or empty
};

struct PaintingFileDrawing
{
    std::vector<PaintingFileStroke> strokes; // in drawing order
};

enum class PaintingFileFlip { None, X, Y, Z };

/// v' = rotation * scale * flip * v + translation. A flip reverses the winding.
struct PaintingFileTransform
{
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
    double scale = 1;
    PaintingFileFlip flip = PaintingFileFlip::None;
    Eigen::Vector3d translation = Eigen::Vector3d::Zero();

    Eigen::Affine3d matrix() const;
};

enum class PaintingFileInterpolation { None, Linear, EaseIn, EaseOut, SmoothStep };

template <typename T>
struct PaintingFileKey
{
    double timeSeconds = 0;
    T value{};
    PaintingFileInterpolation interpolation = PaintingFileInterpolation::None;
};

struct PaintingFileAnimation
{
    bool hasOwnTimeline = false;
    double durationSeconds = 0; // 0: as long as the parent
    double startOffsetSeconds = 0;
    int repeatCount = 0; // 0: for ever
    std::vector<PaintingFileKey<bool>> visibility;
    std::vector<PaintingFileKey<double>> opacity;
    std::vector<PaintingFileKey<double>> offsetSeconds;
    std::vector<PaintingFileKey<PaintingFileTransform>> transform;
};

/// Other: a layer whose content is not imported; it stays in the tree, and the report says so.
enum class PaintingFileLayerKind { Group, Paint, Picture, Other };

struct PaintingFileLayer
{
    std::string name; // UTF-8
    PaintingFileLayerKind kind = PaintingFileLayerKind::Group;
    int parent = -1; // an index that is smaller than the layer's own; -1 for the root alone
    bool visible = true;
    bool locked = false;
    double opacity = 1;              // 0..1; times that of the groups around it
    PaintingFileTransform transform; // parent from layer
    PaintingFileTransform pivot;
    PaintingFileAnimation animation;

    // Of paint layers:
    double framesPerSecond = 24;
    int frameRepeatCount = 0;                                         // 0: for ever
    std::vector<std::shared_ptr<const PaintingFileDrawing>> drawings; // those that frames show, never null
    std::vector<int> frames;                                          // indices of drawings; a still has one

    // Of picture layers:
    std::optional<Image> picture;
    std::string pictureType; // "2D", "360 Equirect Mono", ...
};

struct PaintingImportReport
{
    int layers = 0;
    int drawings = 0;
    int strokes = 0;
    std::int64_t points = 0;
    int pictures = 0;
    std::vector<std::string> skipped; // "Root/Music: sound layers are not imported"
    int unseenSkips =
        0; // of those, what no picture shows: places to stand in VR, which every Quill scene has
    std::vector<std::string> notes; // what was put right while reading
};

struct PaintingFile
{
    PaintingFileKind kind = PaintingFileKind::Quill;
    std::string title;
    double metresPerUnit = 1;
    double framesPerSecond = 24;
    std::optional<Eigen::Vector3f> background; // linear RGB
    std::vector<PaintingFileLayer> layers;     // the root first, parents before children, bottom to top
    PaintingImportReport report;

    /// "Root/Trees/Leaves".
    std::string pathOf(int layer) const;
    /// Scene from layer: the product of the transforms up to the root.
    Eigen::Affine3d sceneFromLayer(int layer) const;
    /// Visible with all groups around it.
    bool isShown(int layer) const;
};

struct PaintingReadOptions
{
    bool firstFrameOnly = false;             // of frame-by-frame layers, for a still
    std::int64_t maxPoints = 64'000'000;     // 3.6 GB; more is refused with TooLarge
    std::int64_t maxPicturePixels = 1 << 28; // of one picture; a larger one is skipped and reported
};

/// \a path: a folder with Quill.json, that Quill.json itself, a .quill archive, a .tilt file or folder.
Result<PaintingFile> readPainting(const std::filesystem::path &path, const PaintingReadOptions &options,
                                  const JobControl &control);

/// The same for an archive in memory; \a name stands in messages.
Result<PaintingFile> parsePainting(std::string_view bytes, const std::string &name,
                                   const PaintingReadOptions &options, const JobControl &control);

} // namespace ductus
