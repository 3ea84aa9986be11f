// What the headset is given: both eyes' pictures are the renderer's own frames from there.
#include "layerpainter/vr/draw/eye_camera.h"
#include "layerpainter/vr/testing/headset_under_test.h"
#include "render/gl/offscreen_context.h"
#include "render/painting_renderer.h"

using namespace ductus;

namespace {

EyeView viewOf(const QString &line) // of the record
{
    QList<float> v;
    for (const QString &word : line.split(' ').mid(3))
        v << word.toFloat();
    return {{{v[3], v[4], v[5], v[6]}, {v[0], v[1], v[2]}}, {v[7], v[8], v[9], v[10]}};
}

struct Difference
{
    int pixels = 0, largest = 0;
};

Difference difference(const QImage &a, const Image &b)
{
    Difference found;
    for (int y = 0; y < b.height; ++y)
        for (int x = 0; x < b.width; ++x) {
            const QRgb p = a.pixel(x, y);
            const Rgba q = b.at(x, y);
            const int off =
                std::max({std::abs(qRed(p) - q[0]), std::abs(qGreen(p) - q[1]), std::abs(qBlue(p) - q[2])});
            found.pixels += off > 0;
            found.largest = std::max(found.largest, off);
        }
    return found;
}

} // namespace

class VrPicturesTest : public QObject
{
    Q_OBJECT
private slots:
    void eyesSeeTheRenderersFrames_data();
    void eyesSeeTheRenderersFrames();
    void panelsAreSeen();
};

void VrPicturesTest::eyesSeeTheRenderersFrames_data()
{
    QTest::addColumn<QString>("formats");
    QTest::addColumn<int>("allowed"); // of 255
    QTest::newRow("sRGB") << "formats 0x805B 0x881A 0x8C43 0x8058" << 0;
}

void VrPicturesTest::eyesSeeTheRenderersFrames()
{
    QFETCH(QString, formats);
    QFETCH(int, allowed);
    HeadsetUnderTest test({formats, "size 192 160", "tracked left 0", "tracked right 0", "stage 0"});
    test.window->openSample("forest-path");
    QVERIFY(test.wait([&] { return !test.window->painting().isEmpty(); }));
    QVERIFY(test.enter());
    const Painting painting = test.painting();
    const Placement placement = test.vr().tools().roomFromScene();
    QDir(test.folder.path()).mkdir("dump");
    test.say({"head 0.2 1.5 0.3 0 0.1305262 0 0.9914449", "dump " + test.folder.filePath("dump")});
    QVERIFY(test.frames(4));
    test.say({"dump off"});
    QVERIFY(test.frames(4));
    test.vr().stop();
    QVERIFY(test.wait([&] { return test.endings == 1; }));

    const QFileInfoList dumped =
        QDir(test.folder.filePath("dump")).entryInfoList({"*.png"}, QDir::Files, QDir::Time);
    QVERIFY(dumped.size() >= 2);
    const QString frame = dumped.first().fileName().section('-', 1, 1);
    if (QOpenGLContext *headset = QOpenGLContext::currentContext())
        headset->doneCurrent(); // a thread has one context
    Result<OffscreenContext> context = OffscreenContext::create();
    QVERIFY2(context.ok(), context ? "" : context.error().message().c_str());
    Result<PaintingRenderer> renderer = PaintingRenderer::create({1, false, 0.5, 0.25});
    QVERIFY(renderer.ok() && renderer->update(painting, {}).ok());
    QImage both[2];
    for (const int eye : {0, 1}) {
        const QStringList seen = test.record(QString("view %1 %2 ").arg(frame).arg(eye));
        QCOMPARE(seen.size(), 1);
        const QImage shown(test.folder.filePath(QString("dump/frame-%1-view-%2.png").arg(frame).arg(eye)));
        QCOMPARE(shown.size(), QSize(192, 160));
        const Result<Image> expected =
            renderer->image(sceneCamera(viewOf(seen.first()), placement), 192, 160);
        QVERIFY(expected.ok());
        const Difference off = difference(shown, *expected);
        qInfo("eye %d: %d pixels differ, by %d at most", eye, off.pixels, off.largest);
        QVERIFY(off.largest <= allowed);
        both[eye] = shown;
        if (const QString to = qEnvironmentVariable("DUCTUS_SHOTS"); !to.isEmpty())
            shown.save(QString("%1/eye-%2-%3.png").arg(to, QTest::currentDataTag()).arg(eye));
    }
    QVERIFY(both[0] != both[1]);
    QCOMPARE(test.record("error"), QStringList());
    QCOMPARE(test.complaints(), QString());
}

void VrPicturesTest::panelsAreSeen()
{
    HeadsetUnderTest test({"size 640 640"});
    test.window->openSample("forest-path");
    QVERIFY(test.wait([&] { return !test.window->painting().isEmpty(); }));
    QVERIFY(test.enter());
    QDir(test.folder.path()).mkdir("dump");
    test.put("left", {-0.12, 1.05, -0.45});
    QVERIFY(test.frames(3));
    test.pointAt(0, {120, 200});
    const auto dumped = [&](const QString &name) {
        test.say({"dump " + test.folder.filePath("dump")});
        test.frames(3);
        test.say({"dump off"});
        test.frames(3);
        const auto list =
            QDir(test.folder.filePath("dump")).entryInfoList({"*-view-0.png"}, QDir::Files, QDir::Time);
        const QImage image = list.isEmpty() ? QImage() : QImage(list.first().filePath());
        for (const QFileInfo &file : QDir(test.folder.filePath("dump")).entryInfoList(QDir::Files))
            QFile::remove(file.filePath());
        if (const QString to = qEnvironmentVariable("DUCTUS_SHOTS"); !to.isEmpty())
            image.save(to + '/' + name + ".png");
        return image;
    };
    const QImage with = dumped("vr-panels");
    test.shot("vr-mirror");
    test.click("left/input/y/click"); // hides them
    const QImage without = dumped("vr-alone");
    const auto differing = [](const QImage &a, const QImage &b) {
        int count = 0;
        for (int y = 0; y < a.height(); ++y)
            for (int x = 0; x < a.width(); ++x)
                count += a.pixel(x, y) != b.pixel(x, y);
        return double(count) / (double(a.width()) * a.height());
    };
    QVERIFY(!with.isNull() && with.size() == without.size());
    QVERIFY2(differing(with, without) > 0.05, qPrintable(QString::number(differing(with, without))));
}

QTEST_MAIN(VrPicturesTest)
#include "vr_pictures_test.moc"
