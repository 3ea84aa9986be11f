// What the tests of the window share: the window on its own, driven by mouse and keys, and a clock of its
// event loop. With DUCTUS_SHOTS naming a folder, App::shot leaves pictures there.
#pragma once

#include "sketchsurfacer/ui/window/surfacer_window.h"

#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QtTest>
#include <cmath>
#include <cstring>
#include <ctime>

namespace ductus::testing {

inline constexpr int solveMilliseconds = 240'000; // on a busy machine

// Byte for byte.
inline bool sameMesh(const TriangleMesh &a, const TriangleMesh &b)
{
    return a.triangles == b.triangles && a.vertices.size() == b.vertices.size() &&
           std::equal(a.vertices.begin(), a.vertices.end(), b.vertices.begin(),
                      [](const Vec3 &p, const Vec3 &q) {
                          return std::memcmp(p.data(), q.data(), 3 * sizeof(double)) == 0;
                      });
}

// The longest time between two turns of the event loop: by the clock, and what this thread itself worked in
// it. The clock also counts what other programs take of the machine, so the work is what is judged.
class Heartbeat
{
public:
    Heartbeat()
    {
        mClock.start();
        mWorked = worked();
        QObject::connect(&mTimer, &QTimer::timeout, [this] {
            mLongest = std::max(mLongest, mClock.restart());
            const double now = worked();
            mMostWork = std::max(mMostWork, now - std::exchange(mWorked, now));
        });
        mTimer.start(5);
    }
    qint64 longestMilliseconds() const { return mLongest; }
    double mostWorkMilliseconds() const { return mMostWork; }

private:
    static double worked()
    {
        timespec time{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return double(time.tv_sec) * 1e3 + double(time.tv_nsec) * 1e-6;
    }

    QTimer mTimer;
    QElapsedTimer mClock;
    qint64 mLongest = 0;
    double mWorked = 0.0, mMostWork = 0.0;
};

// SketchSurfacer's window with settings and state of its own, and the hands of its user.
struct App
{
    QTemporaryDir dir;
    Settings settings{dir.filePath("settings.ini")};
    JobRunner jobs;
    ActionCatalogue actions{&settings};
    std::unique_ptr<SurfacerWindow> window;

    App()
    {
        qputenv("XDG_STATE_HOME", dir.filePath("state").toUtf8()); // nothing of the user's own is offered
        settings.setRaw(QStringLiteral("appearance/theme"), QStringLiteral("dark"));
        window = std::make_unique<SurfacerWindow>(ShellServices{&settings, &jobs, &actions});
        window->resize(1280, 800);
        window->show();
        window->activateWindow();
    }
    void shot(const QString &name) const
    {
        const QString folder = qEnvironmentVariable("DUCTUS_SHOTS");
        if (folder.isEmpty())
            return;
        QTest::qWait(250);
        window->grab().save(folder + QLatin1Char('/') + name + QStringLiteral(".png"));
    }
    bool open(const QString &sample)
    {
        window->openSample(sample);
        return QTest::qWaitFor([&] { return !window->sketch().isEmpty(); }, 20'000);
    }
    /// Options that make a test wait less than a user does.
    void chooseQuickOptions(int proxyVertices = 3000, int runs = 1)
    {
        SurfaceOptions options = window->sketch().content().options;
        options.symmetry = SymmetryMode::None;
        options.proxy.targetVertices = proxyVertices;
        options.segmentation.runs = runs;
        window->sketch().setOptions("Quicker", options);
    }
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {})
    {
        // To the widget and not to its window: such a click takes no time, however long the window draws
        // between press and release.
        QWidget *focus = QApplication::focusWidget();
        QTest::keyClick(focus && focus->window() == window.get() ? focus : window.get(), key, modifiers);
    }
    bool waitForResult()
    {
        return QTest::qWaitFor(
            [&] {
                const auto shown = window->presenter().resultView();
                return window->sketch().isUpToDate() && shown && shown->state == window->sketch().result();
            },
            solveMilliseconds);
    }
    const TriangleMesh &surface() const { return window->sketch().result()->surface->mesh; }
    void drag(const std::vector<QPoint> &points)
    {
        SketchView &view = window->view();
        QTest::mouseMove(&view, points.front());
        QTest::mousePress(&view, Qt::LeftButton, {}, points.front());
        for (const QPoint &p : points) {
            QTest::mouseMove(&view, p);
            QTest::qWait(5);
        }
        QTest::mouseRelease(&view, Qt::LeftButton, {}, points.back());
    }
    int regionAt(const QPoint &p) const
    {
        const auto hit = window->view().surfaceAt(p);
        return hit ? window->presenter().regionOf(*hit) : -1;
    }
    // A drag from one region into another, both large enough for it; empty if the picture has none.
    std::vector<QPoint> acrossRegions() const
    {
        const SketchView &view = window->view();
        for (int y = view.height() / 4; y < 3 * view.height() / 4; y += 15)
            for (int x = 40; x < view.width() - 80; x += 5) {
                const int a = regionAt({x - 30, y}), b = regionAt({x + 30, y});
                if (a >= 0 && b >= 0 && a != b && regionAt({x - 10, y}) == a && regionAt({x + 10, y}) == b)
                    return {{x - 30, y}, {x - 15, y}, {x, y}, {x + 15, y}, {x + 30, y}};
            }
        return {};
    }
};

} // namespace ductus::testing
