// What a picture shows: meshes and strokes, in one frame and unit. Input of renderPicture
// (surface_picture.h).
#pragma once

#include "geometry/triangle_mesh.h"
#include "imaging/image.h"

#include <vector>

namespace ductus {

/// The warm light grey of unpainted modelling clay.
inline constexpr Rgba clayColour{201, 195, 186, 255};

struct PictureMesh
{
    TriangleMesh mesh;                 // triangles with invalid indices or non-finite corners are left out
    Rgba colour = clayColour;          // of triangles without their own
    std::vector<Rgba> triangleColours; // one a triangle, or empty
    std::vector<Rgba>
        vertexColours;  // one a vertex (blended across triangles), or empty; goes before the others
    bool smooth = true; // false: every triangle flat
    double creaseAngleDegrees = 40.0; // normals are not averaged across sharper edges
    bool drawCreases = true;          // fine dark lines along sharp edges, mesh borders and between colours
};

/// A polyline drawn as a round tube.
struct PictureLine
{
    std::vector<Vec3> points; // non-finite ones interrupt the line; a single one is drawn as a ball
    Rgba colour{58, 64, 72, 255};
    double radius = 0.0; // scene units; never drawn thinner than about one pixel
    double visibleBehind =
        0.0; // scene units: still drawn in front when buried no deeper than this in a surface
    bool faintWhenHidden = false; // shine through what hides it, instead of vanishing
};

struct PictureScene
{
    std::vector<PictureMesh> meshes;
    std::vector<PictureLine> lines;
    std::vector<Vec3> alsoInFrame; // not drawn, but kept in the picture: pictures of a sketch and of its
                                   // surface that each name the other's points are taken from the same place
};

struct PictureOptions
{
    int width = 1280; // pixels, 1..16384
    int height = 960;
    double azimuthDegrees = 35.0;   // camera around the up axis; 0 looks along -z (y up) or along +y (z up)
    double elevationDegrees = 25.0; // camera above the horizon
    bool zUp = false;
    double fieldOfViewDegrees = 26.0; // vertical; the distance follows so that everything is in the picture
    double margin = 0.08;             // share of the picture kept free on each side
    int supersampling = 2;            // samples a pixel along each axis, 1..4
    bool softLight = true;            // sky and key light cast shadows; false is quicker
    bool groundShadow = true;
    Rgba backgroundTop{246, 247, 249, 255};
    Rgba backgroundBottom{214, 218, 224, 255};
};

} // namespace ductus
