// What we write is read by programs that share no code with us: assimp (OBJ, PLY, STL, GLB) and CGAL (OBJ,
// PLY, STL, OFF). Counts, box, orientation and groups must be those of the mesh that was written.
#include "formats/mesh_file.h"
#include "support/mesh_zoo.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>
#include <QTemporaryDir>
#include <QtTest>
#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <cmath>

using namespace ductus;

namespace {

// A ball of 2 by 3 by 4 millimetres per unit, off the origin, its upper half a region of its own.
MeshFileContent ball()
{
    MeshFileContent content;
    content.mesh = zoo::icosphere(3);
    for (Vec3 &v : content.mesh.vertices)
        v = Vec3(2.0, 3.0, 4.0).cwiseProduct(v) + Vec3(10.0, -20.0, 5.0);
    for (int t = 0; t < content.mesh.triangleCount(); ++t)
        content.triangleRegions.push_back(content.mesh.centroid(t).y() > -20.0 ? 1 : 0);
    content.featureLines = {{content.mesh.triangles[0][0], content.mesh.triangles[0][1]}};
    content.comment = "a ball";
    return content;
}

std::vector<int> trianglesOfRegions(const MeshFileContent &content)
{
    std::vector<int> counts(2, 0);
    for (int region : content.triangleRegions)
        ++counts[std::size_t(region)];
    return counts;
}

// All corners apart, as a reader without our merging sees them.
struct Seen
{
    std::vector<std::array<Vec3, 3>> triangles;
    std::vector<int> trianglesOfGroup; // ascending
    std::vector<std::string> groupNames;
};

double volumeOf(const Seen &seen)
{
    double volume = 0.0;
    for (const auto &[a, b, c] : seen.triangles)
        volume += a.dot(b.cross(c)) / 6.0;
    return volume;
}

Box3 boxOf(const Seen &seen)
{
    Box3 box;
    for (const auto &corners : seen.triangles)
        for (const Vec3 &corner : corners)
            box.add(corner);
    return box;
}

bool seenByAssimp(const QString &path, Seen &seen, QString &problem)
{
    Assimp::Importer importer;
    const aiScene *scene = importer.ReadFile(path.toStdString(), aiProcess_PreTransformVertices);
    if (!scene) {
        problem = QString::fromUtf8(importer.GetErrorString());
        return false;
    }
    for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
        const aiMesh &mesh = *scene->mMeshes[m];
        int triangles = 0;
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            const aiFace &face = mesh.mFaces[f];
            if (face.mNumIndices != 3)
                continue; // feature lines
            std::array<Vec3, 3> corners;
            for (unsigned k = 0; k < 3; ++k) {
                const aiVector3D &v = mesh.mVertices[face.mIndices[k]];
                corners[k] = Vec3(v.x, v.y, v.z);
            }
            seen.triangles.push_back(corners);
            ++triangles;
        }
        if (triangles > 0) {
            seen.trianglesOfGroup.push_back(triangles);
            seen.groupNames.push_back(mesh.mName.C_Str());
        }
    }
    std::sort(seen.trianglesOfGroup.begin(), seen.trianglesOfGroup.end());
    return true;
}

bool seenByCgal(const QString &path, Seen &seen, QString &problem)
{
    std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
    std::vector<std::vector<std::size_t>> polygons;
    if (!CGAL::IO::read_polygon_soup(path.toStdString(), points, polygons)) {
        problem = QStringLiteral("CGAL does not read it");
        return false;
    }
    for (const std::vector<std::size_t> &polygon : polygons) {
        if (polygon.size() != 3) {
            problem = QStringLiteral("a polygon of %1 corners").arg(polygon.size());
            return false;
        }
        std::array<Vec3, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto &p = points[polygon[k]];
            corners[k] = Vec3(p.x(), p.y(), p.z());
        }
        seen.triangles.push_back(corners);
    }
    return true;
}

} // namespace

class ExportsReadElsewhereTest : public QObject
{
    Q_OBJECT
private slots:
    void othersReadWhatWeWrite_data();
    void othersReadWhatWeWrite();
    void groupsAreRegions_data();
    void groupsAreRegions();
    void coloursOfVerticesAreRead();
};

void ExportsReadElsewhereTest::othersReadWhatWeWrite_data()
{
    QTest::addColumn<QString>("extension");
    QTest::addColumn<bool>("byAssimp");
    for (const char *extension : {"obj", "ply", "stl", "glb"})
        QTest::addRow("assimp %s", extension) << extension << true;
    for (const char *extension : {"obj", "ply", "stl", "off"})
        QTest::addRow("CGAL %s", extension) << extension << false;
}

