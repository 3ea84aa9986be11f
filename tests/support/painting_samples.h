// The bundled sample paintings of LayerPainter (thesis Fig. V.9 to V.11), made stroke by stroke.
#pragma once

#include "base/result.h"
#include "painting/scene/painting.h"

#include <filesystem>

namespace ductus {

struct SamplePaintingFile
{
    std::string id;     // of the file: id.ductus
    std::string title;  // what people read
    std::string lesson; // what can be learned, one line
    Painting painting;
};

Painting forestPath();
Painting planeOverClouds();
Painting deskDiorama();
Painting vaseInThreeGlazes();
Painting campfire();
Painting lighthouse();
Painting koiPond();

std::vector<SamplePaintingFile> samplePaintings();

/// ID.ductus for each, and paintings.json with their titles.
Result<void> writeSamplePaintings(const std::filesystem::path &folder);

} // namespace ductus
