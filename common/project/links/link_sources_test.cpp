// Links: to and from JSON, and found again in their own project, in another, beside it, or not at all.
#include "project/links/link_sources.h"

#include "project/json/json_document.h"
#include "project/links/surface_digest.h"
#include "project/project_writer.h"
#include "project/testing/sample_project.h"

#include <QTemporaryDir>
#include <QtTest>

#include <fstream>

using namespace ductus;
namespace fs = std::filesystem;

namespace {

DocumentLink linkTo(const ProjectDocument &document, const std::string &file)
{
    return {file, document.id, document.name, surfaceDigest(*document.sketchSurface->surface)};
}

void write(const fs::path &path, const Project &project)
{
    fs::create_directories(path.parent_path());
    const Result<SerializedProject> made = serializedProject(project);
    if (!made)
        qFatal("%s", made.error().message().c_str());
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char *>(made->bytes.data()), std::streamsize(made->bytes.size()));
}

Result<DocumentLink> read(const std::string &text)
{
    const Result<JsonDocument> json = parsedJson(text, "link");
    if (!json)
        return json.error();
    const JsonReader reader(*json, "link");
    const DocumentLink link = linkFromJson(reader);
    if (reader.failed())
        return reader.error();
    return link;
}

} // namespace

class LinkSourcesTest : public QObject
{
    Q_OBJECT
private slots:
    void comesBackFromJson();
    void refusesWhatIsNoLink_data();
    void refusesWhatIsNoLink();
    void theDigestIsOfTheSurfaceAlone();
    void isFoundInItsOwnProject();
    void isFoundInAnotherProject();
    void isFoundBesideWhenBothWereMoved();
    void aProjectWrittenAnewIsTakenForIt();
    void saysWhatIsMissing();
    void namesFilesAsSeenFromTheFolder();
};

void LinkSourcesTest::comesBackFromJson()
{
    const Project project = sampleProject(1);
    for (const std::string file : {"", "../h\xc3\xbct/a.ductus"}) {
        const DocumentLink link = linkTo(project.documents[0], file);
        const Result<DocumentLink> again = read(jsonText(linkJson(link)));
        QVERIFY2(again.ok(), again ? "" : again.error().message().c_str());
        QVERIFY(*again == link);
        QVERIFY(linkProblem(link).empty());
    }
}

void LinkSourcesTest::refusesWhatIsNoLink_data()
{
    QTest::addColumn<QByteArray>("text");
    const QByteArray id = "11111111-2222-4333-8444-555555555555", digest(64, 'a');
    QTest::newRow("no id") << QByteArray(R"({"document": "x", "name": "", "sha256": ")" + digest + "\"}");
    QTest::newRow("no digest") << QByteArray(R"({"document": ")" + id + R"(", "name": "", "sha256": "abc"})");
    QTest::newRow("capitals") << QByteArray(R"({"document": ")" + id + R"(", "name": "", "sha256": ")" +
                                            digest.toUpper() + "\"}");
    QTest::newRow("no name") << QByteArray(R"({"document": ")" + id + R"(", "sha256": ")" + digest + "\"}");
}

void LinkSourcesTest::refusesWhatIsNoLink()
{
    QFETCH(QByteArray, text);
    QVERIFY(!read(text.toStdString()).ok());
}

void LinkSourcesTest::theDigestIsOfTheSurfaceAlone()
{
    StoredSurface surface = *sampleSketchSurface(1).surface;
    const std::string before = surfaceDigest(surface);
    surface.featureLines.clear();
    surface.triangleRegions.assign(surface.triangleRegions.size(), 9);
    QCOMPARE(surfaceDigest(surface), before);
    surface.mesh.vertices[1].x() += 1e-12;
    const std::string moved = surfaceDigest(surface);
    QVERIFY(moved != before);
    std::swap(surface.mesh.triangles[0], surface.mesh.triangles[1]);
    QVERIFY(surfaceDigest(surface) != moved);
}

