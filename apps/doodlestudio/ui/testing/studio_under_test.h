// The window as a teacher uses it in tests: drops, clicks, drags and keys; pictures under DUCTUS_SHOTS.
#pragma once

#include "doodlestudio/ui/drawing/drawing_panel.h"
#include "doodlestudio/ui/player/player_view.h"
#include "doodlestudio/ui/timeline/timeline_view.h"
#include "doodlestudio/ui/window/studio_window.h"
#include "formats/film/film_writer.h"
#include "imaging/image.h"

#include <QDropEvent>
#include <QMimeData>
#include <QTemporaryDir>
#include <QtEndian>
#include <QtTest>
#include <cmath>
#include <utility>

namespace ductus {

/// A tone of \a seconds as a WAV file.
inline void writeTone(const QString &path, double seconds)
{
    constexpr int rate = 22050;
    const int count = int(seconds * rate);
    QByteArray bytes;
    const auto number = [&](auto value) {
        value = qToLittleEndian(value);
        bytes.append(reinterpret_cast<const char *>(&value), sizeof value);
    };
    bytes.append("RIFF");
    number(quint32(36 + 2 * count));
    bytes.append("WAVEfmt ");
    number(quint32(16));
    number(quint16(1));
    number(quint16(1));
    number(quint32(rate));
    number(quint32(2 * rate));
    number(quint16(2));
    number(quint16(16));
    bytes.append("data");
    number(quint32(2 * count));
    for (int i = 0; i < count; ++i)
        number(qint16(9000 * std::sin(0.12 * i)));
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        qFatal("no tone");
}

/// \a frames as a film with a tone.
inline void writeClip(const std::vector<Image> &frames, const QString &path, double framesPerSecond)
{
    const QString tone = path + QStringLiteral(".wav");
    writeTone(tone, double(frames.size()) / framesPerSecond);
    FilmOptions options;
    options.width = frames.front().width;
    options.height = frames.front().height;
    options.rate = {int(framesPerSecond), 1};
    options.soundFrom = tone.toStdString();
    options.soundBegins = 0.0;
    Result<FilmWriter> film = FilmWriter::open(path.toStdString(), options);
    if (!film)
        qFatal("%s", film.error().message().c_str());
    for (const Image &frame : frames)
        if (Result<void> added = film->add(frame); !added)
            qFatal("%s", added.error().message().c_str());
    if (Result<void> done = film->finish(); !done)
        qFatal("%s", done.error().message().c_str());
}

struct StudioUnderTest
{
    QTemporaryDir folder;
    Settings settings{folder.filePath("settings.ini")};
    JobRunner jobs;
    ActionCatalogue actions{&settings};
    std::unique_ptr<StudioWindow> window;

    StudioUnderTest()
    {
        // Nothing of the user's own is offered; tests of recovery name a folder that outlives a program.
        qputenv("XDG_STATE_HOME", qEnvironmentVariable("DUCTUS_STATE", folder.filePath("state")).toUtf8());
        qputenv("XDG_CACHE_HOME", folder.filePath("cache").toUtf8()); // nor taken
        settings.setRaw(QStringLiteral("appearance/theme"), qEnvironmentVariable("DUCTUS_THEME", "dark"));
        window = std::make_unique<StudioWindow>(ShellServices{&settings, &jobs, &actions});
        const QStringList size = qEnvironmentVariable("DUCTUS_SIZE", "1280x800").split('x');
        window->resize(size[0].toInt(), size[1].toInt());
        window->show();
        window->activateWindow();
    }
    ~StudioUnderTest() { window->doodle().reset(); }

    void shot(const QString &name)
    {
        const QString to = qEnvironmentVariable("DUCTUS_SHOTS");
        if (to.isEmpty())
            return;
        QTest::qWait(500);
        window->grab().save(to + '/' + name + ".png");
    }
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::keyClick(window->windowHandle(), key, modifiers);
    }
    void trigger(const char *id) { actions.action(QLatin1String(id))->trigger(); }

    /// By the mouse as the window system tells of it: widgets, focus and cursors do what they do for users.
    static void drag(QWidget &on, const std::vector<QPointF> &points)
    {
        QWindow *handle = on.window()->windowHandle();
        const auto inWindow = [&](const QPointF &p) { return on.mapTo(on.window(), p.toPoint()); };
        QTest::mouseMove(handle, inWindow(points.front()));
        QTest::mousePress(handle, Qt::LeftButton, {}, inWindow(points.front()));
        for (const QPointF &p : points) {
            QTest::mouseMove(handle, inWindow(p));
            QCoreApplication::processEvents();
        }
        QTest::mouseRelease(handle, Qt::LeftButton, {}, inWindow(points.back()));
    }
    /// Parts that were shown or hidden have their places.
    void settle()
    {
        QRectF before, now = window->player().pictureRect();
        for (int still = 0; still < 3; still = now == before ? still + 1 : 0) {
            QCoreApplication::sendPostedEvents();
            QCoreApplication::processEvents();
            before = std::exchange(now, window->player().pictureRect());
        }
    }
    /// On the picture, working pixels.
    void dragOnPicture(const std::vector<Vec2> &points)
    {
        settle();
        std::vector<QPointF> inView;
        for (const Vec2 &p : points)
            inView.push_back(window->player().toView(toPoint(p)));
        drag(window->player(), inView);
    }
    /// On the sheet in the drawing panel; shares of it, -0.5 .. 0.5.
    void drawOnSheet(const std::vector<Vec2> &points)
    {
        settle();
        DrawingView &view = window->drawing().view();
        const QRectF sheet = view.sheetRect();
        std::vector<QPointF> inView;
        for (const Vec2 &p : points)
            inView.emplace_back(sheet.center().x() + p.x() * sheet.width(),
                                sheet.center().y() + p.y() * sheet.height());
        drag(view, inView);
    }
    void drop(const QString &path)
    {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(path)});
        QDragEnterEvent enter(QPoint(300, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(window.get(), &enter);
        QDropEvent event(QPointF(300, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(window.get(), &event);
    }
    bool open(const QString &path)
    {
        QSignalSpy shown(window.get(), &StudioWindow::clipShown);
        drop(path);
        return QTest::qWaitFor([&] { return !shown.isEmpty(); }, 60'000);
    }
    bool followed()
    {
        return QTest::qWaitFor([&] { return !window->follower().isBusy(); }, 60'000);
    }
};

/// A line from \a from to \a to with a wave in it.
inline std::vector<Vec2> wavyLine(const Vec2 &from, const Vec2 &to)
{
    std::vector<Vec2> points;
    for (int i = 0; i <= 16; ++i) {
        const double s = i / 16.0;
        points.push_back(from + s * (to - from) + Vec2(0.0, 0.05 * std::sin(9.0 * s)));
    }
    return points;
}

} // namespace ductus
