// Paintings in .ductus files: nothing changes on the way, nothing hostile comes through.
#include "painting/storage/painting_content.h"

#include "painting/edit/layer_edits.h"
#include "painting/scene/painting_check.h"
#include "painting/testing/sample_painting.h"
#include "project/container/container_reader.h"
#include "project/container/container_writer.h"
#include "project/project_reader.h"
#include "project/project_writer.h"
#include "project/schema_check.h"

#include <QtTest>
#include <ctime>

using namespace ductus;

namespace {

const Uuid documentId = *Uuid::parse("aaaaaaaa-bbbb-4ccc-8ddd-eeeeeeeeeeee");

Project projectOf(Painting painting, UnknownPaintingMembers unknown = {})
{
    Project project;
    project.id = *Uuid::parse("11111111-2222-4333-8444-555555555555");
    project.documents.push_back(
        newDocument(documentId, "scene",
                    std::make_shared<const PaintingContent>(std::move(painting), std::move(unknown))));
    return project;
}

ProjectReadOptions withPaintings()
{
    ProjectReadOptions options;
    options.kinds = {paintingKind()};
    return options;
}

Result<Project> read(std::span<const std::byte> bytes)
{
    return parseProject(bytes, "a.ductus", withPaintings());
}

Bytes written(const Project &project)
{
    const Result<SerializedProject> result = serializedProject(project);
    if (!result)
        qFatal("%s", result.error().message().c_str());
    return result->bytes;
}

std::string entryName()
{
    return "documents/" + documentId.text() + ".json";
}

std::string textOf(const Bytes &bytes)
{
    const Container container = *readContainer(bytes, "a");
    const Bytes text = *unpacked(*container.find(entryName()), "a");
    return {reinterpret_cast<const char *>(text.data()), text.size()};
}

// The file with the document's text changed.
Bytes withText(const Bytes &bytes, const std::string &text)
{
    const Container container = *readContainer(bytes, "a");
    std::vector<StoredEntry> entries;
    for (const auto &[name, entry] : container.entries)
        entries.push_back(name == entryName() ? packedEntry(name, asBytes(text)) : entry);
    return *writtenContainer(entries);
}

Bytes replaced(const Bytes &bytes, const QByteArray &what, const QByteArray &by)
{
    QByteArray text = QByteArray::fromStdString(textOf(bytes));
    const auto at = text.indexOf(what);
    if (at < 0)
        qFatal("no %s in %s", what.constData(), text.constData());
    return withText(bytes, text.replace(at, what.size(), by).toStdString());
}

const PaintingContent &contentOf(const Project &project)
{
    return **paintingOf(project.documents[0]);
}

// A copy of the content, so that it is written anew.
Project touched(const Project &project)
{
    Project copy = project;
    const PaintingContent &content = contentOf(project);
    copy.documents[0].content =
        std::make_shared<const PaintingContent>(content.painting(), content.unknown());
    return copy;
}

} // namespace

class PaintingContentTest : public QObject
{
    Q_OBJECT
private slots:
    void everythingComesBackExactly();
    void duplicatesStillShareTheirShape();
    void framesAndEmptyDrawingsStay();
    void theSamePaintingGivesTheSameBytes();
    void untouchedPaintingsAreCopied();
    void unknownMembersAreKept();
    void unknownMembersOfGoneThingsGo();
    void onlyTheChangedLayerIsPackedAnew();
    void isKeptByProgramsThatDoNotKnowIt();
    void matchesItsSchema();
    void errorsNameTheField_data();
    void errorsNameTheField();
    void newerPaintingsAreKeptUnread();
    void writerRefusesWhatReadersRefuse();
    void mutationsNeverCrash();
    void savesTwoThousandStrokesInASecond();
};

