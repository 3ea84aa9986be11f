#include "project/project_reader.h"

#include "project/container/entry_name.h"
#include "project/project_writer.h"
#include "project/testing/container_surgery.h"
#include "project/testing/sample_project.h"

#include <QtTest>

using namespace ductus;

namespace {

Bytes sampleBytes()
{
    return serializedProject(sampleProject(1))->bytes;
}

std::string entryOfFirstDocument()
{
    return "documents/" + sampleProject(1).documents[0].id.text() + ".json";
}

} // namespace

class ProjectReaderTest : public QObject
{
    Q_OBJECT
private slots:
    void everythingComesBackExactly();
    void sameProjectGivesSameBytes();
    void savingWhatWasReadGivesTheSameBytesAndPacksNothing();
    void equalContentIsStoredOnce();
    void mimetypeStandsWhereFileManagersLook();
    void unknownThingsAreKeptByteForByte();
    void foreignFormattingOfUntouchedDocumentsIsKept();
    void buffersOfRemovedStrokesGoAway();
    void buffersUnknownFieldsMentionStay();
    void errorsNameTheField_data();
    void errorsNameTheField();
    void damagedBufferIsFound();
    void newerProjectIsReadOnly();
    void newerProjectThatForbidsReadingIsRefused();
    void newerDocumentIsKeptUnread();
    void writerRefusesWhatReadersRefuse();
    void mutationsNeverCrash();
};

void ProjectReaderTest::everythingComesBackExactly()
{
    const Project project = sampleProject(1);
    const Result<Project> read = parseProject(serializedProject(project)->bytes, "a.ductus");
    QVERIFY2(read.ok(), read.ok() ? "" : read.error().message().c_str());
    QCOMPARE(difference(project, *read), std::string());
    QVERIFY(std::signbit(read->documents[0].sketchSurface->strokes.strokes[0].points[0].x()));
    QVERIFY(read->warnings.empty());
    QVERIFY(!difference(project, sampleProject(2)).empty()); // the comparison sees something
}

void ProjectReaderTest::sameProjectGivesSameBytes()
{
    QVERIFY(sampleBytes() == sampleBytes());
}

void ProjectReaderTest::savingWhatWasReadGivesTheSameBytesAndPacksNothing()
{
    const Result<SerializedProject> first = serializedProject(sampleProject(1));
    QVERIFY(first->packedBuffers > 0);
    const Result<SerializedProject> second = serializedProject(*parseProject(first->bytes, "a"));
    QVERIFY(second->bytes == first->bytes);
    QCOMPARE(second->packedBuffers, 0);
    QCOMPARE(second->copiedBuffers, first->packedBuffers);
}

void ProjectReaderTest::equalContentIsStoredOnce()
{
    Project project = sampleProject(1);
    const std::size_t before = serializedProject(project)->buffers.entries().size();
    Random random(5);
    project.documents.push_back(
        newSketchSurface(Uuid::from(random), "Copy", *project.documents[0].sketchSurface));
    const Result<SerializedProject> serialized = serializedProject(project);
    QCOMPARE(serialized->buffers.entries().size(), before);
    QCOMPARE(difference(project, *parseProject(serialized->bytes, "a")), std::string());
}

void ProjectReaderTest::mimetypeStandsWhereFileManagersLook()
{
    const Bytes bytes = sampleBytes();
    const std::string text(reinterpret_cast<const char *>(bytes.data()), bytes.size());
    QVERIFY(text.starts_with("PK"));
    QCOMPARE(text.substr(30, 8 + ductusMimeType.size()), "mimetype" + std::string(ductusMimeType));
    const std::size_t second = 38 + ductusMimeType.size();
    QCOMPARE(text.substr(second, 2), std::string("PK"));
    QCOMPARE(text.substr(second + 30, 13), std::string("thumbnail.png"));
}

