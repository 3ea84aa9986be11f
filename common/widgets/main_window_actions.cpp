// The actions and menus every window has.
#include "widgets/main_window_shell.h"

#include "widgets/pages/appearance_page.h"
#include "widgets/pages/settings_dialog.h"
#include "widgets/pages/shortcuts_page.h"
#include "widgets/pages/tablet_page.h"
#include "widgets/shell/action_search.h"
#include "widgets/shell/inspector.h"
#include "widgets/shell/top_row.h"
#include "widgets/shell/undo_panel.h"
#include "widgets/theme/theme.h"

#include <QActionGroup>
#include <QMenu>
#include <QMenuBar>

namespace ductus {

void MainWindowShell::addShellActions()
{
    const QStringList before = actions().ids();
    addUndoActions();
    const QString view = tr("View");
    ActionCatalogue &all = actions();
    QAction *inspector =
        all.addToggle({"view.inspector",
                       tr("&Inspector"),
                       tr("Shows or hides the column at the right."),
                       "inspector",
                       {QKeySequence("F9")},
                       view},
                      [this](bool on) { mInspector->setVisible(on && !isStartPageShown()); });
    inspector->setChecked(true);
    QAction *history = all.addToggle({"view.history",
                                      tr("&History"),
                                      tr("Lists all edits; a click goes back to one."),
                                      "view-history",
                                      {QKeySequence("Ctrl+Alt+Z")},
                                      view},
                                     [this](bool on) { mUndoPanel->setVisible(on); });
    connect(mUndoPanel, &QDockWidget::visibilityChanged, history, [this, history](bool) {
        const QSignalBlocker blocker(history); // hidden with the whole window is not hidden by the user
        if (isVisible())
            history->setChecked(!mUndoPanel->isHidden());
    });
    all.addToggle({"view.fullScreen",
                   tr("&Full screen"),
                   tr("Leaves everything but this window away."),
                   "view-fullscreen",
                   {QKeySequence("F11")},
                   view},
                  [this](bool on) { on ? showFullScreen() : showNormal(); });

    mThemeActions = new QActionGroup(this);
    const std::pair<const char *, QString> themes[] = {{"view.themeSystem", tr("Theme as the &system")},
                                                       {"view.themeDark", tr("&Dark theme")},
                                                       {"view.themeLight", tr("&Light theme")}};
    for (int i = 0; i < 3; ++i) {
        ActionSpec spec{themes[i].first,
                        themes[i].second,
                        tr("Changes the colours of this app, not of your work."),
                        {},
                        {},
                        view};
        spec.isCheckable = true;
        QAction *action = all.add(spec, [this, i] { setThemeChoice(settings(), ThemeChoice(i)); });
        mThemeActions->addAction(action);
        action->setChecked(int(themeChoice(settings())) == i);
    }

    all.add({"edit.settings",
             tr("Se&ttings..."),
             tr("Theme, keys, tablet."),
             "configure",
             {QKeySequence("Ctrl+,")},
             tr("Edit")},
            [this] { openSettings(); });
    QAction *search = all.add({"help.search",
                               tr("&Search actions..."),
                               tr("Type what you want to do; Enter does it."),
                               "edit-find",
                               {QKeySequence("Ctrl+Shift+P")},
                               tr("Help")},
                              [this] { openActionSearch(); });
    QAction *help = all.add({"help.manual",
                             tr("&Manual"),
                             tr("Opens the manual at what you are working with."),
                             "help",
                             {QKeySequence("F1")},
                             tr("Help")},
                            [this] { requestHelp(); });
    all.add({"file.quit",
             tr("&Quit"),
             tr("Closes this window; asks before anything is lost."),
             "quit",
             {QKeySequence("Ctrl+Q")},
             tr("File")},
            [this] { close(); });
    mTopRow->setSearchAction(search);
    mTopRow->setHelpAction(help);
    for (const QString &id : all.ids()) {
        if (!before.contains(id))
            mShellActions << id;
    }
}

void MainWindowShell::addUndoActions()
{
    actions().add({"edit.undo",
                   tr("&Undo"),
                   tr("Takes the last edit back."),
                   "edit-undo",
                   {QKeySequence("Ctrl+Z")},
                   tr("Edit")},
                  [this] {
                      if (mDocument)
                          mDocument->undoStack()->undo();
                  });
    actions().add({"edit.redo",
                   tr("&Redo"),
                   tr("Does again what was taken back."),
                   "edit-redo",
                   {QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")},
                   tr("Edit")},
                  [this] {
                      if (mDocument)
                          mDocument->undoStack()->redo();
                  });
}

void MainWindowShell::updateUndoActions()
{
    QAction *undo = actions().action("edit.undo");
    QAction *redo = actions().action("edit.redo");
    const QUndoStack *stack = mDocument ? mDocument->undoStack() : nullptr;
    undo->setEnabled(stack && stack->canUndo());
    redo->setEnabled(stack && stack->canRedo());
    undo->setText(stack && stack->canUndo() ? tr("&Undo: %1").arg(stack->undoText()) : tr("&Undo"));
    redo->setText(stack && stack->canRedo() ? tr("&Redo: %1").arg(stack->redoText()) : tr("&Redo"));
}

void MainWindowShell::fillMenus()
{
    QMenuBar *bar = mTopRow->menuBar();
    mFileMenu = bar->addMenu(tr("&File"));
    mEditMenu = bar->addMenu(tr("&Edit"));
    mViewMenu = bar->addMenu(tr("&View"));
    mHelpMenu = bar->addMenu(tr("&Help"));
    for (QMenu *menu : {mFileMenu, mEditMenu, mViewMenu, mHelpMenu})
        menu->setToolTipsVisible(true);

    // What the app adds comes before: each menu ends with the shell's own part.
    mFileMenu->addSeparator();
    mFileMenu->addAction(actions().action("file.quit"));
    mEditMenu->addActions({actions().action("edit.undo"), actions().action("edit.redo")});
    mEditMenu->addSeparator();
    mEditMenu->addAction(actions().action("edit.settings"));
    mViewMenu->addSeparator();
    mViewMenu->addActions({actions().action("view.inspector"), actions().action("view.history"),
                           actions().action("view.fullScreen")});
    mViewMenu->addSeparator();
    mViewMenu->addActions(mThemeActions->actions());
    mHelpMenu->addAction(actions().action("help.manual"));
    mHelpMenu->addAction(actions().action("help.search"));
}

void MainWindowShell::addToMenu(QMenu *menu, const QList<QAction *> &added)
{
    QAction *before = nullptr;
    if (menu == mFileMenu)
        before = actions().action("file.quit");
    else if (menu == mEditMenu)
        before = actions().action("edit.settings");
    else if (menu == mViewMenu)
        before = actions().action("view.inspector");
    // Before the separator in front of the shell's own part.
    const qsizetype index = before ? menu->actions().indexOf(before) : -1;
    if (index > 0 && menu->actions().at(index - 1)->isSeparator())
        before = menu->actions().at(index - 1);
    menu->insertActions(before, added);
}

QMenu *MainWindowShell::menu(const QString &title)
{
    for (QAction *action : mTopRow->menuBar()->actions()) {
        if (action->menu() && action->text() == title)
            return action->menu();
    }
    auto *menu = new QMenu(title, this);
    menu->setToolTipsVisible(true);
    mTopRow->menuBar()->insertMenu(mHelpMenu->menuAction(), menu);
    return menu;
}

QMenu *MainWindowShell::fileMenu()
{
    return mFileMenu;
}

QMenu *MainWindowShell::editMenu()
{
    return mEditMenu;
}

QMenu *MainWindowShell::viewMenu()
{
    return mViewMenu;
}

QMenu *MainWindowShell::helpMenu()
{
    return mHelpMenu;
}

void MainWindowShell::addSettingsPage(const QString &title, std::function<QWidget *()> make)
{
    mSettingsPages.push_back({title, std::move(make)});
}

void MainWindowShell::openSettings()
{
    if (mSettingsDialog) {
        mSettingsDialog->raise();
        mSettingsDialog->activateWindow();
        return;
    }
    mSettingsDialog = new SettingsDialog(this);
    mSettingsDialog->setAttribute(Qt::WA_DeleteOnClose);
    mSettingsDialog->addPage(tr("Appearance"), "contrast", new AppearancePage(settings()));
    mSettingsDialog->addPage(tr("Keys"), "configure-shortcuts", new ShortcutsPage(actions()));
    mSettingsDialog->addPage(tr("Tablet"), "input-tablet", new TabletPage(settings()));
    for (const SettingsPage &page : mSettingsPages)
        mSettingsDialog->addPage(page.title, "configure", page.make());
    mSettingsDialog->show();
}

void MainWindowShell::openActionSearch()
{
    if (!mSearch) {
        mSearch = new ActionSearch(actions(), this);
        mSearch->setLast(mShellActions);
    }
    mSearch->openOver(*this);
}

} // namespace ductus
