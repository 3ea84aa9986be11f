// Which triangle and which tube is seen through each sample of the picture, tile by tile.
#pragma once

#include "imaging/picture/camera.h"

#include <cstdint>
#include <vector>

namespace ductus::picture {

/// The nearest things along one ray. Depths are along the view axis, in stage units; -1 where there is
/// nothing.
struct Sample
{
    float surfaceDepth = 0.0f;
    float tubeDepth = 0.0f;
    std::int32_t triangle = -1;
    std::int32_t tube = -1;       // in front of the triangle
    std::int32_t hiddenTube = -1; // behind it, to shine through
};

/// Where the ray from the origin along \a direction (depth 1) enters a tube; false if it misses.
struct TubeHit
{
    double depth = 0.0;
    Vec3 normal = Vec3::Zero(); // unit, eye space
};
bool hitTube(const Vec3 &a, const Vec3 &b, double radius, const Vec3 &direction, TubeHit &hit);

class Visibility
{
public:
    static constexpr int tilePixels = 32;

    /// All must outlive the object.
    Visibility(const Stage &stage, const Camera &camera, int width, int height, int supersampling);

    int tileColumns() const { return mColumns; }
    int tileRows() const { return mRows; }

    /// Samples of one tile, row by row, tileSamples() to a row, also beyond the edge of the picture.
    void traceTile(int column, int row, std::vector<Sample> &samples) const;
    int tileSamples() const { return tilePixels * mSupersampling; }

    /// Weights of the corners of \a triangle at a place it is seen at; perspective-correct, they sum to 1.
    Vec3 barycentric(int triangle, double sampleX, double sampleY) const;

    /// The radius \a tube is drawn with: at least about a pixel wide.
    double drawnRadius(int tube) const { return mTubes[std::size_t(tube)].radius; }
    /// Its ends in eye space.
    const Vec3 &tubeEnd(int tube, int end) const { return mTubes[std::size_t(tube)].ends[end]; }

private:
    struct ScreenTriangle
    {
        Eigen::Vector2d points[3];
        double inverseDepth[3];
        double area; // twice, signed
    };
    struct ScreenTube
    {
        Vec3 ends[2];
        double radius;
        double visibleBehind;
        Eigen::Vector2d boxMin, boxMax; // samples
    };

    void bin();
    void traceTriangle(int triangle, int left, int top, std::vector<Sample> &samples) const;
    void traceTube(int tube, int left, int top, std::vector<Sample> &samples) const;

    const Stage &mStage;
    const Camera &mCamera;
    int mSupersampling;
    int mColumns;
    int mRows;
    std::vector<ScreenTriangle> mTriangles;
    std::vector<ScreenTube> mTubes;
    // Things that may touch a tile, ascending; those of tile i are at begin[i] .. begin[i + 1].
    std::vector<std::size_t> mTriangleBegin, mTubeBegin;
    std::vector<std::int32_t> mTileTriangles, mTileTubes;
};

} // namespace ductus::picture
