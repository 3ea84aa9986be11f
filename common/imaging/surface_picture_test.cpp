#include "imaging/surface_picture.h"

#include <QtTest>
#include <cmath>
#include <limits>
#include <numbers>

using namespace ductus;

namespace {

constexpr Rgba red{200, 40, 40, 255};
constexpr Rgba green{40, 160, 60, 255};
constexpr Rgba blue{40, 60, 200, 255};

// A ball of radius 1 around \a centre by longitude and latitude.
TriangleMesh ball(const Vec3 &centre, int count = 96)
{
    TriangleMesh mesh;
    const auto vertex = [&](int i, int j) { return (i % count) * (count / 2 + 1) + j; };
    for (int i = 0; i < count; ++i) {
        for (int j = 0; j <= count / 2; ++j) {
            const double a = 2.0 * std::numbers::pi * i / count, b = 2.0 * std::numbers::pi * j / count;
            mesh.vertices.push_back(centre +
                                    Vec3(std::sin(b) * std::cos(a), std::cos(b), -std::sin(b) * std::sin(a)));
        }
    }
    for (int i = 0; i < count; ++i) {
        for (int j = 0; j < count / 2; ++j) {
            mesh.triangles.push_back({vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1)});
            mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i + 1, j)});
        }
    }
    return mesh;
}

// A square of half width \a half across the z axis.
PictureMesh square(double z, double half, Rgba colour)
{
    PictureMesh result;
    result.mesh.vertices = {{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}};
    result.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    result.colour = colour;
    result.drawCreases = false;
    return result;
}

PictureLine line(const Vec3 &a, const Vec3 &b, double radius, Rgba colour)
{
    PictureLine result;
    result.points = {a, b};
    result.radius = radius;
    result.colour = colour;
    return result;
}

// Straight from the front, small, plain background.
PictureOptions front()
{
    PictureOptions options;
    options.width = 160;
    options.height = 120;
    options.azimuthDegrees = 0.0;
    options.elevationDegrees = 0.0;
    options.groundShadow = false;
    options.backgroundTop = options.backgroundBottom = {255, 255, 255, 255};
    return options;
}

bool isWhite(Rgba c)
{
    return c == Rgba{255, 255, 255, 255};
}

// The channel that leads, 0 red, 1 green, 2 blue; -1 where none leads clearly.
int leading(Rgba c)
{
    for (int k = 0; k < 3; ++k) {
        if (c[std::size_t(k)] > c[std::size_t((k + 1) % 3)] + 25 &&
            c[std::size_t(k)] > c[std::size_t((k + 2) % 3)] + 25)
            return k;
    }
    return -1;
}

Rgba centre(const Image &image)
{
    return image.at(image.width / 2, image.height / 2);
}

} // namespace

class SurfacePictureTest : public QObject
{
    Q_OBJECT
private slots:
    void aBallCoversTheDiscPerspectivePredicts();
    void everythingIsInTheFrame_data();
    void everythingIsInTheFrame();
    void sharedFramePointsGiveTheSameView();
    void theNearerMeshHidesTheFarther();
    void aTubeBehindAMeshIsHidden();
    void aFaintTubeShinesThroughFaintly();
    void aBuriedStrokeIsDrawnWhenItIsAllowedTo();
    void colourComesFromTriangleOrVertex();
    void zUpTurnsTheScene();
    void shadowDarkensTheGroundAndHollows();
    void creasesAreDarkLines();
    void brokenInputIsLeftOut();
    void sizeOfTheSceneDoesNotMatter();
    void emptySceneIsBackground();
    void sameSceneSameBytes();
};

void SurfacePictureTest::aBallCoversTheDiscPerspectivePredicts()
{
    PictureScene scene;
    PictureMesh mesh;
    mesh.mesh = ball(Vec3(3.0, -2.0, 5.0));
    mesh.drawCreases = false;
    scene.meshes = {mesh};
    PictureOptions options = front();
    options.width = 400;
    options.height = 300;
    const Image image = renderPicture(scene, options);
    int covered = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x)
            covered += isWhite(image.at(x, y)) ? 0 : 1;
    }
    // Framed by height: the outline touches the margin, so its radius is half of what is left.
    const double radius = 0.5 * 300 * (1.0 - 2.0 * options.margin);
    const double expected = std::numbers::pi * radius * radius;
    // Pixels cut by the outline count whole: about half a pixel more around.
    const double rim = std::numbers::pi * radius;
    QVERIFY2(std::abs(covered - expected - rim) < 0.01 * expected,
             qPrintable(QString("%1 pixels, expected %2 + %3").arg(covered).arg(expected).arg(rim)));
}

