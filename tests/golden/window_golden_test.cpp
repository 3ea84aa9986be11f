// SketchSurfacer's window as it is meant to look, 1280 x 800. DUCTUS_REWRITE_GOLDEN=1 takes what is seen now
// for right: look at the pictures before they are committed. A picture that differs is left beside the test,
// with what differs in red.
#include "golden/image_difference.h"
#include "sketchsurfacer/ui/testing/app_under_test.h"
#include "widgets/theme/theme.h"

#include <QtTest>

using namespace ductus;
using namespace ductus::testing;

namespace {

constexpr qint64 mostBytes = 150'000;
const QString folder = QStringLiteral(DUCTUS_SOURCE_DIR "/tests/golden/window/");

// Of the window once nothing works or blinks any more.
QImage pictureOf(App &app)
{
    app.jobs.waitForAll(solveMilliseconds);
    QTest::qWait(400); // the frame with smooth edges
    return app.window->grab().toImage();
}

// The words of what is wrong; empty if nothing is.
QString compare(const QImage &made, const QString &name)
{
    const QString path = folder + name + QStringLiteral(".png");
    if (qEnvironmentVariableIntValue("DUCTUS_REWRITE_GOLDEN") == 1) {
        if (!toBeKept(made).save(path, "PNG", 0))
            return path + QStringLiteral(" cannot be written");
    }
    const QImage kept(path);
    if (kept.isNull())
        return path + QStringLiteral(" is missing; DUCTUS_REWRITE_GOLDEN=1 makes it");
    if (QFileInfo(path).size() > mostBytes)
        return QStringLiteral("%1 has %2 bytes").arg(path).arg(QFileInfo(path).size());
    const ImageDifference difference = differenceOf(made, kept);
    if (difference.isMatch())
        return {};
    made.save(name + QStringLiteral(".out.png"));
    difference.picture.save(name + QStringLiteral(".diff.png"));
    return QStringLiteral("%1 %2 of the picture differs: see %3.out.png and %3.diff.png in %4")
        .arg(100.0 * difference.failingShare, 0, 'f', 1)
        .arg(QLatin1Char('%'))
        .arg(name, QDir::currentPath());
}

} // namespace

class WindowGoldenTest : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void looksAsKept_data();
    void looksAsKept();

private:
    QTemporaryDir mCache;
    std::unique_ptr<App> mApp;
};

void WindowGoldenTest::initTestCase()
{
    QStandardPaths::setTestModeEnabled(false);
    qputenv("XDG_CACHE_HOME", mCache.path().toUtf8()); // pictures of the samples are drawn for this test
    mApp = std::make_unique<App>();
    QVERIFY(QTest::qWaitForWindowExposed(mApp->window.get()));
    QCOMPARE(mApp->window->size(), QSize(1280, 800));
}

void WindowGoldenTest::looksAsKept_data()
{
    QTest::addColumn<QString>("name");
    for (const char *name :
         {"start-dark", "sketch-dark", "surface-dark", "regions-dark", "deviation-dark", "surface-light"})
        QTest::newRow(name) << QString(name);
}

void WindowGoldenTest::looksAsKept()
{
    QFETCH(QString, name);
    SurfacerWindow &window = *mApp->window;
    if (name == "sketch-dark") {
        QVERIFY(mApp->open("bevelled-box"));
    } else if (name == "surface-dark") {
        mApp->press(Qt::Key_Return, Qt::ControlModifier);
        QVERIFY(mApp->waitForResult());
        QCOMPARE(window.view().mode(), ViewMode::Surface);
    } else if (name == "regions-dark") {
        mApp->press(Qt::Key_3);
    } else if (name == "deviation-dark") {
        mApp->press(Qt::Key_5);
    } else if (name == "surface-light") {
        mApp->press(Qt::Key_4);
        setThemeChoice(mApp->settings, ThemeChoice::Light);
    }
    if (name != "start-dark")
        QTRY_VERIFY(window.view().frameCount() > 0);
    const QString wrong = compare(pictureOf(*mApp), name);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
}

QTEST_MAIN(WindowGoldenTest)
#include "window_golden_test.moc"
