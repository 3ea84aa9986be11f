// "My sketch became a surface, I painted it in two looks and stood it in a clip; then I changed the sketch":
// the links offer the change from app to app, and the film changes where the painting stands and nowhere
// else.
#include "formats/png_file.h"
#include "journeys/sketch_journey.h"
#include "painting/action/action.h"
#include "painting/storage/painting_content.h"
#include "project/project_reader.h"
#include "project/saving/project_save.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <cstring>

using namespace ductus;

namespace {

constexpr int width = 192, height = 112, frames = 4;
constexpr int nearFrom = 120; // what is filmed from this column on is near

// A tent of four walls over a rectangle, by its edges and lines across.
QByteArray tent(double high)
{
    std::vector<std::vector<Vec3>> strokes;
    const auto add = [&](const Vec3 &a, const Vec3 &b) {
        std::vector<Vec3> &stroke = strokes.emplace_back();
        for (int i = 0; i <= 24; ++i)
            stroke.push_back(a + (b - a) * (i / 24.0));
    };
    const Vec3 corners[] = {{-1, 0, -0.7}, {1, 0, -0.7}, {1, 0, 0.7}, {-1, 0, 0.7}};
    const Vec3 top(0, high, 0);
    for (int i = 0; i < 4; ++i) {
        const Vec3 &a = corners[i], &b = corners[(i + 1) % 4];
        add(a, b);
        add(a, top);
        for (const double share : {0.3, 0.6})
            add(a + share * (top - a), b + share * (top - b));
    }
    return curves(strokes);
}

// Little-endian 32-bit floats, rows first.
QByteArray npy()
{
    QByteArray header = "{'descr': '<f4', 'fortran_order': False, 'shape': (" + QByteArray::number(height) +
                        ", " + QByteArray::number(width) + "), }";
    while ((10 + header.size() + 1) % 64 != 0)
        header += ' ';
    header += '\n';
    QByteArray bytes("\x93NUMPY\x01\x00", 8);
    bytes += char(header.size() & 255);
    bytes += char(header.size() >> 8);
    bytes += header;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float depth = x >= nearFrom ? 2.0f : 10.0f;
            char four[4];
            std::memcpy(four, &depth, 4);
            bytes.append(four, 4);
        }
    return bytes;
}

Image filmed()
{
    Image image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::uint8_t grain = std::uint8_t((x * 7 + y * 13) % 24);
            const auto shade = [&](int v) { return std::uint8_t(v + grain); };
            image.set(x, y,
                      x >= nearFrom ? Rgba{shade(170), shade(90), shade(40), 255}
                                    : Rgba{shade(90), shade(120), shade(150), 255});
        }
    return image;
}

bool areEqual(const std::vector<Image> &a, const std::vector<Image> &b)
{
    return std::ranges::equal(a, b, [](const Image &p, const Image &q) { return p.pixels == q.pixels; });
}

bool isBlue(const Rgba &c)
{
    return c[2] > c[0] + 60 && c[2] > c[1] + 20;
}

} // namespace

class SketchToFilmTest : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void theFilmShowsThePaintingBehindWhatIsNear();
    void twoLooksAreTwoFilms();
    void nothingIsOfferedWhileNothingChanged();
    void aChangedSketchIsOfferedAndChangesTheFilm();

private:
    QString file(const QString &name) const { return mFolder.filePath(name); }
    void surface(double high);
    void paint();
    QJsonObject links(const QString &program, const QStringList &arguments);
    std::vector<Image> film(const QString &project, const QString &what = "composite");

    QTemporaryDir mFolder;
};

#define RUN(program, ...)                                                                                    \
    do {                                                                                                     \
        const ProgramRun run = runProgram(QStringLiteral(program), QStringList __VA_ARGS__);                 \
        QVERIFY2(run.exitCode == 0, run.told().constData());                                                 \
    } while (false)

void SketchToFilmTest::surface(double high)
{
    QVERIFY(writeBytes(file("tent.curves"), tent(high)));
    const ProgramRun run = runSketchSurfacer(surfaceArguments(
        file("tent.curves"), file("sketch.ductus"), {"--runs", "1", "--proxy-vertices", "800", "-q"}));
    QVERIFY2(run.exitCode == 0, run.told().constData());
}

