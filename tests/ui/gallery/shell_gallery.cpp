// shell_gallery [--app NAME] [--theme dark|light] [--size WxH] [--state S] [--shot FILE]
// Shows the shared window with made-up content. With --shot it writes a picture of one state and ends;
// states: start, canvas, error, job, search, settings, keys, tablet, history, menu, narrow.
#include "ui/gallery/gallery_window.h"
#include "widgets/main_window_shell.h"
#include "widgets/pages/recovery_notice.h"
#include "widgets/pages/settings_dialog.h"
#include "widgets/pages/start_page.h"
#include "widgets/shell/job_chip.h"
#include "widgets/shell/message_bar.h"
#include "widgets/theme/theme.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QMenu>
#include <QPainter>
#include <QScreen>
#include <QTemporaryDir>
#include <QTextStream>
#include <QTimer>

using namespace ductus;

namespace {

void show(GalleryWindow &window, const QString &state)
{
    if (state != QLatin1String("start"))
        window.showCanvas();
    if (state == QLatin1String("error"))
        window.showError({ErrorCode::Malformed, "Reading the sketch", "the x coordinate is not a number",
                          "Export the sketch again", "hat.curves:12"},
                         QStringLiteral("Open another..."));
    if (state == QLatin1String("success"))
        window.messages()->success(QStringLiteral("The surface is ready."));
    if (state == QLatin1String("job") || state == QLatin1String("jobs"))
        window.startJob(8.0);
    if (state == QLatin1String("jobs"))
        QTimer::singleShot(2500, &window, [&] { window.findChild<JobChip *>()->openList(); });
    if (state == QLatin1String("search"))
        QTimer::singleShot(200, &window, [&] { window.openActionSearch(); });
    if (state == QLatin1String("recovery")) {
        window.showStartPage();
        window.startPage()->setNotice(new RecoveryNotice(
            {{"/state/1.ductus", "/home/ann/hat.ductus", "hat", QDateTime::currentDateTime(), {}}}));
    }
    if (state == QLatin1String("menu"))
        window.editMenu()->popup(window.mapToGlobal(QPoint(60, 40)));
    if (state == QLatin1String("history")) {
        window.galleryDocument().changeTightness(0.7, 0);
        window.galleryDocument().changeTightness(0.5, 0);
        window.actions().action("view.history")->setChecked(true);
    }
    const QStringList pages{"settings", "keys", "tablet"};
    if (pages.contains(state)) {
        window.openSettings();
        window.findChild<SettingsDialog *>()->showPage(int(pages.indexOf(state)));
    }
}

// All windows as they lie on each other, without a display server's help.
bool shoot(GalleryWindow &window, const QString &file)
{
    QPixmap picture = window.grab();
    QPainter painter(&picture);
    for (QWidget *other : QApplication::topLevelWidgets()) {
        if (other != &window && other->isVisible() && !other->inherits("QTipLabel"))
            painter.drawPixmap(
                other->isModal() || other->inherits("ductus::SettingsDialog")
                    ? QPoint((window.width() - other->width()) / 2, (window.height() - other->height()) / 2)
                    : window.mapFromGlobal(other->pos()),
                other->grab());
    }
    painter.end();
    return picture.save(file);
}

} // namespace

int main(int argc, char *argv[])
{
    QApplication application(argc, argv);
    QCommandLineParser parser;
    parser.addHelpOption();
    parser.addOptions({{"app", "sketchsurfacer, layerpainter or doodlestudio", "name", "sketchsurfacer"},
                       {"theme", "dark, light or system", "name", "dark"},
                       {"size", "of the window", "WxH", "1280x800"},
                       {"state", "what to show", "name", "canvas"},
                       {"delay", "milliseconds before the picture", "ms", "600"},
                       {"shot", "write a picture there and end", "file"}});
    parser.process(application);
    QTemporaryDir dir;
    Settings settings(dir.filePath("settings.ini"));
    settings.set(themeSetting, parser.value("theme"));
    JobRunner jobs;
    ActionCatalogue actions(&settings);
    const QString app = parser.value("app");
    const AppKind kind = app == QLatin1String("layerpainter")   ? AppKind::LayerPainter
                         : app == QLatin1String("doodlestudio") ? AppKind::DoodleStudio
                                                                : AppKind::SketchSurfacer;
    GalleryWindow window(kind, {&settings, &jobs, &actions});
    const QStringList size = parser.value("size").split(QLatin1Char('x'));
    if (size.size() == 2)
        window.resize(size[0].toInt(), size[1].toInt());
    window.show();
    show(window, parser.value("state"));
    if (!parser.isSet("shot"))
        return QApplication::exec();
    int code = 0;
    QTimer::singleShot(parser.value("delay").toInt(), &window, [&] {
        if (!shoot(window, parser.value("shot"))) {
            QTextStream(stderr) << "cannot write " << parser.value("shot") << "\n";
            code = 1;
        }
        QApplication::exit(code);
    });
    return QApplication::exec();
}
