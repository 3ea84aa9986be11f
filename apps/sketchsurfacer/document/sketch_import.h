// Sketches from files of other programs, from pasted text and from the bundled samples, checked before they
// become a document: for workers.
#pragma once

#include "formats/sketch_file.h"
#include "sketchsurfacer/document/sketch_content.h"

#include <QString>
#include <QStringList>

namespace ductus {

struct ImportedSketch
{
    StrokeSet strokes;
    SurfaceOptions options = defaultSurfaceOptions();
    QString name;         // for the title
    QStringList warnings; // what was passed over
    std::vector<int> cables; // strokes that were given the role Skeletal
    bool isPointCloud = false;
};

Result<ImportedSketch> importSketch(const QString &path, const JobControl &control);

/// \a text: any of the text formats, as pasted.
Result<ImportedSketch> importSketchText(const QByteArray &text, const QString &name,
                                        const JobControl &control);

struct SampleSketch
{
    QString id;     // "car"
    QString title;  // "Saloon car"
    QString lesson; // one line
    QString file;   // ":/samples/car.curves"
    std::vector<int> boundaryStrokes;
    std::optional<SymmetryPlane> symmetry;
};

/// Those of samples.json in the resources; empty if they were not built in.
std::vector<SampleSketch> bundledSamples();

Result<ImportedSketch> importSample(const SampleSketch &sample, const JobControl &control);

} // namespace ductus
