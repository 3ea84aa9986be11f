// MaskList: the masks of a layer as chips, what the noise is like, and a button that adds one.
#pragma once

#include "layerpainter/document/painting_document.h"

#include <QWidget>

class QMenu;
class QVBoxLayout;

namespace ductus {

class MaskList : public QWidget
{
    Q_OBJECT
public:
    explicit MaskList(PaintingDocument &document, QWidget *parent = nullptr);

    void setLayer(LayerId layer);
    void addNoise();
    /// Slices of a block of opacities around the painting.
    void addTexture(const QStringList &pictures);
    /// Shows the layer only inside (or outside) the strokes of \a other.
    void addStrokes(LayerId other, bool inside);

private:
    void chooseTexture();
    void refresh();
    void addChip(std::size_t index, const Mask &mask);
    void addNoiseSliders(std::size_t index, const NoiseMask &noise);
    void fillMenu(QMenu &menu);
    std::optional<std::vector<Mask>> masks() const;
    void perform(std::vector<Mask> masks, quint64 drag = 0);

    PaintingDocument &mDocument;
    LayerId mLayer;
    std::vector<std::size_t> mShown; // kinds, so that sliders in use are not made anew
    QVBoxLayout *mRows;
    quint64 mDrag = 0;
};

} // namespace ductus
