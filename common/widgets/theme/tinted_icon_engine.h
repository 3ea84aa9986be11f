// TintedIconEngine: draws a one-coloured SVG at the very size and pixel ratio it is needed in, in a colour
// taken from the application's palette when it is painted.
#pragma once

#include "widgets/theme/icons.h"

#include <QIconEngine>

namespace ductus {

/// A drawing and the grid it was made for; beside it one for small sizes.
struct IconDrawings
{
    QString file;
    int grid = 24;     // pixels; a 22 grid is drawn with a margin of one in 24, as its makers meant
    QString smallFile; // on a 16 grid, used up to 20 pixels; may be empty
};

class TintedIconEngine : public QIconEngine
{
public:
    TintedIconEngine(const IconDrawings &drawings, IconTint tint) : mDrawings(drawings), mTint(tint) {}

    void paint(QPainter *painter, const QRect &rect, QIcon::Mode mode, QIcon::State state) override;
    QPixmap pixmap(const QSize &size, QIcon::Mode mode, QIcon::State state) override;
    QPixmap scaledPixmap(const QSize &size, QIcon::Mode mode, QIcon::State state, qreal scale) override;
    QIconEngine *clone() const override { return new TintedIconEngine(*this); }
    QString key() const override { return QStringLiteral("ductus-tinted"); }
    bool isNull() override { return false; }

private:
    QPixmap drawn(const QSize &pixels, const QColor &colour, qreal scale) const;
    QColor colourFor(QIcon::Mode mode, QIcon::State state) const;

    IconDrawings mDrawings;
    IconTint mTint;
};

} // namespace ductus
