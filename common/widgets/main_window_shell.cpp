#include "widgets/main_window_shell.h"

#include "document/document_files.h"
#include "widgets/controls/folding_section.h"
#include "widgets/pages/start_page.h"
#include "widgets/shell/control_keys.h"
#include "widgets/shell/hint_label.h"
#include "widgets/shell/inspector.h"
#include "widgets/shell/job_chip.h"
#include "widgets/shell/message_bar.h"
#include "widgets/shell/tool_rail.h"
#include "widgets/shell/top_row.h"
#include "widgets/shell/undo_panel.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/theme.h"

#include <QActionGroup>
#include <QApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenuBar>
#include <QStackedWidget>
#include <QStatusBar>
#include <QVBoxLayout>

namespace ductus {

namespace {

constexpr int statusHeight = 24;

} // namespace

MainWindowShell::MainWindowShell(const AppIdentity &identity, const ShellServices &services, QWidget *parent)
    : QMainWindow(parent), mIdentity(identity), mServices(services),
      mSystemPalette(QGuiApplication::palette())
{
    DUCTUS_ASSERT(services.settings && services.jobs && services.actions);
    setObjectName(QStringLiteral("mainWindow"));
    setAcceptDrops(true);
    new ControlKeys(this);
    setContextMenuPolicy(Qt::NoContextMenu); // QMainWindow's own lists the docks, which the View menu does
    applyTheme();
    buildLayout();
    addShellActions();
    fillMenus();
    for (const QString &id : actions().ids())
        setActionIcon(id);
    connect(&actions(), &ActionCatalogue::added, this, &MainWindowShell::setActionIcon);
    connect(&settings(), &Settings::changed, this, [this](const QString &key) {
        if (key == QLatin1String(themeSetting.key))
            applyTheme();
    });
    setWindowIcon(icon(identity.icon));
    updateTitle();
    updateUndoActions();
    showStartPage();
    restoreWindow();
}

MainWindowShell::~MainWindowShell() = default;

void MainWindowShell::buildLayout()
{
    auto *top = new QWidget;
    auto *topLayout = new QVBoxLayout(top);
    topLayout->setContentsMargins(0, 0, 0, 0);
    topLayout->setSpacing(0);
    mTopRow = new TopRow;
    mMessages = new MessageBar;
    topLayout->addWidget(mTopRow);
    topLayout->addWidget(mMessages);
    setMenuWidget(top);

    mTools = new ToolRail;
    mStack = new QStackedWidget;
    mStartPage = new StartPage;
    mStartPage->setHeading(mIdentity.name, {});
    mStack->addWidget(mStartPage);
    mInspector = new Inspector(settings());
    mStripPlace = new QWidget;
    mStripPlace->setObjectName(QStringLiteral("appStrip"));
    mStripPlace->setAttribute(Qt::WA_StyledBackground);
    mStripPlace->hide();
    auto *stripLayout = new QVBoxLayout(mStripPlace);
    stripLayout->setContentsMargins(0, 1, 0, 0);

    auto *centre = new QWidget;
    auto *rows = new QVBoxLayout(centre);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    auto *columns = new QHBoxLayout;
    columns->setSpacing(0);
    columns->addWidget(mTools);
    columns->addWidget(mStack, 1);
    columns->addWidget(mInspector);
    rows->addLayout(columns, 1);
    rows->addWidget(mStripPlace);
    setCentralWidget(centre);

    mUndoPanel = new UndoPanel(this);
    addDockWidget(Qt::RightDockWidgetArea, mUndoPanel);
    mUndoPanel->hide();

    mHint = new HintLabel;
    mHint->setObjectName(QStringLiteral("hint"));
    mPointerText = new QLabel;
    mPointerText->setProperty("dim", true);
    mJobChip = new JobChip(jobs());
    statusBar()->setSizeGripEnabled(false);
    statusBar()->setFixedHeight(statusHeight + 1);
    statusBar()->setContentsMargins(8, 0, 4, 0);
    statusBar()->addWidget(mHint, 1);
    statusBar()->addPermanentWidget(mPointerText);
    statusBar()->addPermanentWidget(mJobChip);
}

void MainWindowShell::applyTheme()
{
    dress(*qApp, themeColours(isDark(themeChoice(settings()), mSystemPalette), mIdentity.kind));
    if (mThemeActions)
        mThemeActions->actions().at(int(themeChoice(settings())))->setChecked(true);
    emit themeChanged();
}

void MainWindowShell::setActionIcon(const QString &id)
{
    actions().action(id)->setIcon(icon(actions().spec(id)->icon));
    // So that its keys work without being in a menu.
    addAction(actions().action(id));
}

void MainWindowShell::setCentre(QWidget *widget)
{
    mTopRow->setCentre(widget);
}

void MainWindowShell::addToTopRow(QWidget *widget)
{
    mTopRow->addAtRight(widget);
}

void MainWindowShell::addTool(QAction *action)
{
    mTools->addTool(action);
}

void MainWindowShell::addToolSeparator()
{
    mTools->addSeparator();
}

void MainWindowShell::setCanvas(QWidget *canvas)
{
    if (mCanvas) {
        mStack->removeWidget(mCanvas);
        delete mCanvas;
    }
    mCanvas = canvas;
    if (mCanvas)
        mStack->addWidget(mCanvas);
}

void MainWindowShell::showCanvas()
{
    if (!mCanvas)
        return;
    // A stack is as wide as its widest page, also while that is hidden.
    mStartPage->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
    mStack->setCurrentWidget(mCanvas);
    mTopRow->setCentreVisible(true);
    mHint->setVisible(true);
    mTools->setVisible(!mTools->isEmpty());
    mInspector->setVisible(!actions().action("view.inspector") ||
                           actions().action("view.inspector")->isChecked());
    mStripPlace->setVisible(mStripPlace->layout()->count() > 0);
}

void MainWindowShell::showStartPage()
{
    mStartPage->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
    mStack->setCurrentWidget(mStartPage);
    // Nothing to work on: the tools would only be in the way.
    mTopRow->setCentreVisible(false);
    mHint->setVisible(false);
    mTools->hide();
    mInspector->hide();
    mStripPlace->hide();
}

bool MainWindowShell::isStartPageShown() const
{
    return mStack->currentWidget() == mStartPage;
}

FoldingSection *MainWindowShell::addSection(const QString &id, const QString &title, QWidget *content)
{
    return mInspector->addSection(id, title, content);
}

void MainWindowShell::setInspectorHead(QWidget *widget)
{
    mInspector->setHead(widget);
}

void MainWindowShell::setInspectorVisible(bool visible)
{
    actions().action("view.inspector")->setChecked(visible);
}

void MainWindowShell::setStrip(QWidget *strip)
{
    while (QLayoutItem *item = mStripPlace->layout()->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    if (strip)
        mStripPlace->layout()->addWidget(strip);
    mStripPlace->setVisible(strip && !isStartPageShown());
}

void MainWindowShell::setHint(const QString &sentence)
{
    mHint->setText(sentence);
}

void MainWindowShell::setPointerText(const QString &words)
{
    mPointerText->setText(words);
}

void MainWindowShell::showError(const Error &error, const QString &action, std::function<void()> run)
{
    if (error.isCancelled())
        return;
    Message message = messageFrom(error);
    message.action = action;
    message.run = std::move(run);
    mMessages->show(message);
}

void MainWindowShell::setDocument(Document *document)
{
    if (mDocument) {
        mDocument->disconnect(this);
        mDocument->undoStack()->disconnect(this);
    }
    mDocument = document;
    mUndoPanel->setStack(document ? document->undoStack() : nullptr);
    if (document) {
        connect(document, &Document::modifiedChanged, this, &MainWindowShell::updateTitle);
        connect(document, &Document::identityChanged, this, &MainWindowShell::updateTitle);
        connect(document->undoStack(), &QUndoStack::indexChanged, this, &MainWindowShell::updateUndoActions);
        connect(document, &QObject::destroyed, this, [this] {
            updateTitle();
            updateUndoActions();
        });
    }
    updateTitle();
    updateUndoActions();
}

void MainWindowShell::updateTitle()
{
    if (!mDocument) {
        setWindowModified(false);
        setWindowTitle(mIdentity.name);
        return;
    }
    QString name = mDocument->displayName();
    if (mDocument->isReadOnly())
        name = tr("%1 (read-only)").arg(name);
    setWindowTitle(QStringLiteral("%1[*] - %2").arg(name, mIdentity.name));
    setWindowFilePath(mDocument->filePath());
    setWindowModified(mDocument->isModified());
}

} // namespace ductus