void ExportsReadElsewhereTest::othersReadWhatWeWrite()
{
    QFETCH(QString, extension);
    QFETCH(bool, byAssimp);
    QTemporaryDir folder;
    const QString path = folder.filePath("ball." + extension);
    MeshFileContent content = ball();
    if (!byAssimp)
        content.featureLines.clear(); // CGAL 5.5 gives up at the "l" records that OBJ has for lines
    QVERIFY(writeMesh(content, path.toStdString(), JobControl()).ok());
    Seen seen;
    QString problem;
    const bool isRead = byAssimp ? seenByAssimp(path, seen, problem) : seenByCgal(path, seen, problem);
    QVERIFY2(isRead, qPrintable(problem));
    QCOMPARE(int(seen.triangles.size()), content.mesh.triangleCount());
    // STL and GLB hold 32-bit floats, and assimp does so for all.
    const Box3 expected = boundingBox(content.mesh.vertices), box = boxOf(seen);
    QVERIFY((box.min - expected.min).norm() < 1e-5 && (box.max - expected.max).norm() < 1e-5);
    const double volume = volumeOf(seen);
    QVERIFY2(volume > 0.0, "the mesh is inside out");
    QVERIFY(std::abs(volume - signedVolume(content.mesh)) < 1e-3 * volume);
}

void ExportsReadElsewhereTest::groupsAreRegions_data()
{
    QTest::addColumn<QString>("extension");
    QTest::newRow("obj") << "obj";
    QTest::newRow("glb") << "glb";
}

void ExportsReadElsewhereTest::groupsAreRegions()
{
    QFETCH(QString, extension);
    QTemporaryDir folder;
    const QString path = folder.filePath("ball." + extension);
    const MeshFileContent content = ball();
    QVERIFY(writeMesh(content, path.toStdString(), JobControl()).ok());
    // Without transforms baked in, which would join the groups again.
    Assimp::Importer importer;
    const aiScene *scene = importer.ReadFile(path.toStdString(), 0);
    QVERIFY2(scene, importer.GetErrorString());
    std::vector<int> counts;
    QStringList names;
    for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
        int triangles = 0;
        for (unsigned f = 0; f < scene->mMeshes[m]->mNumFaces; ++f)
            triangles += scene->mMeshes[m]->mFaces[f].mNumIndices == 3;
        if (triangles > 0)
            counts.push_back(triangles);
        names << QString::fromUtf8(scene->mMeshes[m]->mName.C_Str());
    }
    std::vector<int> expected = trianglesOfRegions(content);
    std::sort(counts.begin(), counts.end());
    std::sort(expected.begin(), expected.end());
    QVERIFY2(counts == expected, qPrintable(names.join(", ")));
    if (extension == "obj")
        QVERIFY2(names.contains("region_0") && names.contains("region_1"), qPrintable(names.join(", ")));
}

// "I put my painting on the web and it is grey."
void ExportsReadElsewhereTest::coloursOfVerticesAreRead()
{
    QTemporaryDir folder;
    const QString path = folder.filePath("ball.glb");
    MeshFileContent content = ball();
    content.regionNames = {"trunk", "leaves"};
    for (const Vec3 &v : content.mesh.vertices)
        content.vertexColours.push_back(
            {float((v.x() - 8) / 4), float((v.y() + 23) / 6), float((v.z() - 1) / 8), 1});
    const Result<void> written = writeMesh(content, path.toStdString(), JobControl());
    QVERIFY2(written, written ? "" : written.error().message().c_str());
    Assimp::Importer importer;
    const aiScene *scene = importer.ReadFile(path.toStdString(), 0);
    QVERIFY2(scene, importer.GetErrorString());
    QCOMPARE(scene->mNumMeshes, 2u);
    QCOMPARE(QString(scene->mMeshes[0]->mName.C_Str()), "trunk");
    for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
        const aiMesh &mesh = *scene->mMeshes[m];
        QVERIFY(mesh.HasVertexColors(0));
        for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
            const aiVector3D &v = mesh.mVertices[i];
            const aiColor4D &c = mesh.mColors[0][i];
            QVERIFY(std::abs(c.r - (v.x - 8) / 4) < 1e-4 && std::abs(c.g - (v.y + 23) / 6) < 1e-4 &&
                    std::abs(c.b - (v.z - 1) / 8) < 1e-4 && c.a == 1.f);
        }
    }
}

QTEST_APPLESS_MAIN(ExportsReadElsewhereTest)
#include "exports_read_elsewhere_test.moc"
