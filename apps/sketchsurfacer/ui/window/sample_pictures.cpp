#include "sketchsurfacer/ui/window/sample_pictures.h"

#include "document/document_files.h"
#include "formats/png_file.h"
#include "imaging/surface_picture.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

namespace ductus {

namespace {

constexpr int drawingVersion = 1; // in the file names: a new way of drawing needs new pictures

Result<bool> drawOne(const SampleSketch &sample, bool dark, const JobControl &control)
{
    const Result<ImportedSketch> sketch = importSample(sample, control);
    if (!sketch)
        return sketch.error();
    PictureScene scene;
    const double diagonal = sketch->strokes.box().diagonal();
    for (const Stroke &stroke : sketch->strokes.strokes) {
        PictureLine line;
        line.points = stroke.points;
        line.radius = diagonal / 420;
        line.colour = dark ? Rgba{206, 216, 232, 255} : Rgba{48, 60, 96, 255};
        if (stroke.role == StrokeRole::Boundary)
            line.colour = {255, 158, 66, 255};
        scene.lines.push_back(std::move(line));
    }
    PictureOptions options;
    options.width = 480;
    options.height = 300;
    options.softLight = false;
    options.zUp = sketch->strokes.upAxis == UpAxis::Z;
    if (dark) {
        options.backgroundTop = {58, 63, 71, 255};
        options.backgroundBottom = {34, 37, 42, 255};
    }
    const QString path = samplePicturePath(sample, dark);
    QDir().mkpath(QFileInfo(path).path());
    if (Result<void> written = writePng(renderPicture(scene, options), enginePath(path)); !written)
        return written.error();
    return true;
}

} // namespace

QString samplePicturePath(const SampleSketch &sample, bool dark)
{
    return QStringLiteral("%1/samples/%2-%3-%4.png")
        .arg(QStandardPaths::writableLocation(QStandardPaths::CacheLocation), sample.id,
             dark ? QStringLiteral("dark") : QStringLiteral("light"))
        .arg(drawingVersion);
}

void drawSamplePictures(JobRunner &runner, const std::vector<SampleSketch> &samples, bool dark,
                        QObject *receiver, std::function<void()> drawn)
{
    std::vector<SampleSketch> missing;
    for (const SampleSketch &sample : samples)
        if (!QFileInfo::exists(samplePicturePath(sample, dark)))
            missing.push_back(sample);
    if (missing.empty())
        return;
    auto work = [missing, dark](const JobControl &control) -> Result<bool> {
        for (const SampleSketch &sample : missing) {
            if (control.isCancelled())
                return cancelledError("Drawing the samples");
            if (const Result<bool> one = drawOne(sample, dark, control); !one)
                return one;
        }
        return true;
    };
    // Without pictures the cards still have their words: nothing to tell anybody about.
    runner.start<bool>({QStringLiteral("sample-pictures"), {}, true}, receiver, work,
                       [drawn](Result<bool> done) {
                           if (done)
                               drawn();
                       });
}

} // namespace ductus
