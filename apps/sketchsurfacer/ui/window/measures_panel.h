// MeasuresPanel: size in real units, area, volume, watertight or not, how well the strokes are met; and the
// unit and up axis they are told in.
#pragma once

#include "sketchsurfacer/document/sketch_document.h"
#include "sketchsurfacer/ui/presentation/result_view.h"

#include <QWidget>

class QComboBox;
class QLabel;

namespace ductus {

class MeasuresPanel : public QWidget
{
    Q_OBJECT
public:
    explicit MeasuresPanel(SketchDocument &document, QWidget *parent = nullptr);

    void setResult(const std::shared_ptr<const ResultView> &view);

private:
    void refresh();

    SketchDocument &mDocument;
    std::shared_ptr<const ResultView> mResult;
    QLabel *mSize, *mStrokes, *mArea, *mVolume, *mWatertight, *mDeviation;
    QComboBox *mUnit, *mUp;
};

} // namespace ductus
