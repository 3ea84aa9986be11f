// ViewOverlay: what lies flat above the scene: axes, scale bar, legend, what is under the pointer, the handle
// of the comparison, and what the tool draws. A widget of its own: it is repainted without drawing the scene
// anew.
#pragma once

#include "imaging/image.h"
#include "sketchsurfacer/ui/viewport/view_mark.h"

#include <QString>
#include <QWidget>
#include <optional>
#include <vector>

namespace ductus {

class SketchView;

/// A bar of colours.
struct ColourLegend
{
    QString title;
    std::vector<Rgba> colours; // evenly spaced, from 0
    double largestMetres = 0.0;
    QString low, high; // words for its ends instead of lengths; empty: lengths
};

class ViewOverlay : public QWidget
{
    Q_OBJECT
public:
    explicit ViewOverlay(SketchView &view);

    /// Of the deviation.
    void setLegend(const ColourLegend &legend);
    void setAmbiguityLegend(const ColourLegend &legend);
    void setEmptyText(const QString &text);
    void setMark(const std::optional<ViewMark> &mark);
    const std::optional<ViewMark> &mark() const { return mMark; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    void paintAxes(QPainter &painter) const;
    void paintScaleBar(QPainter &painter) const;
    void paintLegend(QPainter &painter) const;
    void paintDivider(QPainter &painter) const;

    SketchView &mView;
    ColourLegend mLegend, mAmbiguityLegend;
    QString mEmptyText;
    std::optional<ViewMark> mMark;
};

} // namespace ductus
