#include "doodling/compositing/coverage.h"

#include <QtTest>
#include <numeric>

using namespace ductus;

namespace {

// One canvas unit is a pixel, and 0, 0 the picture's corner.
CanvasView flatView()
{
    ShotCamera camera;
    CanvasFrame place;
    place.position = Vec3(0.0, 0.0, 1.0);
    return CanvasView(camera, place);
}

CanvasView turnedView(double degrees)
{
    ShotCamera camera;
    camera.focal = 100.0;
    camera.centre = Vec2(100.0, 100.0);
    CanvasFrame place;
    place.position = Vec3(0.0, 0.0, 4.0);
    place.worldFromCanvas = Eigen::AngleAxisd(degrees * M_PI / 180.0, Vec3::UnitY());
    return CanvasView(camera, place);
}

constexpr PixelBox page{0, 0, 200, 200};

double share(const Coverage &coverage, int x, int y)
{
    const PixelBox &box = coverage.box;
    if (x < box.left || y < box.top || x >= box.right || y >= box.bottom)
        return 0.0;
    return coverage.shares[std::size_t(y - box.top) * std::size_t(box.width()) + std::size_t(x - box.left)];
}

double total(const Coverage &coverage)
{
    return std::accumulate(coverage.shares.begin(), coverage.shares.end(), 0.0);
}

LinePiece lineOf(const Outline &points, double radius)
{
    return {{{points, std::vector<double>(points.size(), radius)}}, {0, 0, 0, 255}};
}

bool isNear(double a, double b, double tolerance = 1e-5)
{
    return std::abs(a - b) < tolerance;
}

} // namespace