void SurfacePictureTest::everythingIsInTheFrame_data()
{
    QTest::addColumn<double>("azimuth");
    QTest::addColumn<double>("elevation");
    for (double azimuth : {0.0, 35.0, 170.0, 275.0}) {
        for (double elevation : {-90.0, -20.0, 25.0, 90.0})
            QTest::addRow("azimuth %g elevation %g", azimuth, elevation) << azimuth << elevation;
    }
}

void SurfacePictureTest::everythingIsInTheFrame()
{
    QFETCH(double, azimuth);
    QFETCH(double, elevation);
    PictureScene scene;
    PictureMesh mesh = square(0.0, 2.0, red);
    mesh.mesh.vertices.push_back({0.0, 0.5, 7.0});
    mesh.mesh.triangles.push_back({0, 1, 4});
    scene.meshes = {mesh};
    scene.lines = {line({-3, 2, 1}, {4, -1, 0}, 0.2, blue)};
    PictureOptions options = front();
    options.azimuthDegrees = azimuth;
    options.elevationDegrees = elevation;
    const Image image = renderPicture(scene, options);
    int left = image.width, right = -1, top = image.height, bottom = -1;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            if (!isWhite(image.at(x, y))) {
                left = std::min(left, x);
                right = std::max(right, x);
                top = std::min(top, y);
                bottom = std::max(bottom, y);
            }
        }
    }
    // Inside the margins, and touching them in one direction at least.
    const int marginX = int(options.margin * image.width), marginY = int(options.margin * image.height);
    QVERIFY(left >= marginX - 1 && right <= image.width - marginX);
    QVERIFY(top >= marginY - 1 && bottom <= image.height - marginY);
    const bool fills = (left <= marginX + 2 && right >= image.width - marginX - 3) ||
                       (top <= marginY + 2 && bottom >= image.height - marginY - 3);
    QVERIFY(fills);
}

