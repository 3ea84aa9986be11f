// ColourList: the layers that colour a point, top to bottom, beside the point on the canvas. A row under the
// pointer highlights its layer, a click makes it the active one.
#pragma once

#include "layerpainter/ui/point/point_colours.h"

#include <QColor>
#include <QFrame>

class QVBoxLayout;

namespace ductus {

class ColourList : public QFrame
{
    Q_OBJECT
public:
    explicit ColourList(QWidget *canvas);

    /// \a at: the point, in the canvas; the list stands beside it.
    void show(const Painting &painting, const ColouredPoint &point, const QPoint &at);
    /// How many rows of layers it has, the shape's included.
    int rowCount() const { return mRowCount; }

signals:
    void layerChosen(ductus::LayerId layer);
    void layerHovered(ductus::LayerId layer); // invalid: none
    void colourTaken(const QColor &colour);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    void addRow(LayerId layer, const QString &name, const QString &how, const QColor &colour);

    QVBoxLayout *mRows;
    int mRowCount = 0;
};

} // namespace ductus
