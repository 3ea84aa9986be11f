// Cameras and depth that were made elsewhere.
#include "doodling/reconstruction/given/given_cameras.h"
#include "doodling/reconstruction/given/given_depth.h"
#include "support/clip_scenes.h"

#include <QTemporaryDir>
#include <QtTest>

#include <cstring>
#include <fstream>

using namespace ductus;
namespace fs = std::filesystem;

namespace {

std::string npy(const std::string &kind, int width, int height, const std::vector<float> &values)
{
    std::string head = "{'descr': '" + kind + "', 'fortran_order': False, 'shape': (" +
                       std::to_string(height) + ", " + std::to_string(width) + "), }";
    head.resize(117, ' ');
    head += '\n';
    std::string bytes("\x93NUMPY\x01\x00", 8);
    bytes += char(head.size());
    bytes += '\0';
    bytes += head;
    for (float value : values) {
        char raw[8];
        const double wide = double(value);
        const auto whole = std::uint16_t(value);
        if (kind == "<f4")
            std::memcpy(raw, &value, 4);
        else if (kind == "<f8")
            std::memcpy(raw, &wide, 8);
        else
            std::memcpy(raw, &whole, 2);
        bytes.append(raw, kind == "<f4" ? 4 : kind == "<f8" ? 8 : 2);
    }
    return bytes;
}

void write(const fs::path &path, const std::string &bytes)
{
    std::ofstream(path, std::ios::binary) << bytes;
}

QString problemOf(const Error &error)
{
    return QString::fromStdString(error.message());
}

} // namespace