void SurfacePictureTest::sharedFramePointsGiveTheSameView()
{
    // A small green square alone, and the same beside a large red one: the green pixels must be the same
    // ones.
    const PictureMesh small = square(0.5, 0.4, green), large = square(0.0, 2.0, red);
    PictureScene both, alone;
    both.meshes = {small, large};
    alone.meshes = {small};
    alone.alsoInFrame = large.mesh.vertices;
    alone.alsoInFrame.push_back(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
    const auto greenPixels = [](const Image &image) {
        std::vector<int> places;
        for (int i = 0; i < image.width * image.height; ++i) {
            if (leading(image.at(i % image.width, i / image.width)) == 1)
                places.push_back(i);
        }
        return places;
    };
    PictureOptions options = front();
    options.supersampling = 1; // no pixels of two colours
    const std::vector<int> places = greenPixels(renderPicture(alone, options));
    QVERIFY(places.size() > 100);
    QCOMPARE(greenPixels(renderPicture(both, options)), places);
}

void SurfacePictureTest::theNearerMeshHidesTheFarther()
{
    for (bool nearFirst : {true, false}) {
        PictureScene scene;
        scene.meshes = {square(0.0, 2.0, red), square(1.0, 1.0, green)};
        if (nearFirst)
            std::swap(scene.meshes[0], scene.meshes[1]);
        const Image image = renderPicture(scene, front());
        QCOMPARE(leading(centre(image)), 1);
        QCOMPARE(leading(image.at(80, 20)), 0);
        PictureOptions behind = front();
        behind.azimuthDegrees = 180.0;
        QCOMPARE(leading(centre(renderPicture(scene, behind))), 0);
    }
}

void SurfacePictureTest::aTubeBehindAMeshIsHidden()
{
    PictureScene scene;
    scene.meshes = {square(0.0, 1.0, red)};
    scene.lines = {line({-2, 0, -0.5}, {2, 0, -0.5}, 0.1, blue)};
    const Image image = renderPicture(scene, front());
    QCOMPARE(leading(centre(image)), 0);
    QCOMPARE(leading(image.at(20, 60)), 2); // beside the square
    scene.lines = {line({-2, 0, 0.5}, {2, 0, 0.5}, 0.1, blue)};
    QCOMPARE(leading(centre(renderPicture(scene, front()))), 2);
}

void SurfacePictureTest::aFaintTubeShinesThroughFaintly()
{
    PictureScene scene;
    scene.meshes = {square(0.0, 1.0, {220, 220, 220, 255})};
    scene.lines = {line({-2, 0, -0.5}, {2, 0, -0.5}, 0.1, blue)};
    const Rgba without = centre(renderPicture(scene, front()));
    scene.lines[0].faintWhenHidden = true;
    const Rgba with = centre(renderPicture(scene, front()));
    QVERIFY(with[0] + 5 < without[0]);
    QVERIFY(with[0] > 120); // still more surface than stroke
}

void SurfacePictureTest::aBuriedStrokeIsDrawnWhenItIsAllowedTo()
{
    PictureScene scene;
    scene.meshes = {square(0.0, 1.0, red)};
    scene.lines = {line({-2, 0, -0.2}, {2, 0, -0.2}, 0.1, blue)};
    scene.lines[0].visibleBehind = 0.05;
    QCOMPARE(leading(centre(renderPicture(scene, front()))), 0);
    scene.lines[0].visibleBehind = 0.15;
    QCOMPARE(leading(centre(renderPicture(scene, front()))), 2);
}

void SurfacePictureTest::colourComesFromTriangleOrVertex()
{
    PictureScene scene;
    scene.meshes = {square(0.0, 1.0, red)};
    scene.meshes[0].triangleColours = {green, blue}; // lower right, upper left
    Image image = renderPicture(scene, front());
    QCOMPARE(leading(image.at(110, 80)), 1);
    QCOMPARE(leading(image.at(50, 40)), 2);
    scene.meshes[0].vertexColours = {red, green, green, red};
    image = renderPicture(scene, front());
    QCOMPARE(leading(image.at(50, 60)), 0);
    QCOMPARE(leading(image.at(110, 60)), 1);
}

void SurfacePictureTest::zUpTurnsTheScene()
{
    // A red post up the z axis on a square across it: from the front it must stand.
    PictureScene scene;
    scene.lines = {line({0, 0, 0}, {0, 0, 2}, 0.1, red), line({-1, 0, 0}, {1, 0, 0}, 0.1, blue)};
    PictureOptions options = front();
    options.zUp = true;
    const Image image = renderPicture(scene, options);
    QCOMPARE(leading(image.at(80, 20)), 0);
    QCOMPARE(leading(image.at(60, 108)), 2);
}

void SurfacePictureTest::shadowDarkensTheGroundAndHollows()
{
    PictureScene scene;
    PictureMesh mesh;
    mesh.mesh = ball(Vec3::Zero(), 48);
    scene.meshes = {mesh};
    PictureOptions options = front();
    options.elevationDegrees = 30.0;
    options.groundShadow = true;
    const Image image = renderPicture(scene, options);
    int darkest = 255;
    for (int x = 0; x < image.width; ++x)
        darkest = std::min<int>(darkest, image.at(x, image.height - 5)[0]);
    QVERIFY(darkest < 235);
    QCOMPARE(image.at(0, 0)[0], std::uint8_t(255));

    // The same inner wall with and without a lid over it.
    PictureScene open;
    PictureMesh floor = square(0.0, 1.0, clayColour);
    for (Vec3 &v : floor.mesh.vertices)
        v = Vec3(v.x(), -1.0, -v.y());
    open.meshes = {floor, square(-1.0, 1.0, clayColour)};
    PictureScene covered = open;
    PictureMesh lid = floor;
    for (Vec3 &v : lid.mesh.vertices)
        v.y() = 1.0;
    covered.meshes.push_back(lid);
    const Rgba lit = centre(renderPicture(open, front()));
    const Rgba shaded = centre(renderPicture(covered, front()));
    QVERIFY2(shaded[1] + 15 < lit[1], qPrintable(QString("%1 against %2").arg(shaded[1]).arg(lit[1])));
    PictureOptions hard = front();
    hard.softLight = false;
    QVERIFY(std::abs(centre(renderPicture(open, hard))[1] - centre(renderPicture(covered, hard))[1]) <= 2);
}

void SurfacePictureTest::creasesAreDarkLines()
{
    // A roof: the ridge runs up the middle of the picture.
    PictureMesh roof;
    roof.mesh.vertices = {{-1, -1, 0}, {0, -1, 1}, {0, 1, 1}, {-1, 1, 0}, {1, -1, 0}, {1, 1, 0}};
    roof.mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}};
    PictureScene scene;
    scene.meshes = {roof};
    // The ridge against the darker of the two sides.
    const auto ridge = [](const Image &image) { return std::min(image.at(79, 60)[0], image.at(80, 60)[0]); };
    const auto sides = [](const Image &image) { return std::min(image.at(70, 60)[0], image.at(90, 60)[0]); };
    const Image with = renderPicture(scene, front());
    QVERIFY2(ridge(with) + 15 < sides(with), qPrintable(QString("%1 %2").arg(ridge(with)).arg(sides(with))));
    scene.meshes[0].drawCreases = false;
    const Image without = renderPicture(scene, front());
    QVERIFY(ridge(without) + 5 > sides(without));
}