// A day as the clay is, and a night with a blue layer over it.
void SketchToFilmTest::paint()
{
    ProjectReadOptions options;
    options.kinds = {paintingKind()};
    const std::filesystem::path path = file("painting.ductus").toStdString();
    Result<Project> project = openProject(path, options);
    QVERIFY2(project.ok(), project ? "" : project.error().message().c_str());
    Painting painting = (*paintingOf(project->documents[0]))->painting();
    const auto perform = [&](const PaintingAction &action) {
        Result<PerformedAction> done = performed(painting, action);
        if (!done)
            qFatal("%s", done.error().message().c_str());
        painting = done->painting;
        return done->made;
    };
    perform(act::AddLook{"day"});
    const LayerId layer{perform(act::AddLayer{painting.stacks[0].id, "night", -1})[0]};
    StrokeShape all; // one huge stroke around everything
    for (const float x : {-1.f, 1.f}) {
        PaintedPoint point;
        point.position = {x, 0, 0};
        point.halfWidth = 20;
        point.colour = {0.02f, 0.05f, 0.6f};
        all.points.push_back(point);
    }
    perform(act::Draw{layer, 0, {}, {std::make_shared<const ElementShape>(all)}});
    perform(act::AddLook{"night"});
    act::SetProperties hide;
    hide.layer = layer;
    hide.visible = false;
    perform(hide);
    project->documents[0].content =
        std::make_shared<const PaintingContent>(painting, UnknownPaintingMembers());
    QVERIFY(saveProject(*project, path).ok());
}

QJsonObject SketchToFilmTest::links(const QString &program, const QStringList &arguments)
{
    const ProgramRun run =
        runProgram(program, QStringList{"update"} + arguments + QStringList{"--json", "-q"});
    if (run.exitCode != 0)
        qWarning("%s", run.told().constData());
    return QJsonDocument::fromJson(run.out.toUtf8()).object();
}

std::vector<Image> SketchToFilmTest::film(const QString &project, const QString &what)
{
    const QString folder = file("film-" + QFileInfo(project).baseName() + "-" + what);
    const ProgramRun run = runProgram(QStringLiteral(DUCTUS_DOODLESTUDIO),
                                      {"export", project, "-o", folder + "/", "--what", what, "-q"});
    if (run.exitCode != 0)
        qWarning("%s", run.told().constData());
    std::vector<Image> images;
    for (const QString &name : QDir(folder).entryList({"*.png"}, QDir::Files, QDir::Name)) {
        const Result<Image> image = readPng(QDir(folder).filePath(name).toStdString());
        images.push_back(image ? *image : Image());
    }
    QDir(folder).removeRecursively();
    return images;
}

void SketchToFilmTest::initTestCase()
{
    qputenv("XDG_CACHE_HOME", file("cache").toUtf8());
    surface(1.2);
    RUN(DUCTUS_LAYERPAINTER, ({"import", file("sketch.ductus"), "-q", "-o", file("painting.ductus")}));
    paint();
    QDir(mFolder.path()).mkpath("clip");
    QDir(mFolder.path()).mkpath("depth");
    QJsonArray cameras;
    for (int t = 0; t < frames; ++t) {
        const QString number = QStringLiteral("%1").arg(t, 4, 10, QLatin1Char('0'));
        QVERIFY(writePng(filmed(), file("clip/" + number + ".png").toStdString()).ok());
        QVERIFY(writeBytes(file("depth/" + number + ".npy"), npy()));
        cameras << QJsonObject{{"frame", t},
                               {"position", QJsonArray{0, 0, 0}},
                               {"rotation", QJsonArray{0, 0, 0, 1}},
                               {"focal", 180}};
    }
    QVERIFY(writeBytes(
        file("cameras.json"),
        QJsonDocument(QJsonObject{{"width", width}, {"height", height}, {"cameras", cameras}}).toJson()));
    RUN(DUCTUS_DOODLESTUDIO, ({"analyse", file("clip"), "-q", "-o", file("clip.ductus"), "--cameras",
                               file("cameras.json"), "--depth", file("depth")}));
    for (const QString look : {"day", "night"})
        RUN(DUCTUS_DOODLESTUDIO, ({"place", file("clip.ductus"), file("painting.ductus"), "-q", "--look",
                                   look, "--box", "0,60,20,80,70", "-o", file(look + ".ductus")}));
}

