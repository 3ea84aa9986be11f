#include "project/schema_check.h"

#include "base/sha256.h"
#include "project/project_writer.h"
#include "project/testing/container_surgery.h"
#include "project/testing/sample_project.h"

#include <QtTest>

using namespace ductus;

class SchemaCheckTest : public QObject
{
    Q_OBJECT
private slots:
    void whatWeWriteIsValid();
    void violationsAreFoundAndPlaced();
    void unknownSchemaAndBrokenJsonAreErrors();
    void schemasChangeOnlyWithTheirVersion();
};

void SchemaCheckTest::whatWeWriteIsValid()
{
    for (std::uint64_t seed = 1; seed < 4; ++seed) {
        const auto lines = projectSchemaViolations(serializedProject(sampleProject(seed))->bytes, "a");
        QVERIFY2(lines.ok(), lines.ok() ? "" : lines.error().message().c_str());
        QVERIFY2(lines->empty(), lines->empty() ? "" : lines->front().c_str());
    }
    Project plain;
    plain.documents.push_back(newSketchSurface(Uuid(), "", SketchSurfaceDocument()));
    QVERIFY(projectSchemaViolations(serializedProject(plain)->bytes, "a")->empty());
}

void SchemaCheckTest::violationsAreFoundAndPlaced()
{
    const Project project = sampleProject(1);
    const Bytes bytes = serializedProject(project)->bytes;
    const std::string entry = "documents/" + project.documents[0].id.text() + ".json";
    const auto firstLine = [&](const std::string &from, const std::string &to) {
        const auto lines = projectSchemaViolations(withReplaced(bytes, entry, from, to), "a");
        return !lines.ok() ? lines.error().message() : lines->empty() ? std::string("valid") : lines->front();
    };
    QVERIFY(firstLine("\"runs\": 7", "\"runs\": 0").starts_with(entry + "#/settings"));
    QVERIFY(firstLine("\"boundary\"", "\"wall\"") != "valid");
    QVERIFY(firstLine("\"float64\"", "\"float63\"") != "valid");
    QVERIFY(firstLine("\"metresPerUnit\": 0.1", "\"metresPerUnit\": 0") != "valid");
    QVERIFY(firstLine("\"upAxis\"", "\"upaxis\"") != "valid");
    QVERIFY(firstLine("\"offset\": 0,", "\"offset\": -8,") != "valid");
    QCOMPARE(firstLine("\"upAxis\"", "\"future\": 5, \"upAxis\""), std::string("valid"));
    const auto lines =
        projectSchemaViolations(withReplaced(bytes, "project.json", "\"kind\"", "\"sort\""), "a");
    QVERIFY(lines.ok() && !lines->empty());
}

void SchemaCheckTest::unknownSchemaAndBrokenJsonAreErrors()
{
    QCOMPARE(schemaViolations("{}", "none").error().code, ErrorCode::InvalidArgument);
    QCOMPARE(schemaViolations("{", "project").error().code, ErrorCode::Malformed);
    QVERIFY(!schemaViolations("{}", "project")->empty());
    QVERIFY(!schemaViolations("[]", "sketch_surface")->empty());
}

void SchemaCheckTest::schemasChangeOnlyWithTheirVersion()
{
    // A changed schema needs: a new version in the header, a migration step, a fixture in tests/format, a
    // line in the changelog, and then its hash here. Before the first release the hash alone may change.
    QCOMPARE(projectVersion, 1);
    QCOMPARE(sketchSurfaceVersion, 1);
    QCOMPARE(sha256Hex(asBytes(schemaText("project"))),
             std::string("8c190017f6c8691b626f668f80157023ed250afcd9508bd2654168b7e59f635a"));
    QCOMPARE(sha256Hex(asBytes(schemaText("sketch_surface"))),
             std::string("fb5204804cfe8485b2e0ac83f3850369ce3b460e3acdeefd2168e6bf48f7c7cd"));
}

QTEST_APPLESS_MAIN(SchemaCheckTest)
#include "schema_check_test.moc"