void ProjectReaderTest::unknownThingsAreKeptByteForByte()
{
    const std::string odd =
        R"({"b" : [1.50, -0, 123456789012345678901234567890, "\u00e9\/"],  "a": {"x":1e2}})";
    const std::string document = entryOfFirstDocument();
    Bytes bytes =
        withReplaced(sampleBytes(), "project.json", "\"generator\"", "\"links\": " + odd + ", \"generator\"");
    bytes = withReplaced(bytes, "project.json", "\"kind\"", "\"future\": " + odd + ", \"kind\"");
    bytes = withReplaced(bytes, document, "\"upAxis\"", "\"scribbles\": " + odd + ", \"upAxis\"");
    bytes =
        withReplaced(bytes, document, "\"role\": \"boundary\"", "\"role\": \"boundary\", \"colour\": " + odd);
    bytes = withReplaced(bytes, document, "\"epsilon\"", "\"tightness\": " + odd + ", \"epsilon\"");
    bytes = withReplaced(bytes, document, "\"degree\": 2", "\"degree\": 2, \"frame\": " + odd);
    bytes = withReplaced(bytes, document, "\"normal\"", "\"residual\": " + odd + ", \"normal\"");
    const std::string painting = "{ \"schema\":\"painting\",\r\n \"version\" : 99}";
    const std::string record =
        R"({"id":"00000000-0000-4000-8000-000000000001","kind":"painting","name":"P","entry":"documents/p.json"},)";
    bytes = withReplaced(bytes, "project.json", "\"documents\": [", "\"documents\": [" + record);
    const Bytes orphan(5000, std::byte(7));
    BufferStore orphans;
    const std::string orphanHash = orphans.add(orphan);
    bytes = operatedOn(bytes, [&](Container &parts) {
        parts.entries["documents/p.json"] = packedEntry("documents/p.json", asBytes(painting));
        parts.entries["strange/\xe7\xad\x86.bin"] = packedEntry("strange/\xe7\xad\x86.bin", orphan);
        parts.entries["empty/"] = storedEntry("empty/", {});
        parts.entries[bufferEntryName(orphanHash)] = *orphans.find(orphanHash);
    });

    Result<Project> project = parseProject(bytes, "a");
    QVERIFY2(project.ok(), project.ok() ? "" : project.error().message().c_str());
    QCOMPARE(project->documents.size(), std::size_t(3));
    QCOMPARE(sketchSurfaceOf(project->documents[0]).error().code, ErrorCode::Unsupported);
    auto changed = std::make_shared<SketchSurfaceDocument>(*project->documents[1].sketchSurface);
    changed->strokes.strokes[2].points[0].x() += 1.0;
    project->documents[1].sketchSurface = changed;
    project->documents[1].name = "Renamed";

    const Container saved = *readContainer(serializedProject(*project)->bytes, "a");
    QCOMPARE(textOf(saved.entries.at("documents/p.json")), painting);
    QVERIFY(*unpacked(saved.entries.at("strange/\xe7\xad\x86.bin"), "") == orphan);
    QVERIFY(saved.find("empty/"));
    QVERIFY(saved.find(bufferEntryName(orphanHash)));
    const auto count = [&odd](const std::string &text) {
        int n = 0;
        for (std::size_t at = 0; (at = text.find(odd, at)) != std::string::npos; at += odd.size())
            ++n;
        return n;
    };
    QCOMPARE(count(textOf(saved.entries.at("project.json"))), 3); // links and two records of documents
    const std::string savedDocument = textOf(saved.entries.at(document));
    QVERIFY(count(savedDocument) >= 5);
    const Result<Project> again = parseProject(serializedProject(*project)->bytes, "a");
    QCOMPARE(difference(*project, *again), std::string());
    QCOMPARE(again->documents[1].sketchSurface->strokeUnknown.at(StrokeId{4}).front().second, odd);
}

void ProjectReaderTest::foreignFormattingOfUntouchedDocumentsIsKept()
{
    const std::string document = entryOfFirstDocument();
    Bytes bytes = withReplaced(sampleBytes(), document, "\"smoothness\": 10.0", "\"smoothness\"   :   1.0e1");
    Project project = *parseProject(bytes, "a");
    project.documents[1].name = "Only this changed";
    const Container saved = *readContainer(serializedProject(project)->bytes, "a");
    QVERIFY(textOf(saved.entries.at(document)).find("\"smoothness\"   :   1.0e1") != std::string::npos);
}

void ProjectReaderTest::buffersOfRemovedStrokesGoAway()
{
    Project project = *parseProject(sampleBytes(), "a");
    const std::size_t before = project.buffers.entries().size();
    auto changed = std::make_shared<SketchSurfaceDocument>(*project.documents[0].sketchSurface);
    changed->surface.reset();
    changed->proxy.reset();
    project.documents[0].sketchSurface = changed;
    const Result<SerializedProject> serialized = serializedProject(project);
    QVERIFY(serialized->buffers.entries().size() < before);
    QVERIFY(parseProject(serialized->bytes, "a").ok());
}