void SurfacePictureTest::brokenInputIsLeftOut()
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    PictureScene scene;
    scene.meshes = {square(0.0, 1.0, red)};
    const Image clean = renderPicture(scene, front());
    TriangleMesh &mesh = scene.meshes[0].mesh;
    mesh.vertices.push_back({nan, 0, 0});
    mesh.vertices.push_back({0, inf, 0});
    mesh.vertices.push_back({0, 0, 1e300});
    mesh.triangles.push_back({0, 1, 4});
    mesh.triangles.push_back({0, 5, 1});
    mesh.triangles.push_back({0, 1, 6});
    mesh.triangles.push_back({0, 1, 99});
    mesh.triangles.push_back({-1, 1, 2});
    mesh.triangles.push_back({1, 1, 2});
    scene.lines = {line({nan, 0, 0}, {inf, 0, 0}, 0.1, blue), PictureLine()};
    QCOMPARE(renderPicture(scene, front()).pixels, clean.pixels);

    scene.lines = {line({-1, 0, 1}, {1, 0, 1}, nan, blue)};
    PictureOptions strange = front();
    strange.width = -7;
    strange.height = 0;
    strange.azimuthDegrees = inf;
    strange.elevationDegrees = nan;
    strange.margin = 3.0;
    strange.supersampling = -1;
    const Image image = renderPicture(scene, strange);
    QCOMPARE(image.width, 1);
    QCOMPARE(image.height, 1);
}

void SurfacePictureTest::sizeOfTheSceneDoesNotMatter()
{
    const auto draw = [](double scale) {
        PictureScene scene;
        PictureMesh mesh;
        mesh.mesh = ball(Vec3::Zero(), 24);
        for (Vec3 &v : mesh.mesh.vertices)
            v *= scale;
        scene.meshes = {mesh};
        scene.lines = {line(Vec3(-1.2, 0, 1) * scale, Vec3(1.2, 0, 1) * scale, 0.05 * scale, blue)};
        return renderPicture(scene, front()).pixels;
    };
    const auto reference = draw(1.0);
    QCOMPARE(draw(std::ldexp(1.0, 40)), reference); // powers of two change no digit
    QCOMPARE(draw(std::ldexp(1.0, -40)), reference);
}

void SurfacePictureTest::emptySceneIsBackground()
{
    PictureOptions options = front();
    options.groundShadow = true;
    options.backgroundTop = {10, 20, 30, 255};
    options.backgroundBottom = {200, 210, 220, 255};
    const Image image = renderPicture({}, options);
    const Rgba top = image.at(80, 0), bottom = image.at(80, 119);
    QCOMPARE(top, (Rgba{10, 20, 30, 255}));
    QCOMPARE(bottom, (Rgba{200, 210, 220, 255}));
    // A single point is a scene, too.
    PictureScene point;
    point.lines.resize(1);
    point.lines[0].points = {Vec3(5, 5, 5)};
    point.lines[0].radius = 0.5;
    point.lines[0].colour = red;
    QCOMPARE(leading(centre(renderPicture(point, front()))), 0);
}

void SurfacePictureTest::sameSceneSameBytes()
{
    PictureScene scene;
    PictureMesh mesh;
    mesh.mesh = ball(Vec3::Zero(), 40);
    scene.meshes = {mesh, square(-1.0, 2.0, green)};
    for (int i = 0; i < 10; ++i)
        scene.lines.push_back(line({-2, 0.2 * i, 1}, {2, 0.1 * i, 0.5}, 0.02, blue));
    PictureOptions options;
    options.width = 320;
    options.height = 240;
    const Image first = renderPicture(scene, options);
    for (int run = 0; run < 3; ++run)
        QCOMPARE(renderPicture(scene, options).pixels, first.pixels);
}

QTEST_APPLESS_MAIN(SurfacePictureTest)
#include "surface_picture_test.moc"
