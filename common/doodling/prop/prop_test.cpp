// Props: where the camera sees them, how far away, what hides them, in which look; and updates that keep
// their place.
#include "doodling/canvas/edit_scene.h"
#include "doodling/compositing/doodle_painter.h"
#include "doodling/prop/prop_link.h"
#include "doodling/prop/prop_view.h"
#include "painting/edit/element_edits.h"
#include "painting/edit/layer_edits.h"
#include "painting/edit/look_edits.h"
#include "project/project_reader.h"

#include <QtTest>
#include <numbers>

using namespace ductus;

namespace {

constexpr int width = 160, height = 96, frames = 3;
const Uuid paintingId = *Uuid::parse("a1a1a1a1-b2b2-4c3c-8d4d-e5e5e5e5e5e5");

// Everything at depth 10; in the right half something at depth 2.
Shot shotOfTwoHalves()
{
    Shot shot;
    shot.width = shot.clipWidth = width;
    shot.height = shot.clipHeight = height;
    ShotCamera camera;
    camera.focal = 160.0;
    camera.centre = Vec2(80.0, 48.0);
    shot.cameras.assign(frames, camera);
    std::vector<float> disparities;
    for (int y = 0; y < height / 4; ++y)
        for (int x = 0; x < width / 4; ++x)
            disparities.push_back(x >= 20 ? 0.5f : 0.1f);
    shot.depths.assign(frames, depthMapOf(width / 4, height / 4, 4.0, disparities));
    return shot;
}

Image pictureOfTwoHalves()
{
    Image picture(width, height, {90, 110, 130, 255});
    for (int y = 0; y < height; ++y)
        for (int x = 80; x < width; ++x)
            picture.set(x, y, {200, 60, 40, 255});
    return picture;
}

// A red block two wide, one high and deep, standing on y = 0, and a look "blue" in which it is blue.
Painting block(double high = 1.0)
{
    const AddedStack stack = *addStack({}, "block");
    MeshShape mesh;
    for (int corner = 0; corner < 8; ++corner)
        mesh.mesh.vertices.emplace_back(corner & 1 ? 1 : -1, corner & 2 ? high : 0, corner & 4 ? 0.5 : -0.5);
    mesh.mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                           {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    mesh.vertexColours.assign(8, Eigen::Vector3f(1, 0, 0));
    Painting painting =
        addElements(stack.painting, stack.substrate, {std::make_shared<const ElementShape>(mesh)})->painting;
    LayerProperties properties = painting.findLayer(stack.substrate)->properties;
    properties.colour = Eigen::Vector3f(0, 0, 1);
    painting = addLook(*setLayerProperties(painting, stack.substrate, properties), "blue").painting;
    properties.colour.reset();
    return *setLayerProperties(painting, stack.substrate, properties);
}

Project projectOf(const Painting &painting)
{
    Project project;
    project.documents.push_back(newDocument(
        paintingId, "block", std::make_shared<const PaintingContent>(painting, UnknownPaintingMembers())));
    return project;
}

// A canvas of 2 x 1 at depth 5 in the picture's middle: it covers the pixels 48..112 by 32..64.
Canvas standing(const std::string &look = {}, double depth = 5.0)
{
    Prop prop = *propFromProject(projectOf(block()), "");
    prop.look = look;
    Canvas canvas;
    canvas.size = Vec2(2.0, 1.0);
    canvas.keyframes.positions = {{0, Vec2(80.0, 48.0), depth, false}};
    prop.placement = standingOnSheet(prop.painting->painting(), canvas.size);
    canvas.prop = std::make_shared<const Prop>(std::move(prop));
    return canvas;
}

Image painted(const Canvas &canvas)
{
    const Shot shot = shotOfTwoHalves();
    const DoodleScene scene = *withCanvas({}, canvas);
    const std::vector<CanvasTrack> tracks = {*canvasTrack(shot, scene.canvases[0], {})};
    return DoodlePainter().alone({shot, scene, tracks, 1}, pictureOfTwoHalves());
}

} // namespace

class PropTest : public QObject
{
    Q_OBJECT
private slots:
    void standsUprightOnTheSheetsLowerEdge();
    void isSeenWhereTheCameraSeesIt();
    void knowsHowFarAwayEachPixelIs();
    void isHiddenByWhatIsFilmedBeforeIt();
    void isShownInItsLook();
    void turnsWithItsCanvas();
    void behindTheCameraIsNothing();
    void updatesKeepPlaceAndLook();
};

void PropTest::standsUprightOnTheSheetsLowerEdge()
{
    const Placement placement = standingOnSheet(block(), {4.0, 8.0});
    const Eigen::Affine3d canvasFromPainting = placement.matrix();
    QVERIFY((canvasFromPainting * Vec3(0, 0, 0) - Vec3(0, 4, 0)).norm() < 1e-12); // its foot
    QVERIFY((canvasFromPainting * Vec3(1, 0, 0) - Vec3(2, 4, 0)).norm() < 1e-12); // fits in width
    QVERIFY((canvasFromPainting * Vec3(0, 1, 0) - Vec3(0, 2, 0)).norm() < 1e-12); // y is up
    QVERIFY((canvasFromPainting * Vec3(0, 0, 1)).z() < 0);                        // its front is near
    QVERIFY(propProblem(*standing().prop).empty());
}

void PropTest::isSeenWhereTheCameraSeesIt()
{
    Canvas canvas = standing();
    canvas.occlusion.isOn = false;
    const Image image = painted(canvas);
    // The front face is half a unit nearer than the canvas: 4.5 away, 2 x 1 large, foot at y = 48 + 16/0.9.
    const double scale = 160.0 / 4.5;
    const int left = int(80 - scale), top = int(48 - 0.5 * scale), right = int(80 + scale),
              bottom = int(48 + 0.5 * scale);
    QCOMPARE(image.at(80, 48), Rgba({255, 0, 0, 255}));
    for (const auto &[x, y] : {std::pair(left + 2, top + 2), {right - 2, top + 2}, {left + 2, bottom - 2}})
        QCOMPARE(image.at(x, y), Rgba({255, 0, 0, 255}));
    for (const auto &[x, y] : {std::pair(left - 3, 48), {right + 3, 48}, {80, top - 3}, {80, bottom + 3}})
        QCOMPARE(int(image.at(x, y)[3]), 0);
}

void PropTest::knowsHowFarAwayEachPixelIs()
{
    const Canvas canvas = standing();
    const Shot shot = shotOfTwoHalves();
    const CanvasTrack track = *canvasTrack(shot, canvas, {});
    const PaintingSolid solid = *PaintingSolid::make(canvas.prop->painting->painting(), {}, {});
    const PropPicture seen =
        propPicture(solid, *canvas.prop, track.frames[0], shot.cameras[0], {0, 0, width, height}, 1);
    QVERIFY(std::abs(seen.depthAt(Vec2(80.5, 48.5), -1.0) - 4.5) < 1e-4);
    QCOMPARE(seen.depthAt(Vec2(1.0, 1.0), -1.0), -1.0);
    QVERIFY(seen.layer.box.left > 40 && seen.layer.box.right < 120);
}

void PropTest::isHiddenByWhatIsFilmedBeforeIt()
{
    const Image image = painted(standing());
    QCOMPARE(int(image.at(60, 48)[3]), 255);
    QCOMPARE(int(image.at(100, 48)[3]), 0);
    // Nearer than all of it, it hides what is filmed.
    QCOMPARE(int(painted(standing({}, 1.2)).at(100, 48)[3]), 255);
}

void PropTest::isShownInItsLook()
{
    QCOMPARE(painted(standing("blue")).at(60, 48), Rgba({0, 0, 255, 255}));
    QCOMPARE(painted(standing("no such look")).at(60, 48), Rgba({255, 0, 0, 255}));
}

void PropTest::turnsWithItsCanvas()
{
    Canvas canvas = standing();
    canvas.occlusion.isOn = false;
    canvas.keyframes.turns = {
        {0, Eigen::Quaterniond(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitY())), false}};
    const Image image = painted(canvas);
    QCOMPARE(int(image.at(80, 48)[3]), 255); // its short side, one wide at depth 4
    QCOMPARE(int(image.at(80 + 16, 48)[3]), 255);
    QCOMPARE(int(image.at(80 + 26, 48)[3]), 0);
}