void ProjectReaderTest::buffersUnknownFieldsMentionStay()
{
    const std::string document = entryOfFirstDocument();
    const Project original = *parseProject(sampleBytes(), "a");
    const std::string hash = original.buffers.entries().begin()->first;
    const Bytes bytes = withReplaced(sampleBytes(), document, "\"upAxis\"",
                                     "\"later\": {\"buffer\": \"" + hash + "\"}, \"upAxis\"");
    Project project = *parseProject(bytes, "a");
    for (ProjectDocument &d : project.documents) {
        auto emptied = std::make_shared<SketchSurfaceDocument>();
        emptied->unknown = d.sketchSurface->unknown;
        d.sketchSurface = emptied;
    }
    const Result<SerializedProject> serialized = serializedProject(project);
    QVERIFY(serialized->buffers.find(hash));
    QVERIFY(serialized->buffers.entries().size() < original.buffers.entries().size());
}

void ProjectReaderTest::errorsNameTheField_data()
{
    QTest::addColumn<QString>("from");
    QTest::addColumn<QString>("to");
    QTest::addColumn<QString>("place"); // after the '#'
    const auto row = [](const char *name, const char *from, const char *to, const char *place) {
        QTest::newRow(name) << from << to << place;
    };
    row("shape overflow", "[9, 3]", "[9223372036854775809, 3]", "/strokes/0/points/shape");
    row("shape beyond buffer", "[9, 3]", "[90000, 3]", "/strokes/0/points/shape");
    row("shape of other rank", "[9, 3]", "[27]", "/strokes/0/points/shape");
    row("shape negative", "[9, 3]", "[-9, 3]", "/strokes/0/points/shape");
    row("offset beyond buffer", "\"offset\": 0,", "\"offset\": 18446744073709551615,",
        "/strokes/0/points/shape");
    row("wrong type", "\"float64\"", "\"float32\"", "/strokes/0/points/type");
    row("unknown type", "\"float64\"", "\"complex\"", "/strokes/0/points/type");
    row("unknown role", "\"boundary\"", "\"wall\"", "/strokes/1/role");
    row("repeated id", "\"id\": 4,", "\"id\": 1,", "/strokes/1/id");
    row("negative id", "\"id\": 4,", "\"id\": -4,", "/strokes/1/id");
    row("id not whole", "\"id\": 4,", "\"id\": 4.0,", "/strokes/1/id");
    row("channel of other length", "\"shape\": [9], \"unit\": \"s\"", "\"shape\": [8], \"unit\": \"s\"",
        "/strokes/0/timeSeconds");
    row("zero unit", "\"metresPerUnit\": 0.1", "\"metresPerUnit\": 0", "/metresPerUnit");
    row("missing member", "\"settings\"", "\"sittings\"", "/settings");
    row("runs beyond bounds", "\"runs\": 7", "\"runs\": 70000", "/settings/runs");
    row("seed negative", "\"seed\": 1844", "\"seed\": -1844", "/settings/seed");
    row("epsilon a text", "\"epsilon\": 0.30000000000000004", "\"epsilon\": \"0.3\"", "/settings/epsilon");
    row("name twice", "\"epsilon\"", "\"runs\": 7, \"epsilon\"", "/settings");
    row("triangles without vertices", "[5, 3], \"unit\"", "[2, 3], \"unit\"", "/proxy/mesh/triangles");
    row("degree", "\"degree\": 2", "\"degree\": 17", "/surface/models/1/degree");
    row("regions", "\"shape\": [4]}", "\"shape\": [3]}", "/surface/triangleRegions");
    row("strokes no array", "\"strokes\": [", "\"strokes\": 5, \"x\": [", "/strokes");
    row("wrong schema", "\"schema\": \"sketch-surface\"", "\"schema\": \"painting\"", "/schema");
    row("text for a version", "\"version\": 1", "\"version\": \"1\"", "/version");
}

