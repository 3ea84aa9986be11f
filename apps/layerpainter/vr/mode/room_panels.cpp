#include "layerpainter/vr/mode/room_panels.h"

#include "layerpainter/document/default_view.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace ductus {

namespace {

constexpr int panelWidth = 340; // logical pixels

} // namespace

RoomPanels::RoomPanels(PainterWindow &window, QObject *parent) : QObject(parent), mWindow(window)
{
    mLayers = new LayerPanel(window.painting());
    LayerTree &tree = mLayers->tree();
    tree.setDragEnabled(false); // a drag of Qt's would hold on to the mouse of the desktop
    LayerTree &desktop = window.layers().tree();
    tree.choose(desktop.currentLayer());
    connect(&tree, &LayerTree::layerChosen, &desktop, [&desktop](LayerId layer) { desktop.choose(layer); });
    connect(&desktop, &LayerTree::layerChosen, &tree, [&tree](LayerId layer) { tree.choose(layer); });
    connect(&tree, &LayerTree::layerHovered, this,
            [this](LayerId layer) { mHovered = layer.isValid() ? std::optional(layer) : std::nullopt; });
    const auto add = [this](const QString &title, QWidget *content) {
        auto surface = std::make_unique<PanelSurface>(title, content, panelWidth);
        connect(surface.get(), &PanelSurface::entered, this, &RoomPanels::entered);
        mRig.add(std::move(surface));
    };
    add(tr("Layers"), mLayers);
    add(tr("Brush and colour"), makeColourPage());
    add(tr("Tools"), makeToolPage());
}

QWidget *RoomPanels::makeColourPage()
{
    auto *page = new QWidget;
    auto *layout = new QVBoxLayout(page);
    layout->setContentsMargins(0, 0, 0, 0);
    const double halfWidth = mWindow.brush().halfWidth;
    mBrush = new BrushPanel(mWindow.brush());
    mBrush->setExtent(paintingBox(mWindow.painting().painting()).diagonal());
    mWindow.brush().halfWidth = halfWidth; // which the panel had set to the usual
    mBrush->step(0);
    layout->addWidget(mBrush);
    mColours = new ColourPanel;
    mColours->setColour(mWindow.colourPanel().colour());
    layout->addWidget(mColours);
    layout->addStretch();
    ColourPanel &desktop = mWindow.colourPanel();
    connect(mColours, &ColourPanel::colourChanged, &desktop, &ColourPanel::setColour);
    connect(&desktop, &ColourPanel::colourChanged, mColours, &ColourPanel::setColour);
    BrushPanel &desktopBrush = mWindow.brushPanel();
    // Each shows the brush's number; step(0) tells of it again, so one must not answer the other for ever.
    const auto mirror = [this](BrushPanel &from, BrushPanel &to) {
        connect(&from, &BrushPanel::brushChanged, &to, [&to] {
            const QSignalBlocker blocker(&to);
            to.step(0);
        });
    };
    mirror(*mBrush, desktopBrush);
    mirror(desktopBrush, *mBrush);
    return page;
}

QWidget *RoomPanels::makeToolPage()
{
    auto *page = new QWidget;
    auto *layout = new QVBoxLayout(page);
    layout->setContentsMargins(0, 0, 0, 0);
    auto *grid = new QGridLayout;
    int place = 0;
    for (const char *id : {"tool.paint", "tool.select", "edit.undo", "edit.redo", "edit.recolour",
                           "edit.duplicate", "edit.delete", "layer.add", "file.save"}) {
        QAction *action = mWindow.actions().action(QLatin1String(id));
        if (!action)
            continue;
        auto *button = new QToolButton;
        button->setDefaultAction(action);
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        button->setMinimumHeight(44); // a ray trembles
        button->setObjectName(QLatin1String(id));
        grid->addWidget(button, place / 2, place % 2);
        ++place;
    }
    layout->addLayout(grid);
    mLeftHanded = new QCheckBox(tr("Left-handed"));
    mLeftHanded->setToolTip(tr("The left hand paints, the right one holds the panels."));
    connect(mLeftHanded, &QCheckBox::toggled, this, &RoomPanels::leftHandedWanted);
    layout->addWidget(mLeftHanded);
    auto *leave = new QPushButton(tr("Leave VR"));
    leave->setMinimumHeight(40);
    connect(leave, &QPushButton::clicked, this, &RoomPanels::leaveWanted);
    layout->addWidget(leave);
    mTold = new QLabel;
    mTold->setWordWrap(true);
    mTold->setMinimumHeight(48);
    layout->addWidget(mTold);
    return page;
}

void RoomPanels::setLeftHanded(bool leftHanded)
{
    mLeftHanded->setChecked(leftHanded);
}

void RoomPanels::tell(const QString &text)
{
    mTold->setText(text);
}

} // namespace ductus
