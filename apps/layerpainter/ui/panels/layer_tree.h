// LayerTree: stacks with their layers as a tree: drag to reorder or re-parent, F2 renames, the eye shows and
// hides, the lock locks. Rows stand as the painting is built: what acts last is on top.
#pragma once

#include "layerpainter/document/painting_document.h"

#include <QTreeWidget>

namespace ductus {

class LayerTree : public QTreeWidget
{
    Q_OBJECT
public:
    explicit LayerTree(PaintingDocument &document, QWidget *parent = nullptr);

    /// The chosen row's layer: a substrate for a stack's row; invalid for the scene's.
    LayerId currentLayer() const;
    /// The stack the chosen row belongs to.
    StackId currentStack() const;
    void choose(LayerId layer);
    void renameCurrent();
    /// Shows only rows whose name has \a part in it, with the stack around them; empty: all.
    void setFilter(const QString &part);

signals:
    void layerChosen(ductus::LayerId layer);
    void layerHovered(ductus::LayerId layer); // invalid: none

protected:
    void dropEvent(QDropEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void leaveEvent(QEvent *event) override;

private:
    void refresh();
    void applyFilter();
    void fillRow(QTreeWidgetItem *item, const Layer &layer);
    QTreeWidgetItem *rowOf(LayerId layer) const;
    void onClicked(QTreeWidgetItem *item, int column);
    void onEdited(QTreeWidgetItem *item);

    PaintingDocument &mDocument;
    QString mFilter;
    bool mIsFilling = false;
};

} // namespace ductus