void ProjectReaderTest::errorsNameTheField()
{
    QFETCH(QString, from);
    QFETCH(QString, to);
    QFETCH(QString, place);
    const std::string document = entryOfFirstDocument();
    const Bytes bytes = withReplaced(sampleBytes(), document, from.toStdString(), to.toStdString());
    const Result<Project> read = parseProject(bytes, "hat.ductus");
    QVERIFY(!read.ok());
    QCOMPARE(QString::fromStdString(read.error().place),
             QString::fromStdString("hat.ductus:" + document + "#") + place);
    QCOMPARE(read.error().code, ErrorCode::Malformed);
}

void ProjectReaderTest::damagedBufferIsFound()
{
    const Project project = *parseProject(sampleBytes(), "a");
    const std::string hash = project.buffers.entries().begin()->first;
    const std::string name = bufferEntryName(hash);
    const auto withBuffer = [&](Bytes content) {
        return operatedOn(sampleBytes(),
                          [&](Container &parts) { parts.entries[name] = packedEntry(name, content); });
    };
    Bytes content = *unpacked(*project.buffers.find(hash), "");
    QVERIFY(parseProject(withBuffer(content), "a").ok());
    content[3] ^= std::byte(1);
    const Result<Project> read = parseProject(withBuffer(content), "a");
    QVERIFY(!read.ok());
    QVERIFY(read.error().problem.find("does not match its name") != std::string::npos);

    // A NaN in an array that is otherwise in order: new content, new name.
    Bytes nan = *unpacked(*project.buffers.find(hash), "");
    for (std::size_t i = 0; i < 8; ++i)
        nan[i] = std::byte(0xff);
    BufferStore store;
    const std::string nanHash = store.add(nan);
    Bytes bytes = operatedOn(sampleBytes(), [&](Container &parts) {
        parts.entries.erase(name);
        parts.entries[bufferEntryName(nanHash)] = *store.find(nanHash);
    });
    for (const ProjectDocument &document : project.documents) {
        const std::string entry = document.original->name;
        if (textOf(*document.original).find(hash) != std::string::npos)
            bytes = withReplaced(bytes, entry, hash, nanHash);
    }
    const Result<Project> withNan = parseProject(bytes, "a");
    QVERIFY(!withNan.ok());
    QVERIFY(withNan.error().problem.find("not a finite number") != std::string::npos);

    const Bytes missing = operatedOn(sampleBytes(), [&](Container &parts) { parts.entries.erase(name); });
    QVERIFY(parseProject(missing, "a").error().place.ends_with("/buffer"));
}

void ProjectReaderTest::newerProjectIsReadOnly()
{
    Bytes bytes = withReplaced(sampleBytes(), "project.json", "\"version\": 1", "\"version\": 3");
    const Result<Project> read = parseProject(bytes, "a");
    QVERIFY(read.ok());
    QVERIFY(read->readOnly);
    QCOMPARE(read->warnings.size(), std::size_t(1));
    QCOMPARE(serializedProject(*read).error().code, ErrorCode::NewerVersion);
}

void ProjectReaderTest::newerProjectThatForbidsReadingIsRefused()
{
    Bytes bytes = withReplaced(sampleBytes(), "project.json", "\"version\": 1", "\"version\": 3");
    bytes = withReplaced(bytes, "project.json", "\"minReader\": 1", "\"minReader\": 2");
    const Result<Project> read = parseProject(bytes, "a");
    QVERIFY(!read.ok());
    QCOMPARE(read.error().code, ErrorCode::NewerVersion);
    QVERIFY(read.error().message().find("project version 2") != std::string::npos);
}

void ProjectReaderTest::newerDocumentIsKeptUnread()
{
    const std::string entry = entryOfFirstDocument();
    Bytes bytes = withReplaced(sampleBytes(), entry, "\"version\": 1", "\"version\": 5");
    Result<Project> readable = parseProject(bytes, "a");
    QVERIFY(readable->documents[0].readOnly && readable->documents[0].sketchSurface);
    auto changed = std::make_shared<SketchSurfaceDocument>(*readable->documents[0].sketchSurface);
    changed->strokes.strokes.clear();
    readable->documents[0].sketchSurface = changed;
    const Container saved = *readContainer(serializedProject(*readable)->bytes, "a");
    QCOMPARE(textOf(saved.entries.at(entry)), textOf(readContainer(bytes, "a")->entries.at(entry)));

    bytes = withReplaced(bytes, entry, "\"minReader\": 1", "\"minReader\": 4");
    const Result<Project> unreadable = parseProject(bytes, "a");
    QVERIFY(unreadable.ok() && !unreadable->readOnly);
    const Error error = sketchSurfaceOf(unreadable->documents[0]).error();
    QCOMPARE(error.code, ErrorCode::NewerVersion);
    QVERIFY(error.problem.find("sketch-surface version 4") != std::string::npos);
    const Result<SerializedProject> again = serializedProject(*unreadable);
    QCOMPARE(again->buffers.entries().size(), unreadable->buffers.entries().size());
}

