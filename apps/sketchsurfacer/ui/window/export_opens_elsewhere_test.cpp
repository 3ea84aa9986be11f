// "I export the surface and open it in another program": what was written is read with VTK's readers, which
// share no code with our writers.
#include "sketchsurfacer/document/sketch_content.h"
#include "sketchsurfacer/document/sketch_import.h"
#include "sketchsurfacer/ui/window/export_dialog.h"

#include "document/document_files.h"
#include "surfacing/pipeline/surface_pipeline.h"

#include <QTemporaryDir>
#include <QtTest>
#include <set>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkCompositeDataIterator.h>
#include <vtkDataArray.h>
#include <vtkGLTFReader.h>
#include <vtkIdList.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>

using namespace ductus;

namespace {

struct Reading // what another program sees
{
    int triangles = 0;
    int otherCells = 0;
    int parts = 0;        // blocks of the scene
    Box3 box;             // of the corners of triangles
    double volume = 0.0;  // signed: positive if triangles look outward
    std::set<int> groups; // where the reader tells
};

void add(vtkPolyData *data, Reading &reading)
{
    vtkDataArray *groups = data->GetCellData()->GetArray("GroupIds");
    // One a triangle, while VTK's cells begin with the lines.
    for (vtkIdType i = 0; groups && i < groups->GetNumberOfTuples(); ++i)
        reading.groups.insert(int(groups->GetComponent(i, 0)));
    vtkNew<vtkIdList> corners;
    for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell) {
        data->GetCellPoints(cell, corners);
        if (data->GetCellType(cell) != VTK_TRIANGLE) {
            ++reading.otherCells;
            continue;
        }
        Vec3 p[3];
        for (int k = 0; k < 3; ++k) {
            data->GetPoint(corners->GetId(k), p[k].data());
            reading.box.add(p[k]);
        }
        reading.volume += p[0].dot(p[1].cross(p[2])) / 6.0;
        ++reading.triangles;
    }
    ++reading.parts;
}

template <typename Reader>
Reading readWith(const QString &path)
{
    vtkNew<Reader> reader;
    reader->SetFileName(path.toUtf8().constData());
    reader->Update();
    Reading reading;
    if constexpr (std::is_same_v<Reader, vtkGLTFReader>) {
        vtkMultiBlockDataSet *scene = reader->GetOutput();
        if (!scene)
            return reading;
        vtkSmartPointer<vtkCompositeDataIterator> block;
        block.TakeReference(scene->NewIterator());
        for (block->InitTraversal(); !block->IsDoneWithTraversal(); block->GoToNextItem())
            if (auto *data = vtkPolyData::SafeDownCast(block->GetCurrentDataObject()))
                add(data, reading);
    } else {
        add(reader->GetOutput(), reading);
    }
    return reading;
}

Reading readElsewhere(const QString &path)
{
    if (path.endsWith(".obj"))
        return readWith<vtkOBJReader>(path);
    if (path.endsWith(".ply"))
        return readWith<vtkPLYReader>(path);
    if (path.endsWith(".stl"))
        return readWith<vtkSTLReader>(path);
    return readWith<vtkGLTFReader>(path);
}

} // namespace

class ExportOpensElsewhereTest : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void theSameSurfaceIsRead_data();
    void theSameSurfaceIsRead();

private:
    StrokeSet mSketch;
    SurfaceResult mSurface;
};

void ExportOpensElsewhereTest::initTestCase()
{
    const std::vector<SampleSketch> samples = bundledSamples();
    const auto sample = std::find_if(samples.begin(), samples.end(),
                                     [](const SampleSketch &s) { return s.id == "bevelled-box"; });
    QVERIFY(sample != samples.end());
    Result<ImportedSketch> sketch = importSample(*sample, {});
    QVERIFY(sketch.ok());
    SurfaceOptions options = sketch->options;
    options.proxy.targetVertices = 2500;
    Result<SurfaceResult> surface = surfaceSketch(sketch->strokes, {}, options, {});
    QVERIFY2(surface.ok(), surface.ok() ? "" : surface.error().message().c_str());
    mSketch = std::move(sketch->strokes);
    mSurface = std::move(*surface);
    mSketch.metresPerUnit = 0.02;
    mSketch.upAxis = UpAxis::Z;
    QVERIFY(mSurface.regions.size() > 5 && !mSurface.featureLines.empty());
}

void ExportOpensElsewhereTest::theSameSurfaceIsRead_data()
{
    QTest::addColumn<QString>("extension");
    QTest::addColumn<double>("metresPerExportUnit");
    QTest::addColumn<double>("scale"); // from the sketch's unit to the file's
    QTest::newRow("obj in millimetres") << ".obj" << 0.001 << 20.0;
    QTest::newRow("obj in inches") << ".obj" << 0.0254 << 0.02 / 0.0254;
    QTest::newRow("ply in centimetres") << ".ply" << 0.01 << 2.0;
    QTest::newRow("stl in millimetres") << ".stl" << 0.001 << 20.0;
    QTest::newRow("glb is in metres, whatever was asked") << ".glb" << 0.001 << 0.02;
}

void ExportOpensElsewhereTest::theSameSurfaceIsRead()
{
    QFETCH(QString, extension);
    QFETCH(double, metresPerExportUnit);
    QFETCH(double, scale);
    const bool isGlb = extension == QLatin1String(".glb"), isObj = extension == QLatin1String(".obj");
    QTemporaryDir folder;
    const QString path = folder.filePath("surface" + extension);
    const Result<void> written = writeMesh(
        exportContent(mSurface, mSketch, {extension, metresPerExportUnit, true, true}), enginePath(path), {});
    QVERIFY2(written.ok(), written.ok() ? "" : written.error().message().c_str());
    const Reading reading = readElsewhere(path);

    QCOMPARE(reading.triangles, mSurface.mesh.triangleCount());
    const double volume = signedVolume(mSurface.mesh) * scale * scale * scale;
    QVERIFY(volume > 0.0);
    QVERIFY2(std::abs(reading.volume - volume) < 1e-4 * volume, qPrintable(QString::number(reading.volume)));
    const Box3 box = boundingBox(mSurface.mesh.vertices);
    Vec3 low = box.min * scale, high = box.max * scale;
    if (isGlb) { // z up becomes y up: (x, y, z) -> (x, z, -y)
        low = Vec3(scale * box.min.x(), scale * box.min.z(), -scale * box.max.y());
        high = Vec3(scale * box.max.x(), scale * box.max.z(), -scale * box.min.y());
    }
    const double tolerance = 1e-6 * (high - low).norm(); // 32-bit floats
    QVERIFY2((reading.box.min - low).norm() < tolerance && (reading.box.max - high).norm() < tolerance,
             qPrintable(QString("%1 is wide, %2 expected")
                            .arg((reading.box.max - reading.box.min).x())
                            .arg((high - low).x())));

    std::set<int> regions(mSurface.triangleRegions.begin(), mSurface.triangleRegions.end());
    if (isObj)
        QCOMPARE(reading.groups.size(), regions.size());
    if (isGlb)
        QCOMPARE(reading.parts, int(regions.size()));
    // Creases are lines where the format has them, and disturb nobody elsewhere.
    QCOMPARE(reading.otherCells > 0, isObj);
}

QTEST_GUILESS_MAIN(ExportOpensElsewhereTest)
#include "export_opens_elsewhere_test.moc"