void SketchToFilmTest::theFilmShowsThePaintingBehindWhatIsNear()
{
    const std::vector<Image> images = film(file("night.ductus")),
                             alone = film(file("night.ductus"), "doodle");
    QCOMPARE(int(images.size()), frames);
    QCOMPARE(int(alone.size()), frames);
    if (const QString to = qEnvironmentVariable("DUCTUS_SHOTS"); !to.isEmpty()) // to look at
        QVERIFY(writePng(images[0], (to + "/film-night.png").toStdString()).ok());
    const Image before = filmed();
    int blue = 0, hidden = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            blue += isBlue(images[0].at(x, y)) ? 1 : 0;
            if (x > nearFrom + 6) { // some pixels of softness at the silhouette
                QCOMPARE(images[0].at(x, y), before.at(x, y));
                hidden += 1;
            }
            if (alone[0].at(x, y)[3] == 0)
                QCOMPARE(images[0].at(x, y), before.at(x, y));
        }
    QVERIFY2(blue > 500, QByteArray::number(blue).constData());
    QVERIFY(hidden > 0);
}

void SketchToFilmTest::twoLooksAreTwoFilms()
{
    const std::vector<Image> day = film(file("day.ductus")), night = film(file("night.ductus"));
    int different = 0, blueByDay = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            different += day[0].at(x, y) != night[0].at(x, y) ? 1 : 0;
            blueByDay += x > 64 && x < nearFrom && isBlue(day[0].at(x, y)) ? 1 : 0;
        }
    QVERIFY(different > 500);
    QVERIFY(blueByDay < 50); // the filmed wall's blue is fainter
}

void SketchToFilmTest::nothingIsOfferedWhileNothingChanged()
{
    const QJsonObject painted = links(DUCTUS_LAYERPAINTER, {file("painting.ductus"), "--check"});
    QCOMPARE(painted["links"][0]["state"].toString(), "unchanged");
    QCOMPARE(painted["links"][0]["file"].toString(), "sketch.ductus");
    const QJsonObject placed = links(DUCTUS_DOODLESTUDIO, {file("night.ductus"), "--check"});
    QCOMPARE(placed["links"][0]["state"].toString(), "unchanged");
    QCOMPARE(placed["links"].toArray().size(), 1);
}

void SketchToFilmTest::aChangedSketchIsOfferedAndChangesTheFilm()
{
    const std::vector<Image> before = film(file("night.ductus")),
                             maskBefore = film(file("night.ductus"), "doodle");
    surface(0.7);
    // From the sketch to the painting; the film does not change yet.
    QCOMPARE(links(DUCTUS_LAYERPAINTER, {file("painting.ductus"), "--check"})["links"][0]["state"].toString(),
             "changed");
    const QJsonObject painted = links(DUCTUS_LAYERPAINTER, {file("painting.ductus")});
    QVERIFY(painted["updated"].toBool());
    QCOMPARE(links(DUCTUS_LAYERPAINTER, {file("painting.ductus"), "--check"})["links"][0]["state"].toString(),
             "unchanged");
    QVERIFY(areEqual(film(file("night.ductus")), before));
    // From the painting to the film: layers and looks were kept on the way, so the tent is still blue.
    QCOMPARE(links(DUCTUS_DOODLESTUDIO, {file("night.ductus"), "--check"})["links"][0]["state"].toString(),
             "changed");
    QVERIFY(links(DUCTUS_DOODLESTUDIO, {file("night.ductus")})["updated"].toBool());
    const std::vector<Image> after = film(file("night.ductus")),
                             maskAfter = film(file("night.ductus"), "doodle");
    if (const QString to = qEnvironmentVariable("DUCTUS_SHOTS"); !to.isEmpty())
        QVERIFY(writePng(after[0], (to + "/film-night-updated.png").toStdString()).ok());
    int changed = 0, blue = 0;
    for (int t = 0; t < frames; ++t)
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const std::size_t i = std::size_t(t);
                const bool isDifferent = after[i].at(x, y) != before[i].at(x, y);
                changed += isDifferent ? 1 : 0;
                blue += isBlue(after[i].at(x, y)) ? 1 : 0;
                if (isDifferent)
                    QVERIFY(maskBefore[i].at(x, y)[3] > 0 || maskAfter[i].at(x, y)[3] > 0);
            }
    QVERIFY2(changed > 400, QByteArray::number(changed).constData());
    QVERIFY2(blue > 1000, QByteArray::number(blue).constData());
}

QTEST_GUILESS_MAIN(SketchToFilmTest)
#include "sketch_to_film_test.moc"