void PaintingContentTest::everythingComesBackExactly()
{
    const Painting before = samplePainting(1);
    QVERIFY(checkPainting(before).ok());
    const Bytes first = written(projectOf(before));
    const Result<Project> project = read(first);
    QVERIFY2(project.ok(), project.ok() ? "" : project.error().message().c_str());
    // The text names buffers by their content: equal texts mean equal paintings down to the last bit.
    QCOMPARE(QByteArray::fromStdString(textOf(written(touched(*project)))),
             QByteArray::fromStdString(textOf(first)));
    QVERIFY(textOf(written(projectOf(samplePainting(2)))) != textOf(first));

    const Painting &after = contentOf(*project).painting();
    QCOMPARE(after.nextId, before.nextId);
    QCOMPARE(after.blendSpace, BlendSpace::Linear);
    QCOMPARE(after.background, before.background);
    QCOMPARE(after.camera.keys[1].timeSeconds, 4.0);
    QCOMPARE(after.looks[1].layers[1].second.opacity, 0.5);
    QCOMPARE(after.pictures[0].image->at(2, 1), before.pictures[0].image->at(2, 1));
    QCOMPARE(after.motionGroups[0].elements, before.motionGroups[0].elements);
    const Layer &shade = after.stacks[0].appearance[0];
    QCOMPARE(shade.properties.opacity, 0.1 + 0.2);
    QCOMPARE(*shade.properties.colour, Eigen::Vector3f(0.1f, 0.2f, 0.7f));
    QCOMPARE(shade.properties.masks.size(), std::size_t(4));
    QCOMPARE(std::get<NoiseMask>(shade.properties.masks[1].shape).seed, 18446744073709551615ull);
    QCOMPARE(std::get<TextureMask>(shade.properties.masks[2].shape).values->at(3), std::uint8_t(128));
    QVERIFY(shade.motion[1].placement == before.stacks[0].appearance[0].motion[1].placement);
    const Element &stroke = after.stacks[1].substrate->drawings[0].elements[1];
    const Element &same = before.stacks[1].substrate->drawings[0].elements[1];
    QVERIFY(stroke.placement == same.placement && stroke.id == same.id);
    const auto &points = std::get<StrokeShape>(*stroke.shape).points;
    QCOMPARE(points[6].position, std::get<StrokeShape>(*same.shape).points[6].position);
    QCOMPARE(points[6].halfWidth, std::get<StrokeShape>(*same.shape).points[6].halfWidth);
    QCOMPARE(std::get<StrokeShape>(*stroke.shape).section, std::get<StrokeShape>(*same.shape).section);
}

void PaintingContentTest::duplicatesStillShareTheirShape()
{
    const Result<Project> project = read(written(projectOf(samplePainting(1))));
    const Painting &after = contentOf(*project).painting();
    QCOMPARE(after.stacks[0].appearance[0].drawings[0].elements[0].shape,
             after.stacks[0].substrate->drawings[0].elements[0].shape);
}

void PaintingContentTest::framesAndEmptyDrawingsStay()
{
    const Result<Project> project = read(written(projectOf(samplePainting(1))));
    const Layer &frames = contentOf(*project).painting().stacks[1].appearance[0];
    QCOMPARE(frames.drawings.size(), std::size_t(3));
    QVERIFY(frames.drawings[1].elements.empty());
    QCOMPARE(frames.frames.drawingOfFrame, std::vector<int>({0, 1, 1, 2, 0}));
    QCOMPARE(frames.frames.framesPerSecond, 12.5);
    QVERIFY(read(written(projectOf({}))).ok());
}

void PaintingContentTest::theSamePaintingGivesTheSameBytes()
{
    QVERIFY(written(projectOf(samplePainting(3))) == written(projectOf(samplePainting(3))));
}

void PaintingContentTest::untouchedPaintingsAreCopied()
{
    // Formatted by another program: not a byte of it changes.
    const Bytes foreign =
        replaced(written(projectOf(samplePainting(1))), "\"loopSeconds\": 4.0", "\"loopSeconds\"  :  4.00");
    const Result<Project> project = read(foreign);
    const Result<SerializedProject> again = serializedProject(*project);
    QCOMPARE(again->packedBuffers, 0);
    QCOMPARE(textOf(again->bytes), textOf(foreign));
    QVERIFY(read(again->bytes).ok());
}

void PaintingContentTest::unknownMembersAreKept()
{
    Bytes bytes = written(projectOf(samplePainting(1)));
    const QByteArray added = "\"fromTheFuture\": {\"x\": 1.50}, ";
    for (const QByteArray object :
         {"\"name\": \"shade\"", "\"kind\": \"noise\"", "\"visible\": true", "\"perSecond\": 12.5",
          "\"ids\": {", "\"kind\": \"strokes\", \"sections\"", "\"kind\": \"mesh\", \"vertices\"",
          "\"name\": \"night\"", "\"name\": \"plane\"", "\"timeSeconds\": 2.5", "\"name\": \"target\"",
          "\"nextId\"", "\"keys\": [{\"timeSeconds\": 0.0, \"eye\""})
        bytes = replaced(bytes, object, added + object);
    const Result<Project> project = read(bytes);
    QVERIFY2(project.ok(), project.ok() ? "" : project.error().message().c_str());
    const QByteArray again = QByteArray::fromStdString(textOf(written(touched(*project))));
    QCOMPARE(again.count("{\"x\": 1.50}"), 13);
}

