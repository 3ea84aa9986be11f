#include "sketchsurfacer/ui/window/surfacer_window.h"

#include "document/recovery/state_folder.h"
#include "sketchsurfacer/ui/presentation/ambiguity_presenter.h"
#include "sketchsurfacer/ui/viewport/length_text.h"
#include "sketchsurfacer/ui/viewport/turntable.h"
#include "sketchsurfacer/ui/window/measures_panel.h"
#include "sketchsurfacer/ui/window/parameter_panel.h"
#include "sketchsurfacer/ui/window/print_panel.h"
#include "sketchsurfacer/ui/window/reading_list.h"
#include "sketchsurfacer/ui/window/region_list.h"
#include "sketchsurfacer/ui/window/stroke_panel.h"
#include "sketchsurfacer/ui/window/surface_button.h"
#include "widgets/controls/segmented_switch.h"
#include "widgets/shell/message_bar.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/theme.h"

#include <QActionGroup>
#include <QFrame>
#include <QGuiApplication>
#include <QMouseEvent>
#include <QScreen>
#include <QStandardPaths>
#include <QVBoxLayout>
#include <algorithm>

namespace ductus {

namespace {

constexpr double worthAsking = 0.2; // from this ambiguity on a click offers other readings
constexpr int pictureDelayMs = 700; // a result has been drawn by then, and the view stands

} // namespace

SurfacerWindow::SurfacerWindow(const ShellServices &services, QWidget *parent)
    : MainWindowShell({tr("SketchSurfacer"), AppKind::SketchSurfacer, QStringLiteral("app-sketchsurfacer")},
                      services, parent),
      mSurfacing(mSketch, *services.jobs),
      mUnsaved(*this, mSketch, stateFolder(QStringLiteral("sketchsurfacer"), QStringLiteral("autosave"))),
      mRecent(*services.settings,
              QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + QStringLiteral("/recent")),
      mSamples(bundledSamples())
{
    mView = new SketchView;
    mView->setProperty("helpTopic", "canvas");
    mPresenter = new SketchPresenter(mSketch, jobs(), *mView, this);
    mAmbiguity = new AmbiguityPresenter(mSketch, jobs(), *mPresenter, *mView, this);
    mTools = new ToolBox(mSketch, *mPresenter, *mView, this);
    mTurntable = new Turntable(*mView, mView);
    setCanvas(mView);
    mSwitch = new SegmentedSwitch(
        tr("View"),
        {{tr("Sketch"), tr("The strokes alone."), icon(QStringLiteral("stroke"))},
         {tr("Proxy"), tr("The rough skin the strokes are read on."), icon(QStringLiteral("proxy"))},
         {tr("Regions"), tr("Which parts are one smooth surface each."), icon(QStringLiteral("regions"))},
         {tr("Surface"), tr("The finished surface in clay."), icon(QStringLiteral("surface"))},
         {tr("Deviation"), tr("How far strokes and surface are apart."), icon(QStringLiteral("deviation"))}});
    mSwitch->listenTo(this);
    setCentre(mSwitch);
    setDocument(&mSketch);
    addActions();
    addToolActions();
    addViewActions();
    fillMenus();
    fillInspector();
    fillStartPage();
    connectParts();
    mPresenter->setDark(coloursOf(QGuiApplication::palette()).isDark);
    setHint(mTools->hint());
    refreshSwitch();
    mUnsaved.look();
}

SurfacerWindow::~SurfacerWindow()
{
    mView->removeEventFilter(this);
    jobs().cancelAll();
    setDocument(nullptr);
    // Canvas, tools and presenter look at each other and at the document: in this order, before the members
    // go.
    delete mTools;
    delete mAmbiguity;
    delete mPresenter;
    setCanvas(nullptr);
}

void SurfacerWindow::fillInspector()
{
    auto *head = new SurfaceButton(mSketch, mSurfacing, jobs());
    connect(head, &SurfaceButton::surfaceRequested, this, &SurfacerWindow::surfaceIt);
    setInspectorHead(head);
    addSection(QStringLiteral("shape"), tr("Shape"), new ParameterPanel(mSketch));
    mRegions = new RegionList;
    addSection(QStringLiteral("regions"), tr("Regions"), mRegions);
    auto *readings = new ReadingList(*mAmbiguity);
    connect(readings, &ReadingList::lookRequested, this,
            [this] { actions().action(QStringLiteral("view.ambiguity"))->trigger(); });
    connect(readings, &ReadingList::chosen, mAmbiguity, &AmbiguityPresenter::choose);
    addSection(QStringLiteral("readings"), tr("Other readings"), readings);
    addSection(QStringLiteral("strokes"), tr("Strokes"), new StrokePanel(mSketch, *mPresenter, *mTools));
    mMeasures = new MeasuresPanel(mSketch);
    addSection(QStringLiteral("measures"), tr("Measures"), mMeasures);
    mPrint = new PrintPanel(mSketch, jobs());
    addSection(QStringLiteral("print"), tr("Print check"), mPrint);
    connect(mPrint, &PrintPanel::outdated, mView, &SketchView::clearMark);
    connect(mPrint, &PrintPanel::showRequested, this, [this](const FoundPlace &place) {
        if (mView->mode() == ViewMode::Sketch || mView->mode() == ViewMode::Proxy)
            showMode(ViewMode::Surface);
        mView->showMark({place.at, place.other, place.text});
    });
    connect(mRegions, &RegionList::lockToggled, mTools, &ToolBox::toggleLock);
    connect(mRegions, &RegionList::degreeChosen, mTools, &ToolBox::setDegree);
}

void SurfacerWindow::connectParts()
{
    connect(mSwitch, &SegmentedSwitch::shownChanged, this,
            [this](int index) { mView->setMode(ViewMode(index)); });
    connect(mSwitch, &SegmentedSwitch::currentChanged, this, [this] { mFollowsResult = false; });
    connect(&mSketch, &Document::changed, this, &SurfacerWindow::onDocumentChanged);
    connect(mPresenter, &SketchPresenter::resultShown, this, &SurfacerWindow::onResultShown);
    connect(mTools, &ToolBox::toolChanged, this, [this] { setHint(mTools->hint()); });
    connect(mTools, &ToolBox::regionClicked, this, [this](int region) { mRegions->choose(region); });
    connect(mTools, &ToolBox::refused, this, [this](const QString &why) { messages()->info(why); });
    connect(mTools, &ToolBox::surfaceClicked, this, &SurfacerWindow::offerReadings);
    connect(mAmbiguity, &AmbiguityPresenter::failed, this, [this](const Error &error) { showError(error); });
    connect(&mSurfacing, &SurfacingJobs::failed, this, [this](const Error &error) {
        mFollowsResult = false;
        showError(error, tr("Try again"), [this] { surfaceIt(); });
    });
    connect(&mSurfacing, &SurfacingJobs::noticed, this, [this](const QStringList &notes) {
        messages()->show(
            {MessageKind::Warning, notes.join(QLatin1Char(' ')), {}, {}, {}, QStringLiteral("notes"), 0});
    });
    connect(&mSurfacing, &SurfacingJobs::runningChanged, this, [this](bool running) {
        if (running)
            messages()->withdraw(QStringLiteral("notes"));
        refreshSwitch();
    });
    connect(mView, &VtkWidget::graphicsFailed, this, [this](const QString &reason) {
        messages()->warning(reason, tr("Install a graphics driver, or the software one: libgl1-mesa-dri."));
    });
    connect(this, &MainWindowShell::filesDropped, this, [this](const QStringList &paths) {
        for (const QString &path : paths)
            openPath(path);
    });
    connect(this, &MainWindowShell::themeChanged, this,
            [this] { mPresenter->setDark(coloursOf(QGuiApplication::palette()).isDark); });
    connect(this, &MainWindowShell::helpRequested, this, &SurfacerWindow::openManual);
    connect(&mUnsaved, &UnsavedWork::opened, this, [this] {
        mRecentPath.clear();
        showOpened();
    });
    connect(&mUnsaved.autosave(), &Autosave::aboutToWrite, this, [this] { mSketch.setPicture(picture()); });
    mPictureTimer.setSingleShot(true);
    mPictureTimer.setInterval(pictureDelayMs);
    connect(&mPictureTimer, &QTimer::timeout, this, &SurfacerWindow::refreshRecentPicture);
    mView->installEventFilter(this);
}

bool SurfacerWindow::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == mView && event->type() == QEvent::MouseMove)
        showPointerText(static_cast<QMouseEvent *>(event)->position());
    else if (watched == mView && event->type() == QEvent::Leave)
        setPointerText({});
    return MainWindowShell::eventFilter(watched, event);
}

