// Cameras that were found elsewhere, for a clip's analysis: as our JSON, or as COLMAP's text model.
//
// JSON: {"width": 1920, "height": 1080, "cameras": [{"frame": 0, "position": [x, y, z],
// "rotation": [x, y, z, w], "focal": f, "centre": [x, y]}, ...]}: rotation of worldFromCamera (camera: x
// right, y down, z into the picture), pixels of a picture of that size, whole numbers at the pixels' corners;
// "centre" may be missing. Frames in between that are missing are put in between; all have a focal length.
//
// COLMAP: the folder with cameras.txt and images.txt; images in the order of their names are the frames, so
// there must be one a frame. Distortion is left out.
#pragma once

#include "base/result.h"
#include "doodling/scene/shot_camera.h"

#include <filesystem>
#include <vector>

namespace ductus {

struct GivenCameras
{
    std::vector<ShotCamera> cameras; // one a frame, pixels of the clip
    std::vector<std::string> warnings;
};

/// \a path: a JSON file or COLMAP's folder. Errors name file and place: FileNotFound, Malformed,
/// TooLittleData (frames without a camera).
Result<GivenCameras> readGivenCameras(const std::filesystem::path &path, int frameCount, int clipWidth,
                                      int clipHeight);

Result<GivenCameras> parseCameraJson(std::string_view text, const std::string &name, int frameCount,
                                     int clipWidth, int clipHeight);
Result<GivenCameras> parseColmap(std::string_view camerasText, std::string_view imagesText,
                                 const std::string &name, int frameCount, int clipWidth, int clipHeight);

} // namespace ductus
