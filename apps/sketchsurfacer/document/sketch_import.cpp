#include "sketchsurfacer/document/sketch_import.h"

#include "document/document_files.h"
#include "surfacing/parts/cable_proposal.h"
#include "surfacing/sketch/point_cloud.h"

#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace ductus {

namespace {

Result<ImportedSketch> imported(Result<SketchFile> file, const QString &name, const std::string &place,
                                const JobControl &control)
{
    if (!file)
        return file.error();
    if (file->strokes.strokes.empty())
        return Error{ErrorCode::TooLittleData, "Reading the sketch", "there is no stroke in it",
                     "Choose a file with 3D strokes", place};
    if (file->isPointCloud)
        if (const Result<void> isSurface = checkCloudIsSurface(file->strokes); !isSurface) {
            Error error = isSurface.error();
            error.attempted = "Reading the points";
            error.place = place;
            return error;
        }
    ImportedSketch sketch;
    sketch.isPointCloud = file->isPointCloud;
    sketch.strokes = std::move(file->strokes);
    sketch.name = name;
    for (const std::string &warning : file->warnings)
        sketch.warnings << QString::fromStdString(warning);
    if (!sketch.isPointCloud) {
        Result<std::vector<int>> cables = markCables(sketch.strokes, {}, control);
        if (!cables)
            return cables.error();
        sketch.cables = std::move(*cables);
    }
    return sketch;
}

} // namespace

Result<ImportedSketch> importSketch(const QString &path, const JobControl &control)
{
    const QFileInfo info(path);
    return imported(readSketch(enginePath(path), {}, control), info.completeBaseName(),
                    info.fileName().toStdString(), control);
}

Result<ImportedSketch> importSketchText(const QByteArray &text, const QString &name,
                                        const JobControl &control)
{
    const std::string_view bytes(text.constData(), std::size_t(text.size()));
    return imported(parseSketch(bytes, name.toStdString(), {}, control), name, name.toStdString(), control);
}

std::vector<SampleSketch> bundledSamples()
{
    std::vector<SampleSketch> samples;
    QFile index(QStringLiteral(":/samples/samples.json"));
    if (!index.open(QIODevice::ReadOnly))
        return samples;
    const QJsonArray list = QJsonDocument::fromJson(index.readAll()).object().value(u"samples").toArray();
    for (const QJsonValue &value : list) {
        const QJsonObject entry = value.toObject();
        SampleSketch sample;
        sample.id = entry.value(u"id").toString();
        sample.title = entry.value(u"title").toString();
        sample.lesson = entry.value(u"lesson").toString();
        sample.file = QStringLiteral(":/samples/") + entry.value(u"file").toString();
        for (const QJsonValue &stroke : entry.value(u"boundaryStrokes").toArray())
            sample.boundaryStrokes.push_back(stroke.toInt());
        const QJsonArray plane = entry.value(u"symmetry").toArray();
        if (plane.size() == 4) {
            const Vec3 normal(plane[0].toDouble(), plane[1].toDouble(), plane[2].toDouble());
            sample.symmetry = SymmetryPlane{normal.normalized(), plane[3].toDouble() / normal.norm()};
        }
        samples.push_back(std::move(sample));
    }
    return samples;
}

Result<ImportedSketch> importSample(const SampleSketch &sample, const JobControl &control)
{
    QFile file(sample.file);
    if (!file.open(QIODevice::ReadOnly))
        return Error{ErrorCode::FileNotFound, "Opening the sample", "it is not part of this installation",
                     "Install SketchSurfacer again", sample.id.toStdString()};
    Result<ImportedSketch> sketch =
        importSketchText(file.readAll(), QFileInfo(sample.file).fileName(), control);
    if (!sketch)
        return sketch;
    sketch->name = sample.title;
    for (int index : sample.boundaryStrokes)
        if (index >= 0 && index < int(sketch->strokes.strokes.size()))
            sketch->strokes.strokes[std::size_t(index)].role = StrokeRole::Boundary;
    sketch->options.symmetry = sample.symmetry ? SymmetryMode::Given : SymmetryMode::None;
    if (sample.symmetry)
        sketch->options.symmetryPlane = *sample.symmetry;
    return sketch;
}

} // namespace ductus
