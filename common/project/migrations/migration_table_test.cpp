#include "project/migrations/migration_table.h"

#include "project/project_reader.h"
#include "project/project_writer.h"
#include "project/testing/container_surgery.h"
#include "project/testing/sample_project.h"

#include <QtTest>

using namespace ductus;

class MigrationTableTest : public QObject
{
    Q_OBJECT
private slots:
    void stepsRunInOrder();
    void missingStepIsToldByVersion();
    void stepThatTrustsTooMuchIsAnError();
    void oldDocumentIsUpgradedBeforeItIsRead();
    void noReleasedVersionIsLeftBehind();
};

void MigrationTableTest::stepsRunInOrder()
{
    MigrationTable table;
    table.add("s", 2, [](OrderedJson &o) -> Result<void> {
        o["log"] = o.value("log", "") + "b";
        return {};
    });
    table.add("s", 1, [](OrderedJson &o) -> Result<void> {
        o["log"] = o.value("log", "") + "a";
        return {};
    });
    table.add("other", 3, [](OrderedJson &o) -> Result<void> {
        o["log"] = "never";
        return {};
    });
    table.add("s", 3, [](OrderedJson &o) -> Result<void> {
        o["log"] = o.value("log", "") + "c";
        return {};
    });
    OrderedJson object = {{"version", 1}};
    QVERIFY(table.migrate(object, "s", 1, 4, "p").ok());
    QCOMPARE(object["log"].get<std::string>(), std::string("abc"));
    QCOMPARE(object["version"].get<int>(), 4);
    OrderedJson later = {{"version", 3}};
    QVERIFY(table.migrate(later, "s", 3, 4, "p").ok());
    QCOMPARE(later["log"].get<std::string>(), std::string("c"));
}

void MigrationTableTest::missingStepIsToldByVersion()
{
    OrderedJson object = {{"version", 0}};
    const Result<void> result = builtInMigrations().migrate(object, "project", 0, 1, "p");
    QCOMPARE(result.error().code, ErrorCode::Unsupported);
    QVERIFY(result.error().problem.find("project version 0") != std::string::npos);
}

void MigrationTableTest::stepThatTrustsTooMuchIsAnError()
{
    MigrationTable table;
    table.add("s", 1, [](OrderedJson &o) -> Result<void> {
        o["n"] = o.at("missing").get<int>();
        return {};
    });
    OrderedJson object = {{"version", 1}};
    QCOMPARE(table.migrate(object, "s", 1, 2, "p").error().code, ErrorCode::Malformed);
}

void MigrationTableTest::oldDocumentIsUpgradedBeforeItIsRead()
{
    // A version 0 that never was: the unit was in millimetres and named otherwise.
    const Project project = sampleProject(1);
    const std::string entry = "documents/" + project.documents[0].id.text() + ".json";
    Bytes bytes = withReplaced(serializedProject(project)->bytes, entry, "\"version\": 1", "\"version\": 0");
    bytes = withReplaced(bytes, entry, "\"metresPerUnit\": 0.1", "\"millimetres\": 500, \"kept\": [1]");
    QCOMPARE(parseProject(bytes, "a").error().code, ErrorCode::Unsupported);

    MigrationTable table;
    table.add(sketchSurfaceKind, 0, [](OrderedJson &object) -> Result<void> {
        object["metresPerUnit"] = object.at("millimetres").get<double>() / 1000.0;
        object.erase("millimetres");
        return {};
    });
    ProjectReadOptions options;
    options.migrations = &table;
    const Result<Project> read = parseProject(bytes, "a", options);
    QVERIFY2(read.ok(), read.ok() ? "" : read.error().message().c_str());
    SketchSurfaceDocument expected = *project.documents[0].sketchSurface;
    expected.strokes.metresPerUnit = 0.5;
    expected.unknown = {{"kept", "[1]"}};
    QCOMPARE(difference(expected, *read->documents[0].sketchSurface), std::string());
    const Container saved = *readContainer(serializedProject(*read)->bytes, "a");
    QVERIFY(textOf(saved.entries.at(entry)).find("\"version\": 1,") != std::string::npos);
}

void MigrationTableTest::noReleasedVersionIsLeftBehind()
{
    // Every version from 1 up to the current one must be readable: a bump without a step fails here.
    for (const auto &[schema, current] :
         {std::pair<std::string, int>{projectSchema, projectVersion},
          std::pair<std::string, int>{sketchSurfaceKind, sketchSurfaceVersion}}) {
        OrderedJson object = {{"version", 1}};
        const Result<void> result = builtInMigrations().migrate(object, schema, 1, current, "p");
        QVERIFY(result.ok() || result.error().code != ErrorCode::Unsupported);
    }
}

QTEST_APPLESS_MAIN(MigrationTableTest)
#include "migration_table_test.moc"