class GivenTest : public QObject
{
    Q_OBJECT
private slots:
    void npyNumbersAreRead()
    {
        const std::vector<float> values{1.0f, 2.0f, 3.0f, 65535.0f, 0.0f, 6.0f};
        for (const char *kind : {"<f4", "<f8", "<u2"}) {
            const auto depth = parseNpy(npy(kind, 3, 2, values), "a.npy");
            QVERIFY2(depth.ok(), kind);
            QCOMPARE(depth->width, 3);
            QCOMPARE(depth->height, 2);
            QCOMPARE(depth->depths[5], 6.0f);
            QCOMPARE(depth->depths[4], 0.0f);
            // Only in whole numbers 65535 means that nothing is known.
            QCOMPARE(depth->depths[3], kind == std::string("<u2") ? 0.0f : 65535.0f);
        }
    }
    void npyThatIsNoneIsRefused()
    {
        const std::string good = npy("<f4", 3, 2, {1, 2, 3, 4, 5, 6});
        for (std::size_t length = 0; length < good.size(); ++length)
            QVERIFY(!parseNpy(good.substr(0, length), "a.npy").ok());
        for (auto [from, to] :
             {std::pair{"False", "True "}, std::pair{"<f4", "<c8"}, std::pair{"(2, 3)", "(2,3,1)"},
              std::pair{"(2, 3)", "(-2,3)"}, std::pair{"NUMPY", "LUMPY"}}) {
            std::string bad = good;
            bad.replace(bad.find(from), std::strlen(from), to);
            QVERIFY2(!parseNpy(bad, "a.npy").ok(), from);
        }
    }
    void depthComesToTheScaleOfTheScene()
    {
        const ClipScene scene = passingScene(160, 96, 3);
        Shot shot = trueShot(scene);
        QTemporaryDir folder;
        const fs::path root(folder.path().toStdString());
        for (int t = 0; t < 3; ++t) {
            std::vector<float> millimetres; // of half the size, with a hole
            for (int y = 0; y < 48; ++y)
                for (int x = 0; x < 80; ++x)
                    millimetres.push_back(
                        x > 60 && x < 70 && y < 6
                            ? 0.0f
                            : float(1000.0 * shot.depthAt(t, {2.0 * x + 1.0, 2.0 * y + 1.0})));
            write(root / ("depth" + std::to_string(t) + ".npy"), npy("<f4", 80, 48, millimetres));
        }
        const auto files = depthFiles(root, 3);
        QVERIFY(files.ok());
        const auto given = withGivenDepth(shot, *files, {});
        QVERIFY2(given.ok(), given.ok() ? "" : qPrintable(problemOf(given.error())));
        QVERIFY(given->isDepthGiven);
        int good = 0, all = 0;
        for (int y = 4; y < 96; y += 8)
            for (int x = 4; x < 160; x += 8, ++all)
                good += std::abs(given->depthAt(1, Vec2(x, y)) / shot.depthAt(1, Vec2(x, y)) - 1.0) < 0.03;
        QVERIFY2(good > 0.9 * all, qPrintable(QString("%1 of %2").arg(good).arg(all)));
        QVERIFY(given->depths[1].objects == shot.depths[1].objects);
        // One is missing, or is of another shape.
        QVERIFY(!depthFiles(root, 4).ok());
        write(root / "depth1.npy", npy("<f4", 40, 48, std::vector<float>(40 * 48, 1.0f)));
        QVERIFY(!withGivenDepth(shot, *files, {}).ok());
        write(root / "depth1.npy", npy("<f4", 80, 48, std::vector<float>(80 * 48, 0.0f)));
        QVERIFY(!withGivenDepth(shot, *files, {}).ok());
    }
    void camerasAreReadAndPutInBetween()
    {
        const std::string text = R"({"width": 960, "height": 540, "cameras": [
            {"frame": 0, "position": [0, 0, 0], "rotation": [0, 0, 0, 1], "focal": 800},
            {"frame": 2, "position": [2, 0, 4], "rotation": [0, 0, 0, 1], "focal": 900, "centre": [470, 270]}]})";
        const auto given = parseCameraJson(text, "c.json", 4, 1920, 1080);
        QVERIFY2(given.ok(), given.ok() ? "" : qPrintable(problemOf(given.error())));
        QCOMPARE(int(given->cameras.size()), 4);
        QCOMPARE(given->cameras[0].focal, 1600.0);
        QCOMPARE(given->cameras[0].centre, Vec2(960, 540));
        QVERIFY((given->cameras[1].position() - Vec3(1, 0, 2)).norm() < 1e-12);
        QCOMPARE(given->cameras[1].focal, 1700.0);
        QCOMPARE(given->cameras[3].centre, Vec2(940, 540)); // the last one stays
        QCOMPARE(int(given->warnings.size()), 1);
    }
    void wrongCamerasAreTold_data()
    {
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("to");
        QTest::newRow("no json") << "{\"width\""
                                 << "\"width\"";
        QTest::newRow("size") << "540"
                              << "960";
        QTest::newRow("frame") << "\"frame\": 0"
                               << "\"frame\": 9";
        QTest::newRow("half a frame") << "\"frame\": 0"
                                      << "\"frame\": 0.5";
        QTest::newRow("focal") << "800"
                               << "0";
        QTest::newRow("position") << "[7, 0, 0]"
                                  << "[7, 0]";
        QTest::newRow("rotation") << "[0, 0, 0, 1]"
                                  << "[0, 0, 0, 0]";
        QTest::newRow("list") << "cameras"
                              << "lenses";
    }
    void wrongCamerasAreTold()
    {
        QFETCH(QString, from);
        QFETCH(QString, to);
        const QString good = R"({"width": 960, "height": 540, "cameras": [
            {"frame": 0, "position": [7, 0, 0], "rotation": [0, 0, 0, 1], "focal": 800}]})";
        QVERIFY(parseCameraJson(good.toStdString(), "c.json", 2, 960, 540).ok());
        QString bad = good;
        bad.replace(from, to);
        const auto given = parseCameraJson(bad.toStdString(), "c.json", 2, 960, 540);
        QVERIFY(!given.ok());
        QVERIFY(given.error().place.starts_with("c.json"));
    }
    void colmapsTextIsRead()
    {
        const std::string cameras = "# Camera list\n1 SIMPLE_RADIAL 960 540 800 480 270 0.01\n";
        // Turned by 90 degrees about y, standing at (0, 0, 5): t = -R c.
        const std::string images = "# Image list\n"
                                   "2 0.70710678118654752 0 0.70710678118654752 0 -5 0 0 1 b.png\n"
                                   "10 10 1 20 20 2\n"
                                   "1 1 0 0 0 0 0 0 1 a.png\n"
                                   "\n";
        const auto given = parseColmap(cameras, images, "model", 2, 1920, 1080);
        QVERIFY2(given.ok(), given.ok() ? "" : qPrintable(problemOf(given.error())));
        QVERIFY(given->cameras[0].position().norm() < 1e-12); // in the order of names
        QVERIFY((given->cameras[1].position() - Vec3(0, 0, 5)).norm() < 1e-9);
        QCOMPARE(given->cameras[1].focal, 1600.0);
        QCOMPARE(int(given->warnings.size()), 1); // the lens is distorted
        QCOMPARE(parseColmap(cameras, images, "model", 3, 1920, 1080).error().code, ErrorCode::TooLittleData);
        QVERIFY(!parseColmap("1 FISHEYE 960 540 1\n", images, "model", 2, 1920, 1080).ok());
        QVERIFY(!parseColmap(cameras, "1 1 0 0 x 0 0 0 1 a.png\n\n", "model", 1, 1920, 1080).ok());
        QVERIFY(!parseColmap("", images, "model", 2, 1920, 1080).ok());
    }
    void givenCamerasAreUsed()
    {
        const ClipScene scene = passingScene(192, 108, 12);
        ShotOptions options;
        for (int t = 0; t < 12; ++t)
            options.givenCameras.push_back(scene.camera(t));
        const auto shot = reconstructShot(*clipOf(scene), options, {});
        QVERIFY(shot.ok());
        QCOMPARE(shot->knowledge, CameraKnowledge::SolvedCameras);
        // The unit is that of the cameras: depth needs no factor.
        const ClipTruth truth = renderedFrame(scene, 6);
        std::vector<double> misses;
        for (int y = 2; y < 108; y += 4)
            for (int x = 2; x < 192; x += 4) {
                const std::size_t i = std::size_t(y * 192 + x);
                if (!scene.bodies[std::size_t(truth.bodies[i])].worldFromBody)
                    misses.push_back(
                        std::abs(shot->depthAt(6, Vec2(x + 0.5, y + 0.5)) / double(truth.depths[i]) - 1.0));
            }
        std::nth_element(misses.begin(), misses.begin() + std::ptrdiff_t(misses.size() / 2), misses.end());
        const double miss = misses[misses.size() / 2];
        QVERIFY2(miss < 0.05, qPrintable(QString::number(miss)));
        QVERIFY((shot->cameras[11].position() - scene.camera(11).position()).norm() < 1e-9);
    }
};

QTEST_APPLESS_MAIN(GivenTest)
#include "given_test.moc"
