// SketchScene: the VTK side of the viewport: actors, lights, background, and the cameras that follow a
// ViewCamera. What is shown is set by plain data; nothing here knows of widgets or documents.
#pragma once

#include "sketchsurfacer/ui/viewport/ground_shadow.h"
#include "sketchsurfacer/ui/viewport/shaded_mesh.h"
#include "sketchsurfacer/ui/viewport/view_camera.h"

#include <array>
#include <optional>
#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

namespace ductus {

/// What the scene is made of; the strokes of the left half of a comparison are those of the sketch.
enum class SceneItem {
    Strokes,
    Sketch,
    Dots, // strokes of a single point
    SketchDots,
    Proxy,
    Regions,
    Surface,
    Deviation,
    Ambiguity,
    Scribbles,
    Creases,
    Ground
};
inline constexpr int sceneItemCount = 12;

class SketchScene
{
public:
    SketchScene();

    /// The one that always draws, and the left one of comparisons.
    vtkRenderer *mainRenderer() const { return mMain; }
    vtkRenderer *leftRenderer() const { return mLeft; }

    void setMesh(SceneItem item, const ShadedMesh &mesh);
    void setCreases(const std::vector<std::vector<Vec3>> &lines, double pixelRatio);
    /// \a item: Dots or SketchDots. \a colours: one a dot.
    void setDots(SceneItem item, const std::vector<Vec3> &dots, const std::vector<Rgba> &colours,
                 double pixels);
    void setGround(const GroundShadow &shadow);
    void setVisible(SceneItem item, bool visible);
    bool isVisible(SceneItem item) const;
    bool has(SceneItem item) const;
    /// Edges without stairs; without a graphics card this costs three times the frame itself.
    void setSmoothEdges(bool on);
    void setBackground(Rgba top, Rgba bottom);
    /// Everything the scene may hold lies in \a box, scene units.
    void setExtent(const Box3 &box) { mExtent = box; }

    /// \a divider: left of this share of the width the sketch alone is seen; nothing: no comparison.
    void follow(const ViewCamera &camera, std::optional<double> divider);

private:
    vtkActor *actor(SceneItem item) const { return mActors[std::size_t(item)]; }

    vtkSmartPointer<vtkRenderer> mMain;
    vtkSmartPointer<vtkRenderer> mLeft;
    std::array<vtkSmartPointer<vtkActor>, sceneItemCount> mActors;
    std::array<bool, sceneItemCount> mHasContent = {};
    Box3 mExtent;
    double mGroundHeight = 0.0;
    bool mGroundIsWanted = false;
};

} // namespace ductus
