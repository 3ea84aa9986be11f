// "My scanner gives points and no strokes": dropped on the window, seen as dots, picked, and surfaced.
#include "sketchsurfacer/ui/testing/app_under_test.h"

#include "widgets/shell/message_bar.h"
#include "widgets/theme/theme.h"

#include <QDropEvent>
#include <QMimeData>
#include <numbers>

using namespace ductus;
using namespace ductus::testing;

namespace {

constexpr int pointCount = 20'000; // of a dense scan
const Vec3 middle(0.1, 0.6, -0.2);
constexpr double radius = 0.5;

// An even spiral over a ball with a flat bottom.
QByteArray cutBall(int pointCount)
{
    QByteArray text;
    for (int i = 0; i < pointCount; ++i) {
        const double y = 1.0 - 2.0 * (i + 0.5) / pointCount;
        const double angle = i * std::numbers::pi * (3.0 - std::sqrt(5.0));
        const double ring = std::sqrt(1.0 - y * y) *
                            (y < -0.6 ? 0.8 / std::sqrt(1.0 - y * y) * std::sqrt((1.0 + y) / 0.4) : 1.0);
        const Vec3 p =
            middle + radius * Vec3(ring * std::cos(angle), std::max(y, -0.6), ring * std::sin(angle));
        for (int axis = 0; axis < 3; ++axis)
            text += QByteArray::number(p[axis], 'f', 6) + (axis < 2 ? ' ' : '\n');
    }
    return text;
}

bool dropFile(SurfacerWindow &window, const QString &path, const QByteArray &content)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
        return false;
    file.close();
    QMimeData mime;
    mime.setUrls({QUrl::fromLocalFile(path)});
    QDragEnterEvent enter(QPoint(300, 300), Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
    if (!QApplication::sendEvent(&window, &enter) || !enter.isAccepted())
        return false;
    QDropEvent drop(QPointF(300, 300), Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
    return QApplication::sendEvent(&window, &drop) && drop.isAccepted();
}

} // namespace

class PointCloudWindowTest : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void aDroppedCloudIsSeenAsDots();
    void dotsArePicked();
    void aDenseCloudIsHandledAtOnce();
    void theCloudIsSurfaced();
    void pointsAllOverAVolumeAreRefused();

private:
    std::unique_ptr<App> mApp;
};

void PointCloudWindowTest::initTestCase()
{
    QStandardPaths::setTestModeEnabled(true);
    mApp = std::make_unique<App>();
    QVERIFY(QTest::qWaitForWindowExposed(mApp->window.get()));
}

