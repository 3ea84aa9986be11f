// LayerPanel: the tree of layers, buttons to add and remove, and what the chosen layer is mixed with.
#pragma once

#include "layerpainter/ui/panels/layer_tree.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QToolButton;
class QVBoxLayout;

namespace ductus {

class MaskList;
class NumberSlider;

class LayerPanel : public QWidget
{
    Q_OBJECT
public:
    explicit LayerPanel(PaintingDocument &document, QWidget *parent = nullptr);

    LayerTree &tree() { return *mTree; }
    void addStack();
    void addLayer();
    void duplicateLayer();
    void removeLayer();

private:
    void buildProperties(QVBoxLayout *layout);
    QToolButton *button(const QString &icon, const QString &name, const QString &teaches);
    void refresh();

    PaintingDocument &mDocument;
    LayerTree *mTree;
    QLineEdit *mFind; // where there are many
    NumberSlider *mOpacity;
    QComboBox *mBlend;
    NumberSlider *mTolerance;
    QWidget *mAppearance; // what only appearance layers have
    MaskList *mMasks;
    quint64 mDrag = 0;
};

} // namespace ductus
