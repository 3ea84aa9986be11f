#include "sketchsurfacer/ui/viewport/view_overlay.h"

#include "sketchsurfacer/ui/viewport/length_text.h"
#include "sketchsurfacer/ui/viewport/sketch_view.h"

#include <QPainter>
#include <algorithm>

namespace ductus {

namespace {

constexpr int margin = 16;

QColor inkOf(const SketchView &view)
{
    return view.isDark() ? QColor(232, 234, 237) : QColor(29, 33, 38);
}

QColor dimInkOf(const SketchView &view)
{
    return view.isDark() ? QColor(190, 196, 205) : QColor(75, 83, 94);
}

} // namespace

ViewOverlay::ViewOverlay(SketchView &view) : QWidget(&view), mView(view)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
}

void ViewOverlay::setAmbiguityLegend(const ColourLegend &legend)
{
    mAmbiguityLegend = legend;
    update();
}

void ViewOverlay::setLegend(const ColourLegend &legend)
{
    mLegend = legend;
    update();
}

void ViewOverlay::setEmptyText(const QString &text)
{
    if (mEmptyText == text)
        return;
    mEmptyText = text;
    update();
}

void ViewOverlay::setMark(const std::optional<ViewMark> &mark)
{
    mMark = mark;
    update();
}

void ViewOverlay::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintDivider(painter);
    if (const ViewTool *tool = mView.tool())
        tool->paint(painter, mView);
    if (mMark)
        paintMark(painter, mView.camera(), *mMark);
    paintAxes(painter);
    paintScaleBar(painter);
    paintLegend(painter);
    if (!mEmptyText.isEmpty()) {
        painter.setPen(dimInkOf(mView));
        painter.drawText(rect().adjusted(40, 40, -40, -40), Qt::AlignCenter | Qt::TextWordWrap, mEmptyText);
    }
}

void ViewOverlay::paintAxes(QPainter &painter) const
{
    const ViewCamera &camera = mView.camera();
    const QPointF centre(margin + 26, height() - margin - 26);
    struct Axis
    {
        Vec3 direction;
        QColor colour;
        QString name;
    };
    Axis axes[] = {{Vec3::UnitX(), QColor(0xe0, 0x60, 0x55), QStringLiteral("x")},
                   {Vec3::UnitY(), QColor(0x5f, 0xb0, 0x5a), QStringLiteral("y")},
                   {Vec3::UnitZ(), QColor(0x55, 0x92, 0xe6), QStringLiteral("z")}};
    std::sort(std::begin(axes), std::end(axes), [&](const Axis &a, const Axis &b) {
        return a.direction.dot(camera.forward()) > b.direction.dot(camera.forward()); // far ones first
    });
    QFont font = painter.font();
    font.setPointSizeF(font.pointSizeF() * 0.85);
    painter.save();
    painter.setFont(font);
    for (const Axis &axis : axes) {
        const QPointF tip(axis.direction.dot(camera.right()), -axis.direction.dot(camera.up()));
        QColor colour = axis.colour;
        if (axis.direction.dot(camera.forward()) > 0.3)
            colour.setAlpha(130);
        painter.setPen(QPen(colour, 2.0, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(centre, centre + 18 * tip);
        const QPointF at = centre + 27 * tip;
        painter.drawText(QRectF(at.x() - 8, at.y() - 8, 16, 16), Qt::AlignCenter, axis.name);
    }
    painter.restore();
}

void ViewOverlay::paintScaleBar(QPainter &painter) const
{
    if (mView.extent().isEmpty())
        return;
    const ViewCamera &camera = mView.camera();
    const double metresPerPixel = camera.unitsPerPixel(mView.extent().centre()) * mView.metresPerUnit();
    const double metres = roundLength(120.0 * metresPerPixel);
    if (!(metres > 0.0))
        return;
    const double length = metres / metresPerPixel;
    const double x = 2 * margin + 66, y = height() - margin - 10;
    painter.setPen(QPen(dimInkOf(mView), 1.5));
    painter.drawLine(QPointF(x, y), QPointF(x + length, y));
    painter.drawLine(QPointF(x, y - 4), QPointF(x, y + 4));
    painter.drawLine(QPointF(x + length, y - 4), QPointF(x + length, y + 4));
    painter.drawText(QRectF(x - 40, y - 24, length + 80, 18), Qt::AlignCenter, lengthText(metres, locale()));
}

void ViewOverlay::paintLegend(QPainter &painter) const
{
    const bool isAmbiguity =
        mView.mode() == ViewMode::Regions && mView.isAmbiguityShown() && mView.hasMesh(SceneItem::Ambiguity);
    const ColourLegend &legend = isAmbiguity ? mAmbiguityLegend : mLegend;
    if ((mView.mode() != ViewMode::Deviation && !isAmbiguity) || legend.colours.empty())
        return;
    const QRectF bar(width() - margin - 14, 0.5 * height() - 110, 14, 220);
    QLinearGradient gradient(bar.bottomLeft(), bar.topLeft());
    const int last = std::max(1, int(legend.colours.size()) - 1);
    for (int i = 0; i < int(legend.colours.size()); ++i) {
        const Rgba &c = legend.colours[std::size_t(i)];
        gradient.setColorAt(double(i) / last, QColor(c[0], c[1], c[2]));
    }
    painter.setPen(QPen(dimInkOf(mView), 1));
    painter.setBrush(gradient);
    painter.drawRoundedRect(bar, 3, 3);
    painter.setPen(inkOf(mView));
    for (int i = 0; i <= 4; ++i) {
        if (!legend.low.isEmpty() && i % 4 != 0)
            continue;
        const double share = i / 4.0;
        const double y = bar.bottom() - share * bar.height();
        painter.drawText(QRectF(bar.left() - 128, y - 9, 120, 18), Qt::AlignRight | Qt::AlignVCenter,
                         !legend.low.isEmpty() ? (i == 0 ? legend.low : legend.high)
                                               : (i == 4 ? QStringLiteral("≥ ") : QString()) +
                                                     lengthText(share * legend.largestMetres, locale()));
    }
    painter.drawText(QRectF(bar.right() - 260, bar.top() - 34, 260, 18), Qt::AlignRight, legend.title);
}

void ViewOverlay::paintDivider(QPainter &painter) const
{
    if (!mView.comparison() || mView.mode() == ViewMode::Sketch)
        return;
    const double x = *mView.comparison() * width();
    painter.setPen(QPen(inkOf(mView), 1.5));
    painter.drawLine(QPointF(x, 0), QPointF(x, height()));
    painter.setBrush(mView.isDark() ? QColor(48, 52, 58) : QColor(255, 255, 255));
    const QPointF c(x, 0.5 * height());
    painter.drawEllipse(c, 14, 14);
    for (const int side : {-1, 1}) {
        const QPointF arrow[3] = {c + QPointF(side * 3.5, -5), c + QPointF(side * 8.5, 0),
                                  c + QPointF(side * 3.5, 5)};
        painter.drawPolyline(arrow, 3);
    }
}

} // namespace ductus