void SurfacerWindow::showPointerText(const QPointF &position)
{
    const double metres = mSketch.strokes().metresPerUnit;
    const auto view = mPresenter->resultView();
    QStringList words;
    if (const std::optional<RayHit> hit = mView->surfaceAt(position)) {
        const int region = mPresenter->regionOf(*hit);
        if (view && region >= 0 && region < int(view->regionViews.size())) {
            const RegionView &data = view->regionViews[std::size_t(region)];
            words << surfaceKindName(data.degree) << areaText(data.area * metres * metres, locale());
            if (data.isLocked)
                words << tr("locked");
        }
        if (const std::optional<double> value = mAmbiguity->valueAt(*hit))
            words << tr("%1 % open").arg(qRound(100 * *value));
    }
    if (const int line = mView->strokeAt(position); line >= 0) {
        words << tr("stroke %1").arg(mPresenter->strokeId(line).value);
        const std::vector<StrokeId> found = mPresenter->foundBorders();
        if (std::find(found.begin(), found.end(), mPresenter->strokeId(line)) != found.end())
            words << tr("border found");
        if (view && line < int(view->deviationMap.strokeDistance.size()) &&
            !view->deviationMap.strokeDistance[std::size_t(line)].empty()) {
            const std::vector<double> &d = view->deviationMap.strokeDistance[std::size_t(line)];
            words << tr("at most %1 off")
                         .arg(lengthText(*std::max_element(d.begin(), d.end()) * metres, locale()));
        }
    }
    setPointerText(words.join(QStringLiteral("  ·  ")));
}

