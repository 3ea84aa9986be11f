// The colour of light that leaves a place of a surface or tube towards the camera.
#pragma once

#include "imaging/picture/lights.h"
#include "imaging/picture/shadow_map.h"
#include "imaging/picture/stage.h"

#include <vector>

namespace ductus::picture {

/// Share of each light that reaches a place.
struct Exposure
{
    double sky = 0.0; // irradiance from the sky dome, 1 on a free horizontal face
    double key = 0.0; // from the key light, 1 on a free face that looks at it
};

class Shading
{
public:
    /// \a castShadows false leaves out the shadow maps. \a stage is needed only here.
    Shading(const Stage &stage, double cameraAzimuthDegrees, bool castShadows);

    const Lights &lights() const { return mLights; }

    /// Costs some 80 look-ups; neighbouring samples may share it. \a faceNormal: of the flat triangle, on the
    /// side that is seen.
    Exposure exposure(const Vec3 &point, const Vec3 &normal, const Vec3 &faceNormal) const;

    /// The same without shadows.
    Exposure freeExposure(const Vec3 &normal) const;

    /// Linear RGB of a matt surface with a faint gloss. \a towardsEye and \a normal unit, in the stage.
    Vec3 surfaceColour(const Vec3 &albedo, const Vec3 &normal, const Vec3 &towardsEye,
                       const Exposure &exposure) const;

private:
    Lights mLights;
    std::vector<ShadowMap> mSkyMaps, mKeyMaps; // one a lamp, or none
};

} // namespace ductus::picture
