// SolidBuilder: welds grid patches into one mesh, orients it, and finds out which parts of the curves are
// sharp.
#pragma once

#include "support/grid_patch.h"
#include "support/solids.h"

namespace ductus {

class SolidBuilder
{
public:
    /// Lengths passed in are multiplied by \a scale in the finished solid.
    explicit SolidBuilder(std::string id, double scale = 1.0) : mId(std::move(id)), mScale(scale) {}

    /// A new smooth face; grids that belong to it are added by number.
    int addFace(std::string name);
    /// Neighbouring grids must have the same points on their common border (to 1e-7); degenerate cells are
    /// dropped.
    void addGrid(int face, const GridPatch &grid);
    void addFaceGrid(std::string name, const GridPatch &grid) { addGrid(addFace(std::move(name)), grid); }
    void addCurve(std::string name, CurveKind kind, Polyline points);

    /// Asserts that the patches form a manifold. A mesh without border is oriented outwards.
    Solid finish(std::optional<MirrorPlane> mirror = std::nullopt) const;

private:
    struct Cell
    {
        int face = 0;
        std::array<Vec3, 4> corners;
    };

    std::string mId;
    double mScale = 1.0;
    std::vector<std::string> mFaces;
    std::vector<Cell> mCells;
    std::vector<FeatureCurve> mCurves;
};

/// Dihedral angle in degrees (0 = flat) at edge \a edge of \a topology; 0 on a border.
struct MeshTopology;
double dihedralDegrees(const TriangleMesh &mesh, const MeshTopology &topology, int edge);

} // namespace ductus