void SurfacerWindow::onDocumentChanged(const ChangeEvent &event)
{
    if (event.as<DocumentReset>()) {
        mFollowsResult = false;
        messages()->withdraw(QStringLiteral("notes"));
        mTools->setTool(ToolKind::Select);
        showMode(ViewMode::Sketch);
    }
    refreshSwitch();
    refreshEmptyText();
}

void SurfacerWindow::onResultShown()
{
    const auto view = mPresenter->resultView();
    mRegions->setResult(view, mSketch.strokes().metresPerUnit);
    mMeasures->setResult(view);
    mPrint->setResult(view);
    refreshSwitch();
    if (!view) {
        if (mView->mode() != ViewMode::Sketch)
            showMode(ViewMode::Sketch);
        return;
    }
    mPictureTimer.start();
    if (!mFollowsResult)
        return;
    showMode(view->isPreview ? ViewMode::Regions : ViewMode::Surface);
    if (!view->isPreview)
        mFollowsResult = false;
}

void SurfacerWindow::showMode(ViewMode mode)
{
    const QSignalBlocker blocker(mSwitch);
    mSwitch->setCurrent(int(mode));
    mView->setMode(mode);
}

void SurfacerWindow::showAmbiguity(bool on)
{
    if (on && mView->mode() != ViewMode::Regions && mPresenter->resultView())
        showMode(ViewMode::Regions);
    mAmbiguity->setOn(on);
}

void SurfacerWindow::offerReadings(const QPointF &position)
{
    const std::optional<RayHit> hit = mView->surfaceAt(position);
    const std::optional<double> value = hit ? mAmbiguity->valueAt(*hit) : std::nullopt;
    if (!mView->isAmbiguityShown() || !value || *value < worthAsking || mAmbiguity->shown()->readings.empty())
        return;
    auto *frame = new QFrame(this, Qt::Popup);
    frame->setObjectName(QStringLiteral("readingPopover"));
    frame->setFrameShape(QFrame::StyledPanel);
    frame->setAttribute(Qt::WA_DeleteOnClose);
    auto *rows = new QVBoxLayout(frame);
    rows->setContentsMargins(12, 12, 12, 12);
    auto *list = new ReadingList(*mAmbiguity);
    rows->addWidget(list);
    frame->setFixedWidth(290);
    connect(list, &ReadingList::chosen, frame, [this, frame](int reading) {
        frame->close();
        mAmbiguity->choose(reading);
    });
    frame->adjustSize();
    const QRect screen = mView->screen()->availableGeometry();
    QPoint corner = mView->mapToGlobal(position.toPoint()) + QPoint(12, 12);
    corner.setX(
        std::clamp(corner.x(), screen.left(), std::max(screen.left(), screen.right() - frame->width())));
    corner.setY(
        std::clamp(corner.y(), screen.top(), std::max(screen.top(), screen.bottom() - frame->height())));
    frame->move(corner);
    frame->show();
}

void SurfacerWindow::refreshSwitch()
{
    const auto view = mPresenter->resultView();
    const QString none = tr("Surface the sketch first.");
    const bool hasFinal = view && (mView->hasMesh(SceneItem::Surface));
    mSwitch->setDisabledReason(int(ViewMode::Proxy), view && view->proxy.mesh ? QString() : none);
    mSwitch->setDisabledReason(int(ViewMode::Regions), view && view->regions.mesh ? QString() : none);
    mSwitch->setDisabledReason(int(ViewMode::Surface), hasFinal ? QString() : none);
    mSwitch->setDisabledReason(int(ViewMode::Deviation), hasFinal ? QString() : none);
    actions().setDisabledReason("file.export", mSketch.result() ? QString() : none);
    actions().setDisabledReason("view.compare", hasFinal ? QString() : none);
}

void SurfacerWindow::refreshEmptyText()
{
    mView->overlay().setEmptyText(
        mSketch.isEmpty() ? tr("Nothing drawn yet. Press D and draw the first stroke, or drop a sketch here.")
                          : QString());
}

void SurfacerWindow::surfaceIt()
{
    mFollowsResult = true;
    mSurfacing.start();
}

void SurfacerWindow::escape()
{
    if (mView->cancelTool() || mView->clearMark())
        return;
    if (mSurfacing.isRunning()) {
        mFollowsResult = false;
        mSurfacing.cancel();
        return;
    }
    if (!mPresenter->selection().empty())
        mPresenter->setSelection({});
    else
        mToolActions->actions().first()->trigger();
}

} // namespace ductus