void PaintingContentTest::unknownMembersOfGoneThingsGo()
{
    const Bytes bytes = replaced(written(projectOf(samplePainting(1))), "\"name\": \"frames\"",
                                 "\"future\": 7, \"name\": \"frames\"");
    Project project = *read(bytes);
    const PaintingContent &content = contentOf(project);
    const Result<Painting> without =
        removeLayer(content.painting(), content.painting().stacks[1].appearance[0].id);
    QVERIFY(without.ok());
    project.documents[0].content = std::make_shared<const PaintingContent>(*without, content.unknown());
    QVERIFY(!QByteArray::fromStdString(textOf(written(project))).contains("future"));
}

void PaintingContentTest::onlyTheChangedLayerIsPackedAnew()
{
    Project project = *read(written(projectOf(samplePainting(1, 400, 60))));
    const PaintingContent &content = contentOf(project);
    Painting changed = content.painting();
    changed.stacks[1].substrate->drawings[0].elements.pop_back();
    project.documents[0].content = std::make_shared<const PaintingContent>(changed, content.unknown());
    const Result<SerializedProject> saved = serializedProject(project);
    QVERIFY(saved.ok());
    qInfo("%d buffers packed, %d copied", saved->packedBuffers, saved->copiedBuffers);
    QVERIFY(saved->copiedBuffers >= 3);
    QVERIFY(saved->packedBuffers <= 5); // the last block, and small columns behind it
    // What no stroke needs any more is gone.
    const Result<Project> again = read(saved->bytes);
    QCOMPARE(int(again->buffers.entries().size()), saved->packedBuffers + saved->copiedBuffers);
    QVERIFY(again->keptBuffers.empty());
}

void PaintingContentTest::isKeptByProgramsThatDoNotKnowIt()
{
    const Bytes bytes = written(projectOf(samplePainting(1)));
    const Result<Project> unread = parseProject(bytes, "a.ductus");
    QVERIFY(unread.ok() && !unread->documents[0].content);
    QCOMPARE(paintingOf(unread->documents[0]).error().code, ErrorCode::Unsupported);
    QVERIFY(written(*unread) == bytes);
}

void PaintingContentTest::matchesItsSchema()
{
    const auto lines = projectSchemaViolations(written(projectOf(samplePainting(1))), "a");
    QVERIFY2(lines.ok(), lines.ok() ? "" : lines.error().message().c_str());
    QVERIFY2(lines->empty(), lines->empty() ? "" : lines->front().c_str());
    const auto wrong = projectSchemaViolations(
        replaced(written(projectOf(samplePainting(1))), "\"blend\": \"normal\"", "\"blend\": \"odd\""), "a");
    QVERIFY(wrong.ok() && !wrong->empty());
}

void PaintingContentTest::errorsNameTheField_data()
{
    QTest::addColumn<QByteArray>("what");
    QTest::addColumn<QByteArray>("by");
    QTest::addColumn<QByteArray>("place");
    const auto row = [](const char *name, const char *what, const char *by, const char *place) {
        QTest::newRow(name) << QByteArray(what) << QByteArray(by) << QByteArray(place);
    };
    row("opacity", "\"opacity\": 1.0", "\"opacity\": 1.5", "/stacks/0/substrate/properties/opacity");
    row("blend mode", "\"blend\": \"normal\"", "\"blend\": \"odd\"", "/properties/blend");
    row("id as text", "\"id\": 2", "\"id\": \"2\"", "/stacks/0/substrate/id");
    row("repeated id", "\"id\": 2,", "\"id\": 1,", "used twice");
    row("id beyond the next", "\"nextId\": ", "\"nextId\": 1, \"wasNextId\": ", "not below the next");
    row("no substrate", "\"substrate\":", "\"wasSubstrate\":", "no substrate");
    row("mask kind", "\"kind\": \"noise\"", "\"kind\": \"nose\"", "/masks/1/kind");
    row("texture size", "\"width\": 2", "\"width\": 3", "as many values as cells");
    row("texture bomb", "\"width\": 2", "\"width\": 2000000000", "/masks/2/width");
    row("missing layer", "\"kind\": \"strokes\", \"enabled\": true, \"inverted\": true, \"layer\": 2",
        "\"kind\": \"strokes\", \"enabled\": true, \"inverted\": true, \"layer\": 999", "not there");
    row("frame", "\"repeatCount\": 3", "\"repeatCount\": -3", "/frames/repeatCount");
    row("missing array", "\"shapes\": {\"buffer\"", "\"wasShapes\": {\"buffer\"", "/drawings/0/shapes");
    row("array length", "\"shape\": [5]", "\"shape\": [4]", "");
    row("array overflow", "\"shape\": [5]", "\"shape\": [18446744073709551615]", "");
    row("offset", "\"offset\": 8", "\"offset\": 9000000", "");
    row("rotation", "\"rotation\": [0.0, 0.0, 0.0, 1.0]", "\"rotation\": [0.0, 0.0, 0.0, 7.0]", "");
    row("short rotation", "\"rotation\": [0.0, 0.0, 0.0, 1.0]", "\"rotation\": [0.0, 0.0, 1.0]", "/rotation");
    row("picture", "\"height\": 2", "\"height\": 3", "/pictures/0/pixels");
    row("background", "0.20000000298023224", "9.5", "background");
    row("stacks", "\"stacks\": [", "\"stacks\": 5, \"was\": [", "/stacks");
}

