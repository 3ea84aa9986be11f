// Where the light of a picture comes from: a sky dome and a soft key light as many small far lamps that cast
// shadows, and a fill light that does not. Directions are in the stage and point towards the lamp.
#pragma once

#include "geometry/triangle_mesh.h"

#include <vector>

namespace ductus::picture {

struct Lamp
{
    Vec3 towards;          // unit
    double strength = 0.0; // irradiance on a face that looks at it
};

struct Lights
{
    std::vector<Lamp> sky; // above the horizon; together irradiance 1 on a free horizontal face
    std::vector<Lamp> key; // in a narrow cone; together irradiance 1 on a face that looks at its middle
    Vec3 towardsKey;
    Vec3 towardsFill;
};

/// Key light from above the camera's left shoulder, fill from its right, so that every view is lit alike.
Lights studioLights(double cameraAzimuthDegrees);

} // namespace ductus::picture
