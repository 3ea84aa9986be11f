#include "project/json/json_reader.h"

#include "base/random.h"
#include "project/json/json_writer.h"

#include <QtTest>

using namespace ductus;

namespace {

constexpr std::pair<std::string_view, int> colours[] = {{"red", 1}, {"blue", 2}};

} // namespace

class JsonReaderTest : public QObject
{
    Q_OBJECT
private slots:
    void valuesAndPaths();
    void firstProblemStays();
    void unknownMembersAreRawText();
    void rawTextIsCutAtTheRightPlaces();
    void scannerSurvivesAnything();
    void depthAndSyntaxAreBounded();
    void writtenTextParsesToTheSame();
};

void JsonReaderTest::valuesAndPaths()
{
    const JsonDocument json = *parsedJson(
        R"({"a": {"n": 0.1, "i": -7, "u": 18446744073709551615, "s": "x", "t": [1,2.5,-3], "b": true},
                        "list": [{"c": "blue"}, {"c": "green"}]})",
        "f:e");
    const JsonReader reader(json, "f:e");
    const JsonReader a = reader.member("a");
    QCOMPARE(a.number("n", 0, 1), 0.1);
    QCOMPARE(a.integer("i", -10, 10), std::int64_t(-7));
    QCOMPARE(a.unsignedInteger("u"), UINT64_MAX);
    QCOMPARE(a.string("s", 1), std::string("x"));
    QVERIFY((a.triple("t") == std::array<double, 3>{1, 2.5, -3}));
    QVERIFY(a.boolean("b"));
    QVERIFY(!a.has("z") && a.has("n"));
    QCOMPARE(a.path(), std::string("f:e#/a"));
    const std::vector<JsonReader> list = reader.elements("list", 2);
    QCOMPARE(list[0].oneOf<int>("c", colours), 2);
    QVERIFY(!reader.failed());
    list[1].oneOf<int>("c", colours);
    QVERIFY(reader.failed());
    QCOMPARE(reader.error().place, std::string("f:e#/list/1/c"));
}

void JsonReaderTest::firstProblemStays()
{
    const auto placeOf = [](const std::function<void(const JsonReader &)> &ask) {
        const JsonDocument json =
            *parsedJson(R"({"n": 5, "s": "text", "a": [1], "big": 1e300, "o": {"x": 1, "x": 2}})", "p");
        const JsonReader reader(json, "p");
        ask(reader);
        reader.string("later", 9);
        return reader.error().place;
    };
    using R = const JsonReader &;
    QCOMPARE(placeOf([](R r) { r.number("n", 6, 7); }), std::string("p#/n"));
    QCOMPARE(placeOf([](R r) { r.integer("big", 0, 9); }), std::string("p#/big"));
    QCOMPARE(placeOf([](R r) { r.string("s", 3); }), std::string("p#/s"));
    QCOMPARE(placeOf([](R r) { r.elements("a", 0); }), std::string("p#/a"));
    QCOMPARE(placeOf([](R r) { r.elements("a", 1); }), std::string("p#/a/0"));
    QCOMPARE(placeOf([](R r) { r.member("o"); }), std::string("p#/o"));
    QCOMPARE(placeOf([](R r) { r.member("missing").number("n", 0, 1); }), std::string("p#/missing"));
    QCOMPARE(placeOf([](R r) { r.triple("a"); }), std::string("p#/a"));
    QCOMPARE(placeOf([](R) {}), std::string("p#/later"));
}

void JsonReaderTest::unknownMembersAreRawText()
{
    const JsonDocument json =
        *parsedJson("{\"known\": 1,\n \"x\" :  [1.50 , {\"}\": \"\\\"]\"}] , \"y\":-0}", "p");
    const UnknownMembers unknown = JsonReader(json, "p").unknown({"known"});
    QCOMPARE(unknown.size(), std::size_t(2));
    QCOMPARE(unknown[0].first, std::string("x"));
    QCOMPARE(unknown[0].second, std::string("[1.50 , {\"}\": \"\\\"]\"}]"));
    QCOMPARE(unknown[1].second, std::string("-0"));
    OrderedJson object = {{"known", 2}, {"y", 3}};
    addUnknown(object, unknown);
    QCOMPARE(jsonText(object, 0),
             std::string("{\"known\": 2, \"y\": 3, \"x\": [1.50 , {\"}\": \"\\\"]\"}]}\n"));
}

void JsonReaderTest::rawTextIsCutAtTheRightPlaces()
{
    QVERIFY(rawMembers(" { } ").empty());
    QVERIFY(rawElements("[ ]").empty());
    const std::vector<std::string_view> elements = rawElements("[ 1 ,[2,3], {\"a\":[4]} ,\"],\" ]");
    QCOMPARE(elements.size(), std::size_t(4));
    QCOMPARE(elements[1], std::string_view("[2,3]"));
    QCOMPARE(elements[2], std::string_view("{\"a\":[4]}"));
    QCOMPARE(elements[3], std::string_view("\"],\""));
}

void JsonReaderTest::scannerSurvivesAnything()
{
    Random random(4);
    const std::string_view alphabet = "{}[]\",:\\ 1a";
    for (int round = 0; round < 20000; ++round) {
        std::string text = round % 2 ? "{" : "[";
        for (int length = random.index(12); length > 0; --length)
            text += alphabet[std::size_t(random.index(int(alphabet.size())))];
        const auto isInside = [&](std::string_view part) {
            return part.data() >= text.data() && part.data() + part.size() <= text.data() + text.size();
        };
        for (const RawMember &member : rawMembers(text))
            QVERIFY(isInside(member.key) && isInside(member.value));
        for (std::string_view element : rawElements(text))
            QVERIFY(isInside(element));
        QVERIFY(jsonDepth(text) <= text.size());
    }
}

void JsonReaderTest::depthAndSyntaxAreBounded()
{
    QVERIFY(parsedJson(std::string(64, '[') + std::string(64, ']'), "p").ok());
    QVERIFY(!parsedJson(std::string(65, '[') + std::string(65, ']'), "p").ok());
    QVERIFY(!parsedJson(std::string(10'000'000, '['), "p").ok());
    QCOMPARE(parsedJson("{\n \"a\": ?}", "f:e").error().place, std::string("f:e:2:7"));
    for (const char *bad :
         {"", "{", "nul", "1e999", "\"\xff\"", "{\"a\":1,}", "// x\n1", "NaN", "\xef\xbb\xbf"})
        QVERIFY2(!parsedJson(bad, "p").ok(), bad);
}

void JsonReaderTest::writtenTextParsesToTheSame()
{
    const OrderedJson value = {
        {"z", 0.1}, {"a", {1, 2, {{"deep", nullptr}}}}, {"e", OrderedJson::array()}, {"s", "\"\xc3\xa9"}};
    for (int levels = 0; levels < 5; ++levels)
        QVERIFY(OrderedJson::parse(jsonText(value, levels)) == value);
    QCOMPARE(jsonText(value, 1), std::string("{\n \"z\": 0.1,\n \"a\": [1, 2, {\"deep\": null}],\n \"e\": "
                                             "[],\n \"s\": \"\\\"\xc3\xa9\"\n}\n"));
}

QTEST_APPLESS_MAIN(JsonReaderTest)
#include "json_reader_test.moc"
