#include "document/settings/settings.h"

#include "document/settings/pressure_curve.h"
#include "document/settings/recent_files.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

using namespace ductus;

namespace {

const Setting<double> width{"view/width", 1.5};
const Setting<bool> isOn{"view/on", true};
const Setting<QStringList> names{"view/names", {"a"}};

} // namespace

class SettingsTest : public QObject
{
    Q_OBJECT
private slots:
    void valuesComeBackInTheNextRun();
    void nonsenseInTheFileGivesTheFallback();
    void changesAreToldOnce();
    void recentFilesAreNewestFirst();
    void recentFilesKnowWhatIsMissing();
    void recentPicturesFollowTheirFiles();
    void pressureGoesStraightByDefault();
    void pressureNeverFalls();
    void pressureTextComesBack();
    void pressurePointsKeepTheirPlace();
};

void SettingsTest::valuesComeBackInTheNextRun()
{
    QTemporaryDir dir;
    {
        Settings settings(dir.filePath("s.ini"));
        QCOMPARE(settings.value(width), 1.5);
        settings.set(width, 2.25);
        settings.set(isOn, false);
        settings.set(names, {"x, y", "\u00e4"});
        QVERIFY(settings.sync());
    }
    Settings settings(dir.filePath("s.ini"));
    QCOMPARE(settings.value(width), 2.25);
    QCOMPARE(settings.value(isOn), false);
    QCOMPARE(settings.value(names), (QStringList{"x, y", "\u00e4"}));
    settings.reset(width);
    QCOMPARE(settings.value(width), 1.5);
    QCOMPARE(settings.keysIn("view"), (QStringList{"names", "on"}));
}

void SettingsTest::nonsenseInTheFileGivesTheFallback()
{
    QTemporaryDir dir;
    Settings settings(dir.filePath("s.ini"));
    settings.setRaw("view/width", "wide");
    QCOMPARE(settings.value(width), 1.5);
}

void SettingsTest::changesAreToldOnce()
{
    QTemporaryDir dir;
    Settings settings(dir.filePath("s.ini"));
    QSignalSpy changed(&settings, &Settings::changed);
    settings.set(width, 2.0);
    settings.set(width, 2.0);
    QCOMPARE(changed.count(), 1);
    QCOMPARE(changed[0][0].toString(), QString("view/width"));
    settings.reset(width);
    settings.reset(width);
    QCOMPARE(changed.count(), 2);
}

void SettingsTest::recentFilesAreNewestFirst()
{
    QTemporaryDir dir;
    Settings settings(dir.filePath("s.ini"));
    RecentFiles recent(settings, dir.filePath("pictures"));
    for (int i = 0; i < 20; ++i)
        recent.add(QString("/x/%1.ductus").arg(i));
    recent.add("/x/10.ductus");
    QCOMPARE(recent.paths().size(), int(RecentFiles::mostFiles));
    QCOMPARE(recent.paths().first(), QString("/x/10.ductus"));
    QCOMPARE(recent.paths()[1], QString("/x/19.ductus"));
    QCOMPARE(recent.paths().count("/x/10.ductus"), 1);
    RecentFiles next(settings, dir.filePath("pictures"));
    QCOMPARE(next.paths(), recent.paths());
    recent.remove("/x/10.ductus");
    QVERIFY(!recent.paths().contains("/x/10.ductus"));
    recent.clear();
    QVERIFY(next.paths().isEmpty());
}

void SettingsTest::recentFilesKnowWhatIsMissing()
{
    QTemporaryDir dir;
    Settings settings(dir.filePath("s.ini"));
    QFile file(dir.filePath("there.ductus"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    RecentFiles recent(settings, dir.filePath("pictures"));
    recent.add("/x/gone.ductus");
    recent.add(file.fileName());
    QCOMPARE(recent.files()[0].isMissing, false);
    QCOMPARE(recent.files()[1].isMissing, true);
}

void SettingsTest::recentPicturesFollowTheirFiles()
{
    QTemporaryDir dir;
    Settings settings(dir.filePath("s.ini"));
    RecentFiles recent(settings, dir.filePath("pictures"));
    QImage picture(320, 200, QImage::Format_RGB32);
    picture.fill(Qt::blue);
    recent.add("/x/a.ductus", picture);
    recent.add("/x/a.ductus"); // without one: the old stays
    QCOMPARE(recent.files()[0].picture.size(), QSize(160, 100));
    recent.remove("/x/a.ductus");
    QVERIFY(QDir(dir.filePath("pictures")).entryList(QDir::Files).isEmpty());
}

void SettingsTest::pressureGoesStraightByDefault()
{
    const PressureCurve curve;
    for (double p : {0.0, 0.1, 0.5, 0.77, 1.0})
        QVERIFY(std::abs(curve.map(p) - p) < 1e-12);
    QCOMPARE(curve.map(-1.0), 0.0);
    QCOMPARE(curve.map(2.0), 1.0);
    QCOMPARE(curve.map(std::nan("")), 0.0);
}

void SettingsTest::pressureNeverFalls()
{
    // Steep beside flat is where cubics overshoot.
    PressureCurve curve;
    curve.movePoint(2, {0.7, 0.96}); // first, as points stay below their neighbours
    curve.movePoint(1, {0.3, 0.95});
    double before = -1.0;
    for (int i = 0; i <= 1000; ++i) {
        const double y = curve.map(i / 1000.0);
        QVERIFY(y >= before && y >= 0.0 && y <= 1.0);
        before = y;
    }
    QVERIFY(std::abs(curve.map(0.3) - 0.95) < 1e-12);
}

void SettingsTest::pressureTextComesBack()
{
    PressureCurve curve;
    curve.movePoint(1, {0.25, 0.125});
    QVERIFY(PressureCurve::fromText(curve.toText()) == curve);
    for (const char *bad : {"", "1", "0,0 0.5,0.5 1,1", "0,0 0.6,0.3 0.5,0.6 1,1", "0,0 0.3,0.9 0.6,0.2 1,1",
                            "0,0 0.3,nan 0.6,0.6 1,1", "0,0 0.3,0.3 0.6,0.6 1,7", "a,b c,d e,f g,h"})
        QVERIFY2(PressureCurve::fromText(bad) == PressureCurve(), bad);
}

void SettingsTest::pressurePointsKeepTheirPlace()
{
    PressureCurve curve;
    curve.movePoint(1, {0.9, 0.9}); // beyond its neighbour
    QVERIFY(curve.points()[1].x() < curve.points()[2].x());
    QVERIFY(curve.points()[1].y() <= curve.points()[2].y());
    curve.movePoint(0, {0.2, 0.01}); // a dead zone
    QCOMPARE(curve.points()[0], QPointF(0.2, 0.0));
    QCOMPARE(curve.map(0.1), 0.0);
    curve.movePoint(3, {0.8, 0.99}); // full pressure early
    QCOMPARE(curve.map(0.9), 1.0);
    curve.movePoint(9, {0.5, 0.5});
    curve.movePoint(1, {std::nan(""), 0.5});
    QVERIFY(curve.points()[1].x() == curve.points()[1].x());
}

QTEST_GUILESS_MAIN(SettingsTest)
#include "settings_test.moc"
