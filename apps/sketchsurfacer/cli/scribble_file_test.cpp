#include "sketchsurfacer/cli/scribble_file.h"

#include <QtTest>

using namespace ductus;

class ScribbleFileTest : public QObject
{
    Q_OBJECT
private slots:
    void everyKindArrives();
    void wrongFilesAreRefused_data();
    void wrongFilesAreRefused();
    void missingFileIsNamed();
};

void ScribbleFileTest::everyKindArrives()
{
    const auto scribbles = parseScribbles(
        R"({"schema": "scribbles", "version": 1, "scribbles": [
            {"kind": "new-region", "points": [[1, 2, 3], [1.5, -2e-3, 0]]}, {"kind": "merge", "points": [[0, 0, 0]]},
            {"kind": "seam", "points": [[0, 0, 0]]}, {"kind": "forbid-seam", "points": [[0, 0, 0]]},
            {"kind": "split", "points": [[0, 0, 0]], "options": {}}, {"kind": "lock", "points": [[0, 0, 0]]},
            {"kind": "set-degree", "points": [[0, 0, 0]], "options": {"degree": 2}}]})",
        "s.json");
    QVERIFY2(scribbles.ok(), scribbles ? "" : scribbles.error().message().c_str());
    QCOMPARE(scribbles->size(), std::size_t(7));
    QCOMPARE((*scribbles)[0].points, (std::vector<Vec3>{Vec3(1, 2, 3), Vec3(1.5, -2e-3, 0)}));
    for (std::size_t i = 0; i < 7; ++i)
        QCOMPARE(int((*scribbles)[i].kind), int(i));
    QCOMPARE((*scribbles)[6].degree, 2);
    QCOMPARE((*scribbles)[0].degree, 0);
}

void ScribbleFileTest::wrongFilesAreRefused_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("place");
    const auto row = [](const char *name, const QString &text, const QString &place) {
        QTest::newRow(name) << text << place;
    };
    const auto with = [](const QString &scribble) {
        return QStringLiteral("{\"schema\": \"scribbles\", \"version\": 1, \"scribbles\": [%1]}")
            .arg(scribble);
    };
    row("empty", "", "s.json");
    row("another thing", "{\"schema\": \"project\"}", "s.json");
    row("newer", "{\"schema\": \"scribbles\", \"version\": 2, \"scribbles\": []}", "#/version");
    row("no list", "{\"schema\": \"scribbles\", \"version\": 1}", "#/scribbles");
    row("unknown kind", with(R"({"kind": "erase", "points": [[0,0,0]]})"), "#/scribbles/0/kind");
    row("no points", with(R"({"kind": "merge"})"), "#/scribbles/0/points");
    row("empty points", with(R"({"kind": "merge", "points": []})"), "#/scribbles/0/points");
    row("flat point", with(R"({"kind": "merge", "points": [[0,0,0],[0,0]]})"), "#/scribbles/0/points/1");
    row("text for a number", with(R"({"kind": "merge", "points": [[0,0,"1"]]})"), "#/scribbles/0/points/0");
    row("huge", with(R"({"kind": "merge", "points": [[0,0,1e300]]})"), "#/scribbles/0/points/0");
    row("misspelt", with(R"({"kind": "merge", "points": [[0,0,0]], "degre": 1})"), "#/scribbles/0/degre");
    row("degree 7", with(R"({"kind": "merge", "points": [[0,0,0]], "options": {"degree": 7}})"),
        "/options/degree");
    row("degree missing", with(R"({"kind": "set-degree", "points": [[0,0,0]]})"), "/options/degree");
}

void ScribbleFileTest::wrongFilesAreRefused()
{
    QFETCH(QString, text);
    QFETCH(QString, place);
    const auto scribbles = parseScribbles(text.toStdString(), "s.json");
    QVERIFY(!scribbles.ok());
    QVERIFY2(QString::fromStdString(scribbles.error().place).contains(place),
             scribbles.error().message().c_str());
}

void ScribbleFileTest::missingFileIsNamed()
{
    const auto scribbles = readScribbles("no/such/scribbles.json");
    QVERIFY(!scribbles.ok());
    QVERIFY(scribbles.error().message().find("no/such/scribbles.json") != std::string::npos);
}

QTEST_APPLESS_MAIN(ScribbleFileTest)
#include "scribble_file_test.moc"
