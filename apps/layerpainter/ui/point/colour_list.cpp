#include "layerpainter/ui/point/colour_list.h"

#include "layerpainter/ui/panels/blend_names.h"

#include <QEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

namespace ductus {

namespace {

QColor colourOf(const Eigen::Vector3d &encoded)
{
    const auto level = [](double x) { return float(std::clamp(x, 0.0, 1.0)); };
    return QColor::fromRgbF(level(encoded.x()), level(encoded.y()), level(encoded.z()));
}

QPixmap swatch(const QColor &colour, double ratio)
{
    QPixmap pixmap(QSize(18, 18) * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(QColor(0, 0, 0, 90), 1));
    painter.setBrush(colour);
    painter.drawRoundedRect(QRectF(0.5, 0.5, 17, 17), 3, 3);
    return pixmap;
}

} // namespace

ColourList::ColourList(QWidget *canvas) : QFrame(canvas)
{
    setObjectName(QStringLiteral("colourList"));
    setAccessibleName(tr("Layers that colour this point"));
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    setCursor(Qt::ArrowCursor);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(2);
    mRows = new QVBoxLayout;
    mRows->setSpacing(0);
    layout->addLayout(mRows);
    hide();
}

void ColourList::addRow(LayerId layer, const QString &name, const QString &how, const QColor &colour)
{
    auto *row = new QToolButton;
    row->setText(how.isEmpty() ? name : name + QStringLiteral("  ·  ") + how);
    row->setIcon(swatch(colour, devicePixelRatioF()));
    row->setIconSize({18, 18});
    row->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    row->setAutoRaise(true);
    row->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    row->setToolTip(tr("The point's colour with this layer and all below. Click: work in this layer."));
    row->setProperty("layer", layer.value);
    row->installEventFilter(this);
    connect(row, &QToolButton::clicked, this, [this, layer] { emit layerChosen(layer); });
    mRows->addWidget(row);
    ++mRowCount;
}

void ColourList::show(const Painting &painting, const ColouredPoint &point, const QPoint &at)
{
    while (QLayoutItem *item = mRows->takeAt(0)) {
        if (item->widget()) {
            item->widget()->hide();
            item->widget()->deleteLater();
        }
        delete item;
    }
    mRowCount = 0;
    const auto shown = [&](const Eigen::Vector3d &inBlendSpace) {
        return colourOf(encodedFromLinear(fromBlendSpace(point.blendSpace, inBlendSpace)));
    };
    const QColor result = colourOf(encodedFromLinear(point.colour.cast<double>()));
    auto *take = new QPushButton(tr("Paint with %1").arg(result.name()));
    take->setIcon(swatch(result, devicePixelRatioF()));
    connect(take, &QPushButton::clicked, this, [this, result] { emit colourTaken(result); });
    mRows->addWidget(take);
    for (const LayerColouring &colouring : point.layers) {
        const Layer *layer = painting.findLayer(colouring.layer);
        const Stack *stack = layer ? painting.stackOf(layer->id) : nullptr;
        if (!stack)
            continue;
        QString how = blendText(layer->properties.blendMode);
        if (colouring.opacity < 0.995)
            how += tr(" %1 %").arg(qRound(100 * colouring.opacity));
        if (!stack->substrate)
            how += tr(", whole scene");
        addRow(layer->id, QString::fromStdString(layer->name), how, shown(colouring.result));
    }
    if (const Stack *stack = painting.findStack(point.point.stackId); stack && stack->substrate)
        addRow(stack->substrate->id, QString::fromStdString(stack->name), tr("shape"),
               colourOf(encodedFromLinear(point.point.colour.cast<double>())));
    adjustSize();
    const QRect room = parentWidget()->rect().adjusted(8, 8, -8, -8);
    QPoint corner = at + QPoint(16, 8);
    if (corner.x() + width() > room.right())
        corner.setX(at.x() - 16 - width());
    corner.setX(std::max(room.left(), corner.x()));
    corner.setY(std::clamp(corner.y(), room.top(), std::max(room.top(), room.bottom() - height())));
    move(corner);
    QFrame::show();
    raise();
}

bool ColourList::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Enter || event->type() == QEvent::FocusIn)
        emit layerHovered(LayerId{watched->property("layer").toInt()});
    else if (event->type() == QEvent::Leave || event->type() == QEvent::FocusOut)
        emit layerHovered({});
    return QFrame::eventFilter(watched, event);
}

void ColourList::hideEvent(QHideEvent *event)
{
    emit layerHovered({});
    QFrame::hideEvent(event);
}

} // namespace ductus