void LinkSourcesTest::isFoundInItsOwnProject()
{
    const Project project = sampleProject(2);
    LinkSources sources(project, {}, {});
    const auto found = sources.find(linkTo(project.documents[1], ""), sketchSurfaceKind);
    QVERIFY(found.ok());
    QCOMPARE((*found)->name, project.documents[1].name);
}

void LinkSourcesTest::isFoundInAnotherProject()
{
    QTemporaryDir folder;
    const fs::path root = folder.path().toStdString();
    const Project sketches = sampleProject(3);
    write(root / "sketches" / "a.ductus", sketches);
    const Project own;
    LinkSources sources(own, root / "paintings" / "p.ductus", {});
    const auto found = sources.find(linkTo(sketches.documents[1], "../sketches/a.ductus"), sketchSurfaceKind);
    QVERIFY2(found.ok(), found ? "" : found.error().message().c_str());
    QCOMPARE((*found)->id, sketches.documents[1].id);
}

void LinkSourcesTest::isFoundBesideWhenBothWereMoved()
{
    QTemporaryDir folder;
    const fs::path root = folder.path().toStdString();
    const Project sketches = sampleProject(3), own;
    write(root / "a.ductus", sketches);
    LinkSources sources(own, root / "p.ductus", {});
    QVERIFY(sources.find(linkTo(sketches.documents[0], "/gone/for/ever/a.ductus"), sketchSurfaceKind).ok());
}

void LinkSourcesTest::aProjectWrittenAnewIsTakenForIt()
{
    QTemporaryDir folder;
    const fs::path root = folder.path().toStdString();
    const Project own;
    Project sketches = sampleProject(3);
    sketches.documents.pop_back();
    const DocumentLink link = linkTo(sketches.documents[0], "a.ductus");
    sketches.documents[0].id = *Uuid::parse("11111111-2222-4333-8444-555555555555");
    write(root / "a.ductus", sketches);
    {
        LinkSources sources(own, root / "p.ductus", {});
        QVERIFY(sources.find(link, sketchSurfaceKind).ok());
        QCOMPARE(sources.find(link, "painting").error().code, ErrorCode::TooLittleData);
    }
    // With two of them nobody knows which one is meant.
    write(root / "a.ductus", sampleProject(4));
    LinkSources sources(own, root / "p.ductus", {});
    QCOMPARE(sources.find(link, sketchSurfaceKind).error().code, ErrorCode::TooLittleData);
}

void LinkSourcesTest::saysWhatIsMissing()
{
    QTemporaryDir folder;
    const fs::path root = folder.path().toStdString();
    const Project own = sampleProject(1);
    DocumentLink link = linkTo(own.documents[0], "none.ductus");
    LinkSources sources(own, root / "p.ductus", {});
    const auto none = sources.find(link, sketchSurfaceKind);
    QVERIFY(!none && none.error().code == ErrorCode::FileNotFound);
    QCOMPARE(none.error().place, (root / "none.ductus").string());
    link.file.clear();
    link.document = *Uuid::parse("11111111-2222-4333-8444-555555555555");
    QCOMPARE(sources.find(link, sketchSurfaceKind).error().code, ErrorCode::TooLittleData);
    std::ofstream(root / "bad.ductus") << "no zip";
    link.file = "bad.ductus";
    QVERIFY(!sources.find(link, sketchSurfaceKind).ok());
}

void LinkSourcesTest::namesFilesAsSeenFromTheFolder()
{
    QTemporaryDir folder;
    const fs::path root = fs::canonical(folder.path().toStdString());
    QCOMPARE(linkedFileName(root / "a.ductus", root), std::string("a.ductus"));
    QCOMPARE(linkedFileName(root / "x" / "a.ductus", root / "y"), std::string("../x/a.ductus"));
    QCOMPARE(linkedFileName(root / "a.ductus", {}), (root / "a.ductus").generic_string());
}

QTEST_APPLESS_MAIN(LinkSourcesTest)
#include "link_sources_test.moc"
