// The scene made ready for drawing: centred, its diagonal of length 1, y up, colours linear, normals at
// corners.
#pragma once

#include "imaging/picture_scene.h"

#include <array>
#include <vector>

namespace ductus::picture {

struct StageTriangle
{
    std::array<Vec3, 3> corners;
    std::array<Vec3, 3> normals; // unit, one a corner
    std::array<Vec3, 3> albedo;  // linear RGB in 0..1, one a corner
    Vec3 faceNormal;             // unit
};

/// A straight piece of a stroke or of a crease line: all points within radius of the segment a-b.
struct StageTube
{
    Vec3 a;
    Vec3 b;
    double radius = 0.0; // 0: as thin as can be drawn
    double visibleBehind = 0.0;
    Vec3 albedo = Vec3::Zero();
    bool isCrease = false; // unlit, half transparent, one pixel wide
    bool faintWhenHidden = false;
};

struct Stage
{
    std::vector<StageTriangle> triangles;
    std::vector<StageTube> tubes; // in scene order, creases after strokes
    std::vector<Vec3> alsoInFrame;
    double groundHeight = 0.0; // y of the lowest point
    bool isEmpty() const { return triangles.empty() && tubes.empty(); }
};

/// Drops what cannot be drawn (invalid indices, non-finite coordinates, triangles without area).
Stage makeStage(const PictureScene &scene, bool zUp);

} // namespace ductus::picture
