#include "render/passes/view_uniforms.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

struct Block // std140
{
    float clipFromRelative[16]; // column by column
    float rayDirection[3][4];
    float eyeInScene[4];
    float forward[4];
    float limits[4];
};

void put(float *to, const Vec3 &v, double w = 0)
{
    for (int i = 0; i < 3; ++i)
        to[i] = float(v[i]);
    to[3] = float(w);
}

} // namespace

void ViewUniforms::set(const FrameCamera &camera, int width, int height)
{
    const double l = camera.left, r = camera.right, d = camera.down, u = camera.up;
    // z stays in the middle: depth is written by the shaders.
    Eigen::Matrix4d clipFromCamera = Eigen::Matrix4d::Zero();
    clipFromCamera(0, 0) = 2 / (r - l);
    clipFromCamera(0, 2) = (r + l) / (r - l);
    clipFromCamera(1, 1) = 2 / (u - d);
    clipFromCamera(1, 2) = (u + d) / (u - d);
    clipFromCamera(3, 2) = -1;
    Eigen::Matrix4d cameraFromRelative = Eigen::Matrix4d::Identity();
    cameraFromRelative.topLeftCorner<3, 3>() = camera.rotation.conjugate().toRotationMatrix();
    const Eigen::Matrix4f clip = (clipFromCamera * cameraFromRelative).cast<float>();

    Block block{};
    std::copy_n(clip.data(), 16, block.clipFromRelative);
    put(block.rayDirection[0], camera.rotation * Vec3(l, d, -1));
    put(block.rayDirection[1], camera.rotation * Vec3((r - l) / width, 0, 0));
    put(block.rayDirection[2], camera.rotation * Vec3(0, (u - d) / height, 0));
    put(block.eyeInScene, camera.eye);
    // Floats have the same digits at any size, so that nothing need be known of the scene's.
    put(block.forward, camera.rotation * Vec3(0, 0, -1), camera.nearDepth > 0 ? camera.nearDepth : 1e-12);
    const double longest =
        Vec3(std::max(std::abs(l), std::abs(r)), std::max(std::abs(d), std::abs(u)), 1).norm();
    put(block.limits, Vec3(camera.nearDepth, longest, 0));

    if (!mBuffer)
        mBuffer = GlBuffer::create();
    glBindBuffer(GL_UNIFORM_BUFFER, mBuffer.name());
    glBufferData(GL_UNIFORM_BUFFER, sizeof(Block), &block, GL_STREAM_DRAW);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, mBuffer.name());
}

} // namespace ductus