void ProjectReaderTest::writerRefusesWhatReadersRefuse()
{
    const auto errorOf = [](const std::function<void(SketchSurfaceDocument &)> &change) {
        Project project = sampleProject(1);
        auto changed = std::make_shared<SketchSurfaceDocument>(*project.documents[0].sketchSurface);
        change(*changed);
        project.documents[0].sketchSurface = changed;
        const Result<SerializedProject> serialized = serializedProject(project);
        return serialized.ok() ? std::string("written") : serialized.error().place;
    };
    const std::string place = entryOfFirstDocument() + "#/";
    QCOMPARE(errorOf([](auto &d) { d.strokes.strokes[1].points[0].y() = NAN; }), place + "strokes/1/points");
    QCOMPARE(errorOf([](auto &d) { d.strokes.strokes[0].pressure.pop_back(); }),
             place + "strokes/0/pressure");
    QCOMPARE(errorOf([](auto &d) { d.strokes.strokes[1].id = d.strokes.strokes[0].id; }),
             place + "strokes/1/id");
    QCOMPARE(errorOf([](auto &d) { d.surface->mesh.triangles[0][1] = 77; }),
             place + "surface/mesh/triangles");
    QCOMPARE(errorOf([](auto &d) { d.surface->featureLines[0][0] = -1; }), place + "surface/featureLines");
    QCOMPARE(errorOf([](auto &d) { d.settings.epsilon = INFINITY; }), place + "settings");
    QCOMPARE(errorOf([](auto &) {}), std::string("written"));
    Project badName = sampleProject(1);
    badName.documents[0].name = "\xff";
    QCOMPARE(serializedProject(badName).error().code, ErrorCode::InvalidArgument);
}

void ProjectReaderTest::mutationsNeverCrash()
{
    const Bytes valid = sampleBytes();
    Random random(20260101);
    int refused = 0;
    constexpr int rounds = 3000;
    for (int round = 0; round < rounds; ++round) {
        Bytes bytes = valid;
        if (random.index(4) == 0)
            bytes.resize(std::size_t(random.index(int(bytes.size()))));
        for (int flips = random.index(4); flips > 0 && !bytes.empty(); --flips)
            bytes[std::size_t(random.index(int(bytes.size())))] ^= std::byte(1 << random.index(8));
        const Result<Project> read = parseProject(bytes, "m");
        if (!read) {
            ++refused;
            QVERIFY(!read.error().problem.empty());
        } else {
            QVERIFY(serializedProject(*read).ok());
        }
    }
    QVERIFY(refused > rounds / 3);

    // Text mutations reach deeper than flips, which the checksums catch.
    const std::string entry = entryOfFirstDocument();
    const std::string text = textOf(readContainer(valid, "m")->entries.at(entry));
    const std::string_view pieces[] = {"[",  "]",     "{",    "}", "\"", ",",
                                       "-1", "1e308", "null", "0", "\\", "9999999999999"};
    for (int round = 0; round < 3000; ++round) {
        std::string mutated = text;
        for (int edits = 1 + random.index(3); edits > 0; --edits) {
            const auto at = std::size_t(random.index(int(mutated.size())));
            mutated.replace(at, std::size_t(random.index(6)), pieces[random.index(int(std::size(pieces)))]);
        }
        const Bytes bytes = operatedOn(
            valid, [&](Container &parts) { parts.entries[entry] = packedEntry(entry, asBytes(mutated)); });
        const Result<Project> read = parseProject(bytes, "m");
        QVERIFY(read.ok() ? serializedProject(*read).ok() : !read.error().place.empty());
    }
}

QTEST_APPLESS_MAIN(ProjectReaderTest)
#include "project_reader_test.moc"
