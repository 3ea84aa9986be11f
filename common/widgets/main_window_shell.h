// MainWindowShell: the window all apps share. An app derives from it (or makes one) and fills the places:
//
//     [=] menus            centre (view switch)            search  help      setCentre()
//     message bar                                                            messages()
//     tools |            start page or canvas            | inspector         addTool() setCanvas()
//     addSection() strip                                                                  setStrip() hint job
//     chip      setHint()
//
// The shell owns menus File (after the app filled it), Edit (undo, redo), View (theme, history, full screen)
// and Help; recent files; drops; the window's place on the screen; and the question when closing unsaved
// work.
#pragma once

#include "base/error.h"
#include "document/document.h"
#include "document/jobs/job_runner.h"
#include "document/settings/action_catalogue.h"
#include "document/settings/settings.h"
#include "widgets/theme/palette.h"

#include <QMainWindow>
#include <QPalette>
#include <QPointer>
#include <functional>
#include <vector>

class QActionGroup;
class QLabel;
class QMenu;
class QStackedWidget;

namespace ductus {

class ActionSearch;
class FoldingSection;
class HintLabel;
class Inspector;
class JobChip;
class MessageBar;
class SettingsDialog;
class StartPage;
class ToolRail;
class TopRow;
class UndoPanel;

/// Which app the window belongs to.
struct AppIdentity
{
    QString name;                           // "SketchSurfacer", shown in the title
    AppKind kind = AppKind::SketchSurfacer; // its accent colour
    QString icon;                           // name of the window icon
};

/// What the shell works with; all must outlive it.
struct ShellServices
{
    Settings *settings = nullptr;
    JobRunner *jobs = nullptr;
    ActionCatalogue *actions = nullptr;
};

class MainWindowShell : public QMainWindow
{
    Q_OBJECT
public:
    MainWindowShell(const AppIdentity &identity, const ShellServices &services, QWidget *parent = nullptr);
    ~MainWindowShell() override;

    const AppIdentity &identity() const { return mIdentity; }
    Settings &settings() { return *mServices.settings; }
    JobRunner &jobs() { return *mServices.jobs; }
    ActionCatalogue &actions() { return *mServices.actions; }

    /// A menu in the row, made at its first use; put before Help. Adding catalogue actions:
    /// menu(...)->addAction( actions().action("file.open")).
    QMenu *menu(const QString &title);
    /// Adds to a menu before the part that is the shell's own.
    void addToMenu(QMenu *menu, const QList<QAction *> &added);
    QMenu *fileMenu();
    QMenu *editMenu();
    QMenu *viewMenu();
    QMenu *helpMenu();

    /// Centre of the top row, usually a SegmentedSwitch. Takes ownership, as all set functions here.
    void setCentre(QWidget *widget);
    /// A button for a further thing at the right of the top row, left of the search.
    void addToTopRow(QWidget *widget);

    /// A tool in the left bar; exclusive ones should share a QActionGroup.
    void addTool(QAction *action);
    void addToolSeparator();

    /// The canvas shown while a document is open.
    void setCanvas(QWidget *canvas);
    QWidget *canvas() const { return mCanvas; }
    StartPage *startPage() { return mStartPage; }
    void showCanvas();
    void showStartPage();
    bool isStartPageShown() const;

    /// A section in the inspector, from top to bottom. Takes the content. \a id remembers whether it is
    /// folded.
    FoldingSection *addSection(const QString &id, const QString &title, QWidget *content);
    /// Something above all sections that never folds: the large button.
    void setInspectorHead(QWidget *widget);
    void setInspectorVisible(bool visible);

    /// The app's own strip below canvas and inspector; null: none.
    void setStrip(QWidget *strip);

    /// One sentence about the current tool.
    void setHint(const QString &sentence);
    /// What is under the pointer, in words, at the right of the status row; empty: nothing.
    void setPointerText(const QString &words);

    MessageBar *messages() { return mMessages; }
    /// Shows \a error in the message bar; cancelled ones are not shown. \a action: text of a button and what
    /// it does, both may be empty.
    void showError(const Error &error, const QString &action = {}, std::function<void()> run = {});

    /// The document of the window: title, undo and redo, history, the question when closing. Null: none.
    void setDocument(Document *document);
    Document *document() const { return mDocument; }

    /// A page in the settings dialog beside the shell's own; \a make is called when the dialog is opened.
    void addSettingsPage(const QString &title, std::function<QWidget *()> make);
    void openSettings();
    void openActionSearch();

    /// Asks to save, discard or cancel if there is unsaved work; true: go on (saved, discarded or nothing to
    /// save). Apps call it before opening something else.
    bool confirmLeaving();

signals:
    /// Files were dropped anywhere on the window.
    void filesDropped(const QStringList &paths);
    /// F1: the name of what the pointer or the focus is on ("helpTopic" property, else the object name).
    void helpRequested(const QString &topic);
    void themeChanged();
    /// The window is about to close for good; jobs were asked to stop.
    void closing();

protected:
    /// Saves the document because the user closes with unsaved work and said Save; true once it is on the
    /// disk. Apps show their file dialog for documents without a file. The default saves where the document
    /// is, and waits.
    virtual bool saveForClosing();

    void closeEvent(QCloseEvent *event) override;
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;

private:
    void addShellActions();
    void addUndoActions();
    void fillMenus();
    void buildLayout();
    void applyTheme();
    void setActionIcon(const QString &id);
    void updateUndoActions();
    void updateTitle();
    void restoreWindow();
    void rememberWindow();
    void requestHelp();

    AppIdentity mIdentity;
    ShellServices mServices;
    QPalette mSystemPalette; // before it was dressed
    QActionGroup *mThemeActions = nullptr;
    QMenu *mFileMenu = nullptr;
    QMenu *mEditMenu = nullptr;
    QMenu *mViewMenu = nullptr;
    QMenu *mHelpMenu = nullptr;
    QPointer<Document> mDocument;
    TopRow *mTopRow = nullptr;
    MessageBar *mMessages = nullptr;
    ToolRail *mTools = nullptr;
    QStackedWidget *mStack = nullptr;
    StartPage *mStartPage = nullptr;
    QWidget *mCanvas = nullptr;
    Inspector *mInspector = nullptr;
    QWidget *mStripPlace = nullptr;
    HintLabel *mHint = nullptr;
    QLabel *mPointerText = nullptr;
    JobChip *mJobChip = nullptr;
    UndoPanel *mUndoPanel = nullptr;
    ActionSearch *mSearch = nullptr;
    QStringList mShellActions; // ids
    QPointer<SettingsDialog> mSettingsDialog;
    struct SettingsPage
    {
        QString title;
        std::function<QWidget *()> make;
    };
    std::vector<SettingsPage> mSettingsPages;
};

} // namespace ductus
