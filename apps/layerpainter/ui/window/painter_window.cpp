#include "layerpainter/ui/window/painter_window.h"

#include "document/recovery/state_folder.h"
#include "document/settings/pressure_curve.h"
#include "layerpainter/document/default_view.h"
#include "layerpainter/film/film_plan.h"
#include "layerpainter/ui/panels/motion_tracks.h"
#include "painting/blend/blend.h"
#include "widgets/controls/folding_section.h"
#include "widgets/pages/tablet_page.h"
#include "widgets/shell/message_bar.h"

#include <QActionGroup>
#include <QStandardPaths>
#include <QVBoxLayout>

namespace ductus {

namespace {

Eigen::Vector3f linearOf(const QColor &colour)
{
    return linearFromEncoded({colour.redF(), colour.greenF(), colour.blueF()}).cast<float>();
}

} // namespace

PainterWindow::PainterWindow(const ShellServices &services, QWidget *parent)
    : MainWindowShell({tr("LayerPainter"), AppKind::LayerPainter, QStringLiteral("app-layerpainter")},
                      services, parent),
      mUnsaved(*this, mPainting, stateFolder(QStringLiteral("layerpainter"), QStringLiteral("autosave"))),
      mRecent(*services.settings,
              QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + QStringLiteral("/recent")),
      mPointColours(*services.jobs), mPaintTool(mPainting, mBrush), mEraseTool(mPainting, mBrush),
      mSelectTool(mPainting, mBrush), mMoveTool(mPainting), mGradientTool(mPainting, mBrush)
{
    mView = new PaintingView(mPainting);
    mView->setProperty("helpTopic", "canvas");
    setCanvas(mView);
    setDocument(&mPainting);
    addActions();
    addToolActions();
    addExchangeActions();
    fillMenus();
    fillInspector();
    auto *strip = new QWidget;
    auto *rows = new QVBoxLayout(strip);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    rows->addWidget(new LooksBar(mPainting));
    mMotion = new MotionBar(mPainting, *mView);
    rows->addWidget(mMotion);
    setStrip(strip);
    mColourList = new ColourList(mView);
    setMotionShown(false);
    fillStartPage();
    connectParts();
    setTool(PainterTool::Orbit);
    mUnsaved.look();
}

PainterWindow::~PainterWindow()
{
    jobs().cancelAll();
    mView->setTool(nullptr);
    setDocument(nullptr);
    setCanvas(nullptr);
}

void PainterWindow::fillInspector()
{
    mLayers = new LayerPanel(mPainting);
    addSection(QStringLiteral("layers"), tr("Layers"), mLayers);
    mBrushPanel = new BrushPanel(mBrush);
    addSection(QStringLiteral("brush"), tr("Brush"), mBrushPanel);
    mColours = new ColourPanel;
    addSection(QStringLiteral("colour"), tr("Colour"), mColours);
    mBrush.colour = linearOf(mColours->colour());
}

void PainterWindow::connectParts()
{
    connect(&mLayers->tree(), &LayerTree::layerChosen, this, &PainterWindow::setActiveLayer);
    connect(&mLayers->tree(), &LayerTree::layerHovered, this, [this](LayerId layer) {
        mView->setHoveredLayer(layer.isValid() ? std::optional(layer) : std::nullopt);
    });
    connect(mColours, &ColourPanel::colourChanged, this,
            [this](const QColor &colour) { mBrush.colour = linearOf(colour); });
    connect(mBrushPanel, &BrushPanel::brushChanged, mView, &PaintingView::updateMarks);
    connect(&mPainting, &Document::changed, this, &PainterWindow::onDocumentChanged);
    connect(&mPainting, &PaintingDocument::refused, this,
            [this](const Error &error) { messages()->show(error); });
    connect(&mLinkWatcher, &LinkWatcher::worthALook, this, [this] { lookForNewerSurfaces(false); });
    connect(mView, &PaintingView::graphicsFailed, this, [this](const Error &error) { showError(error); });
    connect(mView, &PaintingView::pointerMoved, this, &PainterWindow::showPointerText);
    connect(this, &MainWindowShell::helpRequested, this, &PainterWindow::openManual);
    connect(this, &MainWindowShell::filesDropped, this, &PainterWindow::takeDropped);
    mInspectTool.setAsk([this](const QPointF &position) { showColoursAt(position); });
    connect(mView, &PaintingView::viewMoved, mColourList, &QWidget::hide);
    connect(mColourList, &ColourList::layerChosen, this,
            [this](LayerId layer) { mLayers->tree().choose(layer); });
    connect(mColourList, &ColourList::layerHovered, this, [this](LayerId layer) {
        mView->setHoveredLayer(layer.isValid() ? std::optional(layer) : std::nullopt);
    });
    connect(mColourList, &ColourList::colourTaken, this, [this](const QColor &colour) {
        mColours->setColour(colour);
        mBrush.colour = linearOf(colour);
        mColourList->hide();
    });
    connect(&mUnsaved, &UnsavedWork::opened, this, &PainterWindow::showOpened);
    connect(&mUnsaved.autosave(), &Autosave::aboutToWrite, this,
            [this] { mPainting.setPicture(mView->picture()); });
    const auto useCurve = [this] {
        mView->setPressureCurve([curve = PressureCurve::fromText(settings().value(pressureCurveSetting))](
                                    double p) { return curve.map(p); });
    };
    useCurve();
    connect(&settings(), &Settings::changed, this, useCurve);
    setActiveLayer(mLayers->tree().currentLayer());
}

void PainterWindow::setActiveLayer(LayerId layer)
{
    mBrush.layer = layer;
    mMotion->tracks().setCurrentLayer(layer);
    setHint(mToolActions && mToolActions->checkedAction() ? mToolActions->checkedAction()->statusTip()
                                                          : QString());
}

void PainterWindow::setTool(PainterTool tool)
{
    CanvasTool *tools[] = {nullptr,     &mSelectTool,   &mMoveTool,   &mPaintTool,
                           &mEraseTool, &mGradientTool, &mInspectTool};
    mTool = tool;
    mColourList->hide();
    mView->setTool(tools[int(tool)]);
    QAction *action = mToolActions->actions().at(int(tool));
    action->setChecked(true);
    setHint(action->statusTip());
}

void PainterWindow::onDocumentChanged(const ChangeEvent &event)
{
    const auto *change = event.as<PaintingChanged>();
    if (!change || change->elements)
        mLinkWatcher.setFiles(linkedFiles(mPainting));
    if (!change) {
        mOffered.clear();
        mBrushPanel->setExtent(paintingBox(mPainting.painting()).diagonal());
        setTool(PainterTool::Orbit);
        setPointerText({});
        setMotionShown(motionSeconds(mPainting.painting()) > 0);
        return;
    }
    if (change->elements && mTool == PainterTool::Paint)
        mColours->remember();
    // What is gone cannot stay chosen.
    std::vector<ElementId> kept;
    for (const Layer *layer : mPainting.painting().layers())
        for (const Drawing &drawing : layer->drawings)
            for (const Element &element : drawing.elements)
                if (std::ranges::find(mView->selection(), element.id) != mView->selection().end())
                    kept.push_back(element.id);
    if (kept.size() != mView->selection().size())
        mView->setSelection(std::move(kept));
}

void PainterWindow::showPointerText(const QPointF &position)
{
    // Asking the card takes time a stroke needs.
    if (mTool == PainterTool::Paint || mTool == PainterTool::Erase)
        return;
    const auto picked = mView->pick(position);
    const Stack *stack = picked ? mPainting.painting().findStack(picked->stack) : nullptr;
    setPointerText(stack ? QString::fromStdString(stack->name) : QString());
}

void PainterWindow::showColoursAt(const QPointF &position)
{
    const PaintRay ray = mView->camera().ray(position);
    // Depth grows by one along it, as the layers' reach along the view is counted.
    const Vec3 direction = ray.direction / ray.direction.dot(mView->camera().forward());
    mPointColours.ask(
        mPainting.sharedPainting(), mView->seconds(), ray.origin, direction,
        [this, position, painting = mPainting.sharedPainting()](Result<std::optional<ColouredPoint>> point) {
            if (!point)
                showError(point.error());
            else if (*point)
                mColourList->show(*painting, **point, position.toPoint());
            else
                mColourList->hide();
        });
}

void PainterWindow::setMotionShown(bool shown)
{
    mMotion->setVisible(shown);
    actions().action(QStringLiteral("view.motion"))->setChecked(shown);
    if (!shown)
        mMotion->setPlaying(false);
}

void PainterWindow::deleteSelection()
{
    if (!mView->selection().empty())
        (void)mPainting.perform(act::Erase{mView->selection()});
}

void PainterWindow::duplicateSelection()
{
    if (mView->selection().empty()) {
        messages()->info(tr("Choose strokes first; the copies go into the active layer."));
        return;
    }
    const auto made = mPainting.perform(act::Duplicate{mView->selection(), mBrush.layer, 0, {}});
    if (!made)
        return;
    std::vector<ElementId> copies;
    for (const std::int32_t id : *made)
        copies.push_back(ElementId{id});
    mView->setSelection(std::move(copies));
    setTool(PainterTool::Move);
}

void PainterWindow::escape()
{
    if (mColourList->isVisible()) {
        mColourList->hide();
        return;
    }
    if (mView->cancelTool())
        return;
    if (!mView->selection().empty())
        mView->setSelection({});
    else
        setTool(PainterTool::Orbit);
}

} // namespace ductus
