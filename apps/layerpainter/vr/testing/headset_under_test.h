// The window with a simulated headset, as a painter uses it in tests: tests/support/xr_runtime.
#pragma once

#include "layerpainter/vr/window/headset_window.h"

#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

namespace ductus {

struct HeadsetUnderTest
{
    QTemporaryDir folder;
    Settings settings{folder.filePath("settings.ini")};
    JobRunner jobs;
    ActionCatalogue actions{&settings};
    std::unique_ptr<HeadsetWindow> window;
    QString ended; // why VR was over
    int endings = 0;
    bool isLeftHanded = false;

    explicit HeadsetUnderTest(const QStringList &firstLines = {})
    {
        qputenv("XDG_STATE_HOME", folder.filePath("state").toUtf8());
        qputenv("XR_RUNTIME_JSON", DUCTUS_TEST_XR);
        qputenv("DUCTUS_XR_SCRIPT", folder.filePath("script").toUtf8());
        qputenv("DUCTUS_XR_RECORD", folder.filePath("record").toUtf8());
        // The layer says what is wrong with a call that the runtime takes all the same.
        const QString layer = QStringLiteral("/usr/share/openxr/1/api_layers/explicit.d/"
                                             "XrApiLayer_core_validation.x86_64-linux-gnu.json");
        if (QFile::exists(layer)) {
            qputenv("XR_ENABLE_API_LAYERS", "XR_APILAYER_LUNARG_core_validation");
            qputenv("XR_CORE_VALIDATION_EXPORT_TYPE", "text");
            qputenv("XR_CORE_VALIDATION_FILE_NAME", folder.filePath("validation").toUtf8());
        }
        settings.setRaw(QStringLiteral("appearance/theme"), QStringLiteral("dark"));
        say(firstLines);
        window = std::make_unique<HeadsetWindow>(ShellServices{&settings, &jobs, &actions});
        QObject::connect(&window->vr(), &VrMode::ended, window.get(), [this](const QString &why) {
            ended = why;
            ++endings;
        });
        window->resize(1000, 700);
        window->show();
    }
    ~HeadsetUnderTest()
    {
        window->painting().reset();
        window.reset();
    }

    VrMode &vr() { return window->vr(); }
    const Painting &painting() const { return window->painting().painting(); }

    /// Lines of the script, from now on.
    void say(const QStringList &lines)
    {
        QFile file(folder.filePath("script"));
        if (!file.open(QIODevice::Append))
            qFatal("the script cannot be written");
        for (const QString &line : lines)
            file.write(line.toUtf8() + '\n');
    }
    QStringList record(const QString &beginning) const
    {
        QFile file(folder.filePath("record"));
        QStringList found;
        if (file.open(QIODevice::ReadOnly))
            for (const QString &line : QString::fromUtf8(file.readAll()).split('\n'))
                if (line.startsWith(beginning))
                    found << line;
        return found;
    }
    /// What the validation layer has to say; empty without it or without complaint.
    QString complaints() const
    {
        QFile file(folder.filePath("validation"));
        QString found;
        if (file.open(QIODevice::ReadOnly))
            for (const QString &line : QString::fromUtf8(file.readAll()).split('\n'))
                if (line.contains("VALID_USAGE") || line.contains("XR_ERROR", Qt::CaseSensitive))
                    found += line + '\n';
        return found;
    }

    bool wait(std::function<bool()> condition) { return QTest::qWaitFor(condition, 60'000); }
    /// So many frames more are seen that everything said before has had its effect.
    bool frames(int count = 3)
    {
        const int goal = vr().frameCount() + count;
        return wait([&] { return vr().frameCount() >= goal || !vr().isActive(); }) && vr().isActive();
    }
    bool enter()
    {
        window->enterVr();
        return vr().isActive() && wait([&] { return vr().state() == XR_SESSION_STATE_FOCUSED; }) && frames();
    }

    // Hands by what they do: the painting one and the other.
    QString painter() const { return isLeftHanded ? "left" : "right"; }
    QString holder() const { return isLeftHanded ? "right" : "left"; }
    QString button(const QString &hand, bool first) const
    {
        const QString name = hand == "left" ? (first ? "x" : "y") : (first ? "a" : "b");
        return hand + "/input/" + name + "/click";
    }
    /// A place for right-handers; left-handers' is its mirror image.
    Vec3 mirrored(const Vec3 &place) const
    {
        return {isLeftHanded ? -place.x() : place.x(), place.y(), place.z()};
    }

    void put(const QString &hand, const Vec3 &at,
             const Eigen::Quaterniond &turn = Eigen::Quaterniond::Identity())
    {
        QString line = hand;
        for (const double v : {at.x(), at.y(), at.z(), turn.x(), turn.y(), turn.z(), turn.w()})
            line += ' ' + QString::number(v, 'g', 9);
        say({line});
    }
    void input(const QString &component, double value)
    {
        say({"input " + component + ' ' + QString::number(value)});
    }
    void click(const QString &component)
    {
        input(component, 1);
        frames();
        input(component, 0);
        frames();
    }
    QString trigger() const { return painter() + "/input/trigger/value"; }

    /// The painting hand's ray meets a place of a panel.
    void pointAt(int panel, const QPointF &at)
    {
        const Vec3 from = mirrored({0.30, 1.35, 0.05});
        const Vec3 to = vr().panels().rig().pointOn(panel, at);
        put(painter(), from, Eigen::Quaterniond::FromTwoVectors(-Vec3::UnitZ(), to - from));
        frames();
    }
    QPointF placeOf(int panel, QWidget *widget, const QPoint &in)
    {
        return widget->mapTo(&vr().panels().rig().panel(panel).frame(), in);
    }
    void clickOn(int panel, QWidget *widget, const QPoint &in)
    {
        pointAt(panel, placeOf(panel, widget, in));
        click(trigger());
    }
    void clickOn(int panel, QWidget *widget) { clickOn(panel, widget, widget->rect().center()); }
    /// Turns panels until that one is in front.
    void bringToFront(int panel)
    {
        for (int i = 0; i < 3 && vr().panels().rig().front() != panel; ++i)
            click(holder() + "/input/thumbstick/x");
    }
    /// What the window shows, where DUCTUS_SHOTS says.
    void shot(const QString &name)
    {
        const QString to = qEnvironmentVariable("DUCTUS_SHOTS");
        if (to.isEmpty())
            return;
        QTest::qWait(300);
        window->grab().save(to + '/' + name + ".png");
        for (int i = 0; i < 3; ++i)
            vr().panels().rig().panel(i).image().save(to + '/' + name + "-panel" + QString::number(i) +
                                                      ".png");
    }
};

} // namespace ductus