void PaintingContentTest::errorsNameTheField()
{
    QFETCH(QByteArray, what);
    QFETCH(QByteArray, by);
    QFETCH(QByteArray, place);
    const Result<Project> project = read(replaced(written(projectOf(samplePainting(1))), what, by));
    QVERIFY(!project.ok());
    const QByteArray message = QByteArray::fromStdString(project.error().message());
    QVERIFY2(message.contains(place) && message.contains("a.ductus:documents/"), message.constData());
    QCOMPARE(project.error().code, ErrorCode::Malformed);
}

void PaintingContentTest::newerPaintingsAreKeptUnread()
{
    const Bytes bytes =
        replaced(replaced(written(projectOf(samplePainting(1))), "\"version\": 1", "\"version\": 9"),
                 "\"minReader\": 1", "\"minReader\": 9");
    const Result<Project> project = read(bytes);
    QVERIFY(project.ok());
    QVERIFY(project->documents[0].readOnly && !project->documents[0].content);
    QCOMPARE(paintingOf(project->documents[0]).error().code, ErrorCode::NewerVersion);
    QCOMPARE(textOf(written(*project)), textOf(bytes));
}

void PaintingContentTest::writerRefusesWhatReadersRefuse()
{
    Painting painting = samplePainting(1);
    painting.stacks[0].substrate->properties.opacity = std::nan("");
    const auto saved = serializedProject(projectOf(painting));
    QVERIFY(!saved.ok());
    QCOMPARE(saved.error().code, ErrorCode::InvalidArgument);
    painting = samplePainting(1);
    painting.stacks[0].name = "\xff";
    QVERIFY(!serializedProject(projectOf(painting)).ok());
    painting = samplePainting(1);
    painting.pictures[0].image = std::make_shared<const Image>();
    QVERIFY(!serializedProject(projectOf(painting)).ok());
}

void PaintingContentTest::mutationsNeverCrash()
{
    const Bytes bytes = written(projectOf(samplePainting(1)));
    const std::string text = textOf(bytes);
    Random random(5);
    int readable = 0;
    for (int round = 0; round < 400; ++round) {
        std::string changed = text;
        for (int k = 0; k < 1 + random.index(2); ++k) {
            const std::size_t at = std::size_t(random.index(int(changed.size())));
            switch (random.index(3)) {
            case 0:
                changed[at] = "0123456789[]{},-\"e"[random.index(18)];
                break;
            case 1:
                changed.erase(at, std::size_t(random.index(40)));
                break;
            default:
                changed.insert(at, changed.substr(at, std::size_t(random.index(200))));
            }
        }
        const Result<Project> project = read(withText(bytes, changed));
        if (!project.ok())
            continue;
        ++readable;
        if (project->documents[0].content)
            QVERIFY(checkPainting(contentOf(*project).painting()).ok());
    }
    qInfo("%d of 400 mutations could be read", readable);
    QVERIFY(readable > 0 && readable < 390);
}

void PaintingContentTest::savesTwoThousandStrokesInASecond()
{
    const Project project = projectOf(samplePainting(1, 1000, 50));
    // Of the processor, as others may work beside the test.
    const auto millisecondsSince = [](std::clock_t from) {
        return 1e3 * double(std::clock() - from) / CLOCKS_PER_SEC;
    };
    std::clock_t start = std::clock();
    const Bytes bytes = written(project);
    const double writing = millisecondsSince(start);
    start = std::clock();
    const Result<Project> again = read(bytes);
    const double reading = millisecondsSince(start);
    QVERIFY(again.ok());
    start = std::clock();
    written(touched(*again));
    qInfo("2000 strokes of 50 points, %.1f MB: %.0f ms to write, %.0f ms to read, %.0f ms to write again",
          double(bytes.size()) / 1e6, writing, reading, millisecondsSince(start));
    QVERIFY(writing < 1000.0);
}

QTEST_APPLESS_MAIN(PaintingContentTest)
#include "painting_content_test.moc"
