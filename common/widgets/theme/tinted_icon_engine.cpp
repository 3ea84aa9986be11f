#include "widgets/theme/tinted_icon_engine.h"

#include "widgets/theme/theme.h"

#include <QGuiApplication>
#include <QPaintDevice>
#include <QPainter>
#include <QPixmapCache>
#include <QSvgRenderer>
#include <cmath>

namespace ductus {

namespace {

constexpr double smallUpTo = 20.0; // logical pixels

} // namespace

QColor TintedIconEngine::colourFor(QIcon::Mode mode, QIcon::State state) const
{
    const ThemeColours colours = coloursOf(QGuiApplication::palette());
    if (mode == QIcon::Disabled)
        return colours.disabled;
    switch (mTint) {
    case IconTint::Accent:
        return colours.accentText;
    case IconTint::Success:
        return colours.successText;
    case IconTint::Warning:
        return colours.warningText;
    case IconTint::Error:
        return colours.errorText;
    case IconTint::OnAccent:
        return colours.onAccent;
    case IconTint::Text:
        break;
    }
    return colours.text;
}

QPixmap TintedIconEngine::drawn(const QSize &pixels, const QColor &colour, qreal scale) const
{
    const bool isSmall = !mDrawings.smallFile.isEmpty() && pixels.height() / scale <= smallUpTo;
    const QString file = isSmall ? mDrawings.smallFile : mDrawings.file;
    const QString key = QStringLiteral("ductus:%1:%2x%3@%4:%5")
                            .arg(file)
                            .arg(pixels.width())
                            .arg(pixels.height())
                            .arg(scale)
                            .arg(colour.rgba(), 0, 16);
    QPixmap pixmap;
    if (QPixmapCache::find(key, &pixmap))
        return pixmap;

    QImage image(pixels, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    const int side = std::min(pixels.width(), pixels.height());
    // Breeze's 22 grid is a 24 one whose margin was left out. Whole pixels, or its lines lose their edges.
    const int drawnSide = mDrawings.grid == 22 && !isSmall ? int(std::lround(side * 22.0 / 24.0)) : side;
    const QPoint corner((pixels.width() - drawnSide) / 2, (pixels.height() - drawnSide) / 2);
    QSvgRenderer renderer(file);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    renderer.render(&painter, QRectF(corner, QSizeF(drawnSide, drawnSide)));
    painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
    painter.fillRect(image.rect(), colour);
    painter.end();
    pixmap = QPixmap::fromImage(image);
    pixmap.setDevicePixelRatio(scale);
    QPixmapCache::insert(key, pixmap);
    return pixmap;
}

void TintedIconEngine::paint(QPainter *painter, const QRect &rect, QIcon::Mode mode, QIcon::State state)
{
    const qreal scale = painter->device() ? painter->device()->devicePixelRatio() : 1.0;
    const QSize pixels(int(std::lround(rect.width() * scale)), int(std::lround(rect.height() * scale)));
    if (!pixels.isEmpty())
        painter->drawPixmap(rect.topLeft(), drawn(pixels, colourFor(mode, state), scale));
}

QPixmap TintedIconEngine::pixmap(const QSize &size, QIcon::Mode mode, QIcon::State state)
{
    return drawn(size, colourFor(mode, state), 1.0);
}

QPixmap TintedIconEngine::scaledPixmap(const QSize &size, QIcon::Mode mode, QIcon::State state, qreal scale)
{
    return drawn(size, colourFor(mode, state), scale);
}

} // namespace ductus