void PropTest::behindTheCameraIsNothing()
{
    const Canvas canvas = standing();
    const PaintingSolid solid = *PaintingSolid::make(canvas.prop->painting->painting(), {}, {});
    CanvasFrame place;
    place.position = Vec3(0, 0, -20);
    QVERIFY(propPicture(solid, *canvas.prop, place, shotOfTwoHalves().cameras[0], {0, 0, width, height}, 1)
                .layer.box.isEmpty());
}

void PropTest::updatesKeepPlaceAndLook()
{
    const DoodleScene scene = *withCanvas({}, standing("blue"));
    ProjectReadOptions options;
    options.kinds = {paintingKind()};
    const Project same = projectOf(block()), other = projectOf(block(2.0)), gone;
    LinkSources sameSources(same, {}, options), otherSources(other, {}, options),
        goneSources(gone, {}, options);
    QVERIFY(!propLinks(scene, sameSources)[0].update);
    QVERIFY(propLinks(scene, goneSources)[0].problem);
    const std::vector<PropLink> links = propLinks(scene, otherSources);
    QVERIFY(links[0].update);
    const DoodleScene updated = withUpdatedProps(scene, links);
    const Prop &before = *scene.canvases[0].prop, &after = *updated.canvases[0].prop;
    QVERIFY(after.placement == before.placement);
    QCOMPARE(after.look, before.look);
    QVERIFY(after.link.digest != before.link.digest);
    QVERIFY(!propLinks(updated, otherSources)[0].update);
    QCOMPARE(painted(updated.canvases[0]).at(60, 20), Rgba({0, 0, 255, 255})); // twice as high
    QCOMPARE(int(painted(scene.canvases[0]).at(60, 20)[3]), 0);
}

QTEST_APPLESS_MAIN(PropTest)
#include "prop_test.moc"
