// The pinhole camera of a picture. Eye space: x right, y up, z depth in front of the eye; sample space: x
// right, y down, in samples from the top left corner.
#pragma once

#include "imaging/picture/stage.h"

#include <Eigen/Core>

namespace ductus::picture {

struct Camera
{
    Eigen::Matrix3d eyeFromStage = Eigen::Matrix3d::Identity(); // rows: right, up, towards the scene
    Vec3 eyeInStage = Vec3::Zero();
    double focalSamples = 1.0;
    double centreX = 0.0; // of the picture, in samples
    double centreY = 0.0;

    Vec3 toEye(const Vec3 &stagePoint) const { return eyeFromStage * (stagePoint - eyeInStage); }
    Vec3 toStage(const Vec3 &eyePoint) const { return eyeFromStage.transpose() * eyePoint + eyeInStage; }

    Eigen::Vector2d project(const Vec3 &eyePoint) const
    {
        const double scale = focalSamples / eyePoint.z();
        return {centreX + eyePoint.x() * scale, centreY - eyePoint.y() * scale};
    }

    /// Eye-space direction, of depth 1, through a place of the picture.
    Vec3 ray(double sampleX, double sampleY) const
    {
        return {(sampleX - centreX) / focalSamples, (centreY - sampleY) / focalSamples, 1.0};
    }
};

/// The nearest camera that looks in the asked direction and has the whole stage in the picture.
/// \a options must be clamped; sizes are multiplied by its supersampling.
Camera framedCamera(const Stage &stage, const PictureOptions &options);

} // namespace ductus::picture
