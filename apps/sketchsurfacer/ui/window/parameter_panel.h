// ParameterPanel: the three sliders in plain words, and the symmetry.
#pragma once

#include "sketchsurfacer/document/sketch_document.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QLabel;

namespace ductus {

class NumberSlider;

class ParameterPanel : public QWidget
{
    Q_OBJECT
public:
    explicit ParameterPanel(SketchDocument &document, QWidget *parent = nullptr);

private:
    void refresh();
    void edit(const QString &text, const SurfaceOptions &options);
    void chooseSymmetry(int index);

    SketchDocument &mDocument;
    NumberSlider *mTightness;
    QCheckBox *mAutoTightness;
    NumberSlider *mLooseness;
    NumberSlider *mSimplicity;
    QComboBox *mSymmetry;
    QLabel *mSymmetryFound;
    quint64 mDrag = 0;
    bool mIsRefreshing = false;
};

} // namespace ductus
