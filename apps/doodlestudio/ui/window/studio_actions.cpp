// Actions and menus of DoodleStudio's window.
#include "doodlestudio/ui/player/player_view.h"
#include "doodlestudio/ui/timeline/transport_bar.h"
#include "doodlestudio/ui/window/studio_window.h"
#include "widgets/pages/help_window.h"
#include "widgets/theme/icons.h"

#include <QMenu>

namespace ductus {

void StudioWindow::addFileActions()
{
    ActionCatalogue &all = actions();
    const QString file = tr("File");
    all.add({"file.open",
             tr("&Open..."),
             tr("Opens a clip, a folder of pictures or a project."),
             "document-open",
             {QKeySequence::Open},
             file},
            [this] { chooseAndOpen(); });
    all.add({"file.start",
             tr("S&tart page"),
             tr("Shows samples and recent files; the clip stays open."),
             "go-home",
             {QKeySequence("Alt+Home")},
             file},
            [this] {
                refreshRecent();
                isStartPageShown() && !mDoodle.isEmpty() ? showCanvas() : showStartPage();
            });
    all.add({"file.save",
             tr("&Save"),
             tr("Saves what was drawn and where; the clip itself stays where it is."),
             "document-save",
             {QKeySequence::Save},
             file},
            [this] { save(); });
    all.add({"file.saveAs",
             tr("Save &as..."),
             tr("Saves under another name and goes on there."),
             "document-save-as",
             {QKeySequence("Ctrl+Shift+S")},
             file},
            [this] { saveAs(); });
}

void StudioWindow::addPlayActions()
{
    ActionCatalogue &all = actions();
    const QString play = tr("Play");
    QAction *toggle = all.add({"play.toggle",
                               tr("&Play"),
                               tr("Runs the clip in a loop, or stops it."),
                               "media-playback-start",
                               {QKeySequence(Qt::Key_Space)},
                               play},
                              [this] { mPlayback.toggle(); });
    connect(&mPlayback, &Playback::playingChanged, this, [this, toggle](bool playing) {
        toggle->setIcon(icon(playing ? "media-playback-pause" : "media-playback-start"));
        toggle->setText(playing ? tr("&Pause") : tr("&Play"));
    });
    all.add({"play.back",
             tr("One frame &back"),
             tr("Goes to the frame before."),
             "media-seek-backward",
             {QKeySequence(Qt::Key_Left), QKeySequence(Qt::Key_Comma)},
             play},
            [this] { mPlayback.step(-1); });
    all.add({"play.forward",
             tr("One frame &on"),
             tr("Goes to the next frame."),
             "media-seek-forward",
             {QKeySequence(Qt::Key_Right), QKeySequence(Qt::Key_Period)},
             play},
            [this] { mPlayback.step(1); });
    all.add({"play.start",
             tr("To the &beginning"),
             tr("Goes to the first frame."),
             "media-skip-backward",
             {QKeySequence(Qt::Key_Home)},
             play},
            [this] { mPlayback.setFrame(0); });
    all.add({"play.end",
             tr("To the &end"),
             tr("Goes to the last frame."),
             "media-skip-forward",
             {QKeySequence(Qt::Key_End)},
             play},
            [this] { mPlayback.setFrame(mPlayback.frameCount() - 1); });
    all.add({"play.reverse",
             tr("Play back&wards"),
             tr("Runs the clip backwards; again: faster."),
             {},
             {QKeySequence(Qt::Key_J)},
             play},
            [this] { mPlayback.play(mPlayback.rate() < 0 ? std::max(-8.0, mPlayback.rate() * 2) : -1.0); });
    all.add({"play.stop", tr("&Stop"), tr("Stops the clip."), {}, {QKeySequence(Qt::Key_K)}, play},
            [this] { mPlayback.stop(); });
    all.add({"play.faster",
             tr("Play &forwards"),
             tr("Runs the clip; again: faster."),
             {},
             {QKeySequence(Qt::Key_L)},
             play},
            [this] { mPlayback.play(mPlayback.rate() > 0 ? std::min(8.0, mPlayback.rate() * 2) : 1.0); });
    QAction *sound = all.addToggle({"play.sound",
                                    tr("So&und"),
                                    tr("Lets the clip be heard while it runs."),
                                    "speaker",
                                    {QKeySequence(Qt::Key_M)},
                                    play},
                                   [this](bool on) { mPlayback.setMuted(!on); });
    sound->setChecked(true);
    for (const char *id :
         {"play.start", "play.back", "play.toggle", "play.forward", "play.end", "play.sound"})
        mTransport->addButton(all.action(QLatin1String(id)));
}

void StudioWindow::fillMenus()
{
    const auto named = [this](std::initializer_list<const char *> ids) {
        QList<QAction *> list;
        for (const char *id : ids)
            list << actions().action(QLatin1String(id));
        return list;
    };
    addToMenu(fileMenu(), named({"file.open", "file.start", "file.save", "file.saveAs"}));
    menu(tr("&Play"))
        ->addActions(named({"play.toggle", "play.back", "play.forward", "play.start", "play.end",
                            "play.reverse", "play.stop", "play.faster", "play.sound"}));
}

void StudioWindow::openManual(const QString &topic)
{
    auto *help = findChild<HelpWindow *>();
    if (!help)
        help = new HelpWindow(QStringLiteral(":/manual/doodlestudio.md"), this);
    QString heading;
    if (const ActionSpec *spec = actions().spec(topic))
        heading = plainText(spec->text);
    help->show();
    help->raise();
    if (heading.isEmpty() || !help->showSection(heading))
        help->showSection(topic.isEmpty() ? QStringLiteral("DoodleStudio") : topic);
}

} // namespace ductus
