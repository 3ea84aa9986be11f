#include "sketchsurfacer/ui/viewport/sketch_scene.h"

#include "sketchsurfacer/ui/viewport/mesh_actor.h"

#include <algorithm>
#include <cstring>
#include <vtkAutoInit.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTexture.h>

namespace ductus {

namespace {

constexpr double forwardShare =
    1.0 / 90; // of the scene's diagonal: how deep a line in a surface is still seen

// Lights that go with the camera: the work is lit the same from everywhere.
void addLights(vtkRenderer *renderer)
{
    struct Lamp
    {
        double position[3];
        double colour[3];
        double intensity;
    };
    // Camera coordinates: the eye is at (0, 0, 1), the target at the origin.
    const Lamp lamps[] = {
        {{-0.55, 0.9, 0.85}, {1.0, 0.985, 0.96}, 0.62}, // key, above the left shoulder
        {{0.9, 0.15, 0.75}, {0.9, 0.94, 1.0}, 0.30},    // fill
        {{0.05, 0.1, 1.0}, {1.0, 1.0, 1.0}, 0.34},      // along the view, so that nothing is black
        {{0.2, -0.9, 0.25}, {0.86, 0.9, 1.0}, 0.12},    // what the ground throws back
    };
    renderer->AutomaticLightCreationOff();
    for (const Lamp &lamp : lamps) {
        vtkNew<vtkLight> light;
        light->SetLightTypeToCameraLight();
        light->SetPosition(lamp.position);
        light->SetFocalPoint(0, 0, 0);
        light->SetColor(lamp.colour);
        light->SetIntensity(lamp.intensity);
        renderer->AddLight(light);
    }
}

vtkSmartPointer<vtkRenderer> newRenderer()
{
    auto renderer = vtkSmartPointer<vtkRenderer>::New();
    renderer->GradientBackgroundOn();
    addLights(renderer);
    return renderer;
}

vtkSmartPointer<vtkActor> newActorFor(SceneItem item)
{
    switch (item) {
    case SceneItem::Creases:
        return newLineActor({32, 30, 28, 255}, 1.4);
    case SceneItem::Dots:
    case SceneItem::SketchDots:
        return newDotActor();
    default:
        return newMeshActor();
    }
}

vtkSmartPointer<vtkTexture> textureOf(const Image &image)
{
    vtkNew<vtkImageData> data;
    data->SetDimensions(image.width, image.height, 1);
    data->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
    std::memcpy(data->GetScalarPointer(), image.pixels.data(), image.pixels.size());
    auto texture = vtkSmartPointer<vtkTexture>::New();
    texture->SetInputData(data);
    texture->InterpolateOn();
    return texture;
}

} // namespace

SketchScene::SketchScene() : mMain(newRenderer()), mLeft(newRenderer())
{
    // The ground first: it is blended over the background alone, and what stands on it is drawn over it.
    // VTK's pass for translucent things would lighten it.
    for (int i = sceneItemCount - 1; i >= 0; --i) {
        const SceneItem item = SceneItem(i);
        mActors[std::size_t(i)] = newActorFor(item);
        if (item == SceneItem::Sketch || item == SceneItem::SketchDots)
            mLeft->AddActor(actor(item));
        else
            mMain->AddActor(actor(item));
    }
    // Colours that say something stay near themselves, also in the shade.
    for (const SceneItem item : {SceneItem::Regions, SceneItem::Deviation, SceneItem::Ambiguity,
                                 SceneItem::Strokes, SceneItem::Sketch}) {
        actor(item)->GetProperty()->SetAmbient(0.34);
        actor(item)->GetProperty()->SetDiffuse(0.68);
    }
    actor(SceneItem::Scribbles)->GetProperty()->SetAmbient(0.45); // their colour is their meaning
    actor(SceneItem::Scribbles)->GetProperty()->SetDiffuse(0.6);
    vtkProperty *ground = actor(SceneItem::Ground)->GetProperty();
    ground->LightingOff();
    ground->SetColor(0, 0, 0);
    actor(SceneItem::Ground)->ForceOpaqueOn();
    mLeft->DrawOff();
}

void SketchScene::setMesh(SceneItem item, const ShadedMesh &mesh)
{
    setActorMesh(actor(item), mesh);
    mHasContent[std::size_t(item)] = !mesh.isEmpty();
}

void SketchScene::setCreases(const std::vector<std::vector<Vec3>> &lines, double pixelRatio)
{
    setActorLines(actor(SceneItem::Creases), lines);
    actor(SceneItem::Creases)->GetProperty()->SetLineWidth(float(1.4 * pixelRatio));
    mHasContent[std::size_t(SceneItem::Creases)] = !lines.empty();
}

void SketchScene::setDots(SceneItem item, const std::vector<Vec3> &dots, const std::vector<Rgba> &colours,
                          double pixels)
{
    setActorDots(actor(item), dots, colours);
    actor(item)->GetProperty()->SetPointSize(float(pixels));
    mHasContent[std::size_t(item)] = !dots.empty();
}

void SketchScene::setGround(const GroundShadow &shadow)
{
    mHasContent[std::size_t(SceneItem::Ground)] = !shadow.isEmpty();
    if (shadow.isEmpty())
        return;
    mGroundHeight = shadow.height;
    vtkNew<vtkPlaneSource> plane;
    const Vec3 u = shadow.corner + shadow.alongU, v = shadow.corner + shadow.alongV;
    plane->SetOrigin(shadow.corner.x(), shadow.corner.y(), shadow.corner.z());
    plane->SetPoint1(u.x(), u.y(), u.z());
    plane->SetPoint2(v.x(), v.y(), v.z());
    plane->Update();
    static_cast<vtkPolyDataMapper *>(actor(SceneItem::Ground)->GetMapper())->SetInputData(plane->GetOutput());
    actor(SceneItem::Ground)->SetTexture(textureOf(shadow.image));
}

void SketchScene::setVisible(SceneItem item, bool visible)
{
    if (item == SceneItem::Ground)
        mGroundIsWanted = visible;
    actor(item)->SetVisibility(visible && has(item));
}

bool SketchScene::isVisible(SceneItem item) const
{
    return actor(item)->GetVisibility();
}

bool SketchScene::has(SceneItem item) const
{
    return mHasContent[std::size_t(item)];
}

void SketchScene::setSmoothEdges(bool on)
{
    for (vtkRenderer *renderer : {mMain.Get(), mLeft.Get()})
        renderer->SetUseFXAA(on);
}

void SketchScene::setBackground(Rgba top, Rgba bottom)
{
    for (vtkRenderer *renderer : {mMain.Get(), mLeft.Get()}) {
        renderer->SetBackground(bottom[0] / 255.0, bottom[1] / 255.0, bottom[2] / 255.0);
        renderer->SetBackground2(top[0] / 255.0, top[1] / 255.0, top[2] / 255.0);
    }
}

void SketchScene::follow(const ViewCamera &view, std::optional<double> divider)
{
    const double split = divider ? std::clamp(*divider, 0.02, 0.98) : 0.0;
    mLeft->SetDraw(divider.has_value());
    const double spans[2][2] = {{split, 1.0}, {0.0, split}};
    vtkRenderer *renderers[2] = {mMain, mLeft};
    const Vec3 eye = view.eye(), target = view.target(), up = view.up();
    const double diagonal = std::max(mExtent.isEmpty() ? 0.0 : mExtent.diagonal(), 1e-9);
    const double depth = mExtent.isEmpty() ? view.distance() : (mExtent.centre() - eye).dot(view.forward());
    for (int i = 0; i < 2; ++i) {
        if (i == 1 && !divider)
            break;
        const double width = spans[i][1] - spans[i][0];
        renderers[i]->SetViewport(spans[i][0], 0.0, spans[i][1], 1.0);
        vtkCamera *camera = renderers[i]->GetActiveCamera();
        camera->SetPosition(eye.data());
        camera->SetFocalPoint(target.data());
        camera->SetViewUp(up.data());
        camera->SetViewAngle(view.fieldOfViewDegrees());
        camera->SetParallelProjection(!view.isPerspective());
        camera->SetParallelScale(view.halfHeight());
        // A part of the whole picture, not a narrower picture of its own.
        camera->SetWindowCenter((spans[i][0] + spans[i][1] - 1.0) / width, 0.0);
        const double reach = 1.2 * diagonal;
        const double nearest =
            view.isPerspective() ? std::max(depth - reach, 0.002 * (depth + reach)) : depth - reach;
        camera->SetClippingRange(nearest, std::max(depth + reach, nearest + diagonal));
    }
    // From below the shadow would hide what casts it.
    actor(SceneItem::Ground)
        ->SetVisibility(mGroundIsWanted && has(SceneItem::Ground) && view.worldUp().dot(eye) > mGroundHeight);
    const double distance = forwardShare * diagonal;
    const double share = std::clamp(distance / std::max(depth, 1e-9), 0.0, 0.2);
    bringForward(actor(SceneItem::Strokes), eye, view.forward(), view.isPerspective(), share, distance);
    bringForward(actor(SceneItem::Dots), eye, view.forward(), view.isPerspective(), 0.5 * share,
                 0.5 * distance);
    bringForward(actor(SceneItem::Scribbles), eye, view.forward(), view.isPerspective(), 1.2 * share,
                 1.2 * distance);
    bringForward(actor(SceneItem::Creases), eye, view.forward(), view.isPerspective(), 0.3 * share,
                 0.3 * distance);
}

} // namespace ductus