void PointCloudWindowTest::aDroppedCloudIsSeenAsDots()
{
    SurfacerWindow &window = *mApp->window;
    QVERIFY(dropFile(window, mApp->dir.filePath("ball.xyz"), cutBall(pointCount)));
    QTRY_COMPARE_WITH_TIMEOUT(window.sketch().strokes().strokes.size(), std::size_t(pointCount), 20'000);
    QTRY_VERIFY(!window.messages()->messages().isEmpty());
    QCOMPARE(window.messages()->messages().last().kind, MessageKind::Info);
    QTRY_VERIFY(window.view().frameCount() > 0);
    mApp->shot("cloud-1-dots");
    // A dot is brighter than the ground it is on.
    const QImage picture = window.view().smoothPicture();
    const Vec3 outermost = middle + radius * window.view().camera().right();
    const QPointF at = *window.view().camera().project(outermost) * window.view().devicePixelRatioF();
    int brightest = 0;
    for (int y = -6; y <= 6; ++y)
        for (int x = -6; x <= 6; ++x)
            brightest = std::max(brightest, qGray(picture.pixel(at.toPoint() + QPoint(x, y))));
    const int ground = qGray(picture.pixel(at.toPoint() + QPoint(40, 0)));
    QVERIFY2(brightest > ground + 60, qPrintable(QString("%1 %2").arg(brightest).arg(ground)));
}

void PointCloudWindowTest::dotsArePicked()
{
    SketchView &view = mApp->window->view();
    const StrokeSet &strokes = mApp->window->sketch().strokes();
    QCOMPARE(strokes.strokes.size(), std::size_t(pointCount));
    const QPointF at = *view.camera().project(strokes.strokes[1000].points.front());
    const int line = view.strokeAt(at);
    QVERIFY(line >= 0);
    const QPointF found = *view.camera().project(strokes.strokes[std::size_t(line)].points.front());
    QVERIFY(std::hypot(found.x() - at.x(), found.y() - at.y()) < 1.0);
    QCOMPARE(view.strokeAt(QPointF(3, 3)), -1);
}

// Choosing, painting roles and undoing take no longer for points than a hand notices.
void PointCloudWindowTest::aDenseCloudIsHandledAtOnce()
{
    SurfacerWindow &window = *mApp->window;
    Heartbeat heart;
    mApp->press(Qt::Key_A, Qt::ControlModifier);
    QCOMPARE(window.presenter().selection().size(), std::size_t(pointCount));
    QTest::qWait(50);
    window.sketch().setRole(window.presenter().selection(), StrokeRole::Ignored);
    QTest::qWait(50);
    mApp->press(Qt::Key_Z, Qt::ControlModifier);
    mApp->press(Qt::Key_Escape);
    QTest::qWait(50);
    QVERIFY(window.presenter().selection().empty());
    qInfo("most work in one turn: %.0f ms; a frame takes %.0f ms", heart.mostWorkMilliseconds(),
          window.view().lastFrameMilliseconds());
    QVERIFY2(heart.mostWorkMilliseconds() <= 150.0,
             qPrintable(QString::number(heart.mostWorkMilliseconds())));
}

void PointCloudWindowTest::theCloudIsSurfaced()
{
    SurfacerWindow &window = *mApp->window;
    // Fewer points and a coarse proxy: how long the solver takes is no matter of the window.
    QVERIFY(dropFile(window, mApp->dir.filePath("thin.xyz"), cutBall(2000)));
    QTRY_COMPARE_WITH_TIMEOUT(window.sketch().strokes().strokes.size(), std::size_t(2000), 20'000);
    mApp->chooseQuickOptions();
    QElapsedTimer clock;
    clock.start();
    mApp->press(Qt::Key_Return, Qt::ControlModifier);
    QVERIFY(mApp->waitForResult());
    qInfo("from the points to the surface shown: %lld ms", clock.elapsed());
    mApp->shot("cloud-2-surface");
    for (const Vec3 &p : mApp->surface().vertices)
        QVERIFY((p - middle).norm() < 1.05 * radius && p.y() > middle.y() - 0.65 * radius);
    QVERIFY(window.sketch().result()->surface->regions.size() < 30);
    mApp->press(Qt::Key_5);
    QTRY_COMPARE(window.view().mode(), ViewMode::Deviation);
    mApp->shot("cloud-3-deviation");
    window.sketch().undoStack()->setClean();
    setThemeChoice(mApp->settings, ThemeChoice::Light);
    mApp->press(Qt::Key_1);
    mApp->shot("cloud-4-light");
}

void PointCloudWindowTest::pointsAllOverAVolumeAreRefused()
{
    App app;
    QVERIFY(QTest::qWaitForWindowExposed(app.window.get()));
    QByteArray text;
    std::uint32_t state = 7;
    for (int i = 0; i < 900; ++i) {
        state = state * 1664525u + 1013904223u;
        text += QByteArray::number((state >> 8) / double(1 << 24), 'f', 6) + (i % 3 < 2 ? ' ' : '\n');
    }
    QVERIFY(dropFile(*app.window, app.dir.filePath("fog.xyz"), text));
    QTRY_VERIFY(!app.window->messages()->messages().isEmpty());
    QCOMPARE(app.window->messages()->messages().last().kind, MessageKind::Error);
    QVERIFY(app.window->messages()->messages().last().what.contains("fog.xyz"));
    QVERIFY(app.window->sketch().isEmpty());
}

QTEST_MAIN(PointCloudWindowTest)
#include "point_cloud_test.moc"
