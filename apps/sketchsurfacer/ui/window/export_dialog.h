// ExportDialog: format, unit, what goes along; says how large the thing and the file will be.
#pragma once

#include "base/result.h"
#include "formats/mesh_file.h"
#include "strokes/stroke.h"
#include "surfacing/pipeline/surface_result.h"

#include <QDialog>
#include <QString>

class QCheckBox;
class QComboBox;
class QLabel;

namespace ductus {

struct ExportChoice
{
    QString extension = QStringLiteral(".obj"); // with the dot
    double metresPerExportUnit = 0.001;
    bool withRegions = true;
    bool withCreases = true;
};

/// \a surface scaled and turned as chosen: GLB is in metres with y up whatever was chosen.
MeshFileContent exportContent(const SurfaceResult &surface, const StrokeSet &sketch,
                              const ExportChoice &choice);

class ExportDialog : public QDialog
{
    Q_OBJECT
public:
    ExportDialog(std::shared_ptr<const SurfaceResult> surface, const StrokeSet &sketch,
                 const ExportChoice &before, QWidget *parent = nullptr);

    ExportChoice choice() const;

private:
    void refresh();

    std::shared_ptr<const SurfaceResult> mSurface;
    StrokeSet mSketch; // unit and axes alone
    QComboBox *mFormat;
    QComboBox *mUnit;
    QCheckBox *mRegions;
    QCheckBox *mCreases;
    QLabel *mSize;
};

} // namespace ductus