class CoverageTest : public QObject
{
    Q_OBJECT
private slots:
    void areasCoverSharesOfPixels()
    {
        const Coverage box =
            areaCoverage({{{{2.25, 3.0}, {5.5, 3.0}, {5.5, 6.5}, {2.25, 6.5}}}, {}}, flatView(), page);
        QVERIFY(isNear(share(box, 2, 4), 0.75));
        QVERIFY(isNear(share(box, 3, 4), 1.0));
        QVERIFY(isNear(share(box, 5, 4), 0.5));
        QVERIFY(isNear(share(box, 5, 6), 0.25));
        QVERIFY(isNear(share(box, 6, 4), 0.0));
        QVERIFY(isNear(total(box), 3.25 * 3.5, 1e-4));
    }
    void slantedEdgesAreExact()
    {
        // A triangle's area, and the pixel on its diagonal half covered.
        const Coverage triangle = areaCoverage({{{{10, 10}, {30, 10}, {10, 30}}}, {}}, flatView(), page);
        QVERIFY(isNear(total(triangle), 200.0, 1e-3));
        QVERIFY(isNear(share(triangle, 19, 20), 0.5));
        const Coverage shallow = areaCoverage({{{{10, 10.2}, {90, 17.9}, {10, 30}}}, {}}, flatView(), page);
        QVERIFY(isNear(total(shallow), 0.5 * 80.0 * 19.8, 2e-2));
    }
    void windingFillsBothLobesOnceAndHolesStayOpen()
    {
        const Outline eight = {{10, 10}, {30, 30}, {30, 10}, {10, 30}};
        QVERIFY(isNear(total(areaCoverage({{eight}, {}}, flatView(), page)), 200.0, 0.6));
        const Outline outer = {{10, 10}, {30, 10}, {30, 30}, {10, 30}};
        const Outline hole = {{15, 15}, {15, 25}, {25, 25}, {25, 15}};
        const Coverage ring = areaCoverage({{outer, hole}, {}}, flatView(), page);
        QVERIFY(isNear(total(ring), 300.0, 1e-3));
        QVERIFY(isNear(share(ring, 20, 20), 0.0));
        // Twice round is still once covered.
        QVERIFY(isNear(total(areaCoverage({{outer, outer}, {}}, flatView(), page)), 400.0, 1e-3));
    }
    void whatReachesBeyondThePageIsCut()
    {
        const Coverage big =
            areaCoverage({{{{-50, -50}, {500, -50}, {500, 500}, {-50, 500}}}, {}}, flatView(), page);
        QVERIFY(isNear(total(big), 40000.0, 0.1));
        QVERIFY(areaCoverage({{{{300, 300}, {400, 300}, {400, 400}}}, {}}, flatView(), page).box.isEmpty());
    }
    void linesAreAsWideAsTheyAre()
    {
        const Coverage line = lineCoverage(lineOf({{20, 50}, {60, 50}}, 3.0), flatView(), page);
        QVERIFY(isNear(share(line, 40, 49), 1.0));
        QVERIFY(isNear(share(line, 40, 46), 0.0));
        QVERIFY(isNear(share(line, 40, 47), 1.0));
        double column = 0.0;
        for (int y = 40; y < 60; ++y)
            column += share(line, 40, y);
        QVERIFY(isNear(column, 6.0, 1e-4));
        QVERIFY(isNear(total(line), 40.0 * 6.0 + M_PI * 9.0, 0.5)); // with round ends
        const Coverage thin = lineCoverage(lineOf({{20, 50.5}, {60, 50.5}}, 0.2), flatView(), page);
        QVERIFY(isNear(share(thin, 40, 50), 0.4));
        const Coverage dot = lineCoverage(lineOf({{50, 50}}, 5.0), flatView(), page);
        QVERIFY(isNear(total(dot), M_PI * 25.0, 0.8));
    }
    void crossingLinesAreNotDarker()
    {
        LinePiece cross = lineOf({{20, 50}, {80, 50}}, 3.0);
        cross.lines.push_back(lineOf({{50, 20}, {50, 80}}, 3.0).lines[0]);
        const Coverage coverage = lineCoverage(cross, flatView(), page);
        for (float value : coverage.shares)
            QVERIFY(value <= 1.0f);
        QVERIFY(isNear(total(coverage), 2 * 60 * 6.0 - 36.0 + 2 * M_PI * 9.0, 1.0));
    }
    void brushesAreSeenInPerspective()
    {
        // A dot on a sheet turned by 60 degrees is an ellipse half as wide as high, and the near half wider.
        const Coverage dot = lineCoverage(lineOf({{0, 0}}, 1.0), turnedView(60.0), page);
        double row = 0.0, column = 0.0;
        for (int i = 0; i < 200; ++i) {
            row += share(dot, i, 100);
            column += share(dot, 100, i);
        }
        QVERIFY2(isNear(row, 26.2, 0.5), qPrintable(QString::number(row)));
        QVERIFY2(isNear(column, 50.0, 0.7), qPrintable(QString::number(column)));
        // The same shape as an area and as a line, across a strongly turned sheet.
        Outline band = {{-2.0, -0.25}, {2.0, -0.25}, {2.0, 0.25}, {-2.0, 0.25}};
        const Coverage area = areaCoverage({{band}, {}}, turnedView(50.0), page);
        const Coverage line = lineCoverage(lineOf({{-2.0, 0.0}, {2.0, 0.0}}, 0.25), turnedView(50.0), page);
        for (int x = 80; x < 140; ++x)
            for (int y = 80; y < 120; ++y)
                QVERIFY2(
                    isNear(share(area, x, y), share(line, x, y), 0.12),
                    qPrintable(
                        QString("%1 %2: %3 %4").arg(x).arg(y).arg(share(area, x, y)).arg(share(line, x, y))));
    }
    void whatIsBehindTheCameraIsCutOff()
    {
        // A path on the floor that begins behind the camera.
        ShotCamera camera;
        camera.focal = 100.0;
        camera.centre = Vec2(100.0, 60.0);
        CanvasFrame place;
        place.position = Vec3(0.0, 1.0, 3.0);
        place.worldFromCanvas = Eigen::AngleAxisd(-M_PI / 2.0, Vec3::UnitX());
        const CanvasView view(camera, place);
        const Coverage path =
            areaCoverage({{{{-0.5, -20.0}, {0.5, -20.0}, {0.5, 20.0}, {-0.5, 20.0}}}, {}}, view, page);
        const Coverage line = lineCoverage(lineOf({{0.0, -20.0}, {0.0, 20.0}}, 0.5), view, page);
        for (int y = 80; y < 200; y += 20) {
            double width = 0.0, lineWidth = 0.0;
            for (int x = 0; x < 200; ++x) {
                width += share(path, x, y);
                lineWidth += share(line, x, y);
            }
            const double expected =
                y + 0.5 - 60.0; // one unit below the camera: as wide as far below the horizon
            QVERIFY2(isNear(width, expected, 0.1), qPrintable(QString("row %1: %2").arg(y).arg(width)));
            QVERIFY2(isNear(lineWidth, expected, 0.08 * expected + 0.5),
                     qPrintable(QString("row %1: line %2").arg(y).arg(lineWidth)));
        }
        QVERIFY(isNear(share(path, 100, 40), 0.0));
    }
};

QTEST_APPLESS_MAIN(CoverageTest)
#include "coverage_test.moc"
