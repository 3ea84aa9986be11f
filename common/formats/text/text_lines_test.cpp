#include "formats/text/text_lines.h"

#include "base/random.h"
#include "formats/text/number_text.h"

#include <QtTest>
#include <cmath>
#include <fstream>

using namespace ductus;

namespace {

std::vector<std::string> linesOf(TextLines &lines, bool join = false)
{
    std::vector<std::string> all;
    for (std::string_view line; lines.next(line, join);)
        all.emplace_back(line);
    return all;
}

} // namespace

class TextLinesTest : public QObject
{
    Q_OBJECT
private slots:
    void streamedFilesGiveTheSameLinesAsMemory();
    void longLinesAreJoinedFromManyReads();
    void aFileWithoutLineEndsIsRefused();
    void continuedLines();
    void headDoesNotConsume();
    void numbersAreReadWhole_data();
    void numbersAreReadWhole();
    void numbersComeBack();
    void messagesHoldNoControlCharacters();
};

void TextLinesTest::streamedFilesGiveTheSameLinesAsMemory()
{
    // Files of several reads with all line ends mixed, so that ends fall on the borders of reads.
    QTemporaryDir folder;
    const std::filesystem::path path = std::filesystem::path(folder.path().toStdString()) / "a.txt";
    for (int run = 0; run < 8; ++run) {
        Random random(std::uint64_t(run) + 1);
        std::string text;
        std::vector<std::string> expected;
        while (text.size() < 700'000) {
            expected.emplace_back(std::size_t(random.index(run < 4 ? 3 : 2000)),
                                  char('a' + random.index(26)));
            // "\r" and then an empty line ended by "\n" would be one end, so "\n" never follows "\r" here.
            static constexpr const char *ends[] = {"\r\n", "\r", "\n"};
            const int end = random.index(3);
            text += expected.back() +
                    (end == 2 && text.ends_with('\r') && expected.back().empty() ? "\r" : ends[end]);
        }
        std::ofstream(path, std::ios::binary) << text;
        auto file = TextLines::open(path, "Reading");
        QVERIFY(file.ok());
        QVERIFY(linesOf(*file) == expected);
        QVERIFY(!file->failure());
        QCOMPARE(file->lineNumber(), std::int64_t(expected.size()));
        QCOMPARE(file->bytesGivenOut(), std::uint64_t(text.size()));
        TextLines memory(text, "a.txt", "Reading");
        QVERIFY(linesOf(memory) == expected);
    }
}

void TextLinesTest::longLinesAreJoinedFromManyReads()
{
    QTemporaryDir folder;
    const std::filesystem::path path = std::filesystem::path(folder.path().toStdString()) / "a.txt";
    const std::string longLine(3'000'000, 'x');
    std::ofstream(path) << "a\n" << longLine << "\nb";
    auto file = TextLines::open(path, "Reading");
    QVERIFY(file.ok());
    QVERIFY(linesOf(*file) == (std::vector<std::string>{"a", longLine, "b"}));
    QVERIFY(file->lastLineIsOpen());
}

void TextLinesTest::aFileWithoutLineEndsIsRefused()
{
    QTemporaryDir folder;
    const std::filesystem::path path = std::filesystem::path(folder.path().toStdString()) / "a.txt";
    {
        std::ofstream file(path);
        for (int i = 0; i < 40; ++i)
            file << std::string(1'000'000, '1');
    }
    auto lines = TextLines::open(path, "Reading");
    QVERIFY(lines.ok());
    QVERIFY(linesOf(*lines).empty());
    QVERIFY(lines->failure().has_value());
    QCOMPARE(lines->failure()->place, std::string("a.txt:1"));
}

void TextLinesTest::continuedLines()
{
    TextLines lines("l 1 \\\n2\\\r\n3\nx\\", "a.obj", "Reading");
    QVERIFY(linesOf(lines, true) == (std::vector<std::string>{"l 1  2 3", "x"}));
    TextLines plain("l 1 \\\n2\n", "a.obj", "Reading");
    QVERIFY(linesOf(plain) == (std::vector<std::string>{"l 1 \\", "2"}));
}

void TextLinesTest::headDoesNotConsume()
{
    TextLines lines("a\nb\n", "a", "Reading");
    QVERIFY(lines.head() == "a\nb\n");
    QCOMPARE(linesOf(lines).size(), std::size_t(2));
}

void TextLinesTest::numbersAreReadWhole_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("fault");
    QTest::addColumn<double>("value");
    const auto row = [](const char *text, NumberFault fault, double value) {
        QTest::newRow(text) << QByteArray(text) << int(fault) << value;
    };
    constexpr NumberFault none = NumberFault::None;
    row("1", none, 1);
    row("-0.5", none, -0.5);
    row("+2.5e3", none, 2500);
    row(".5", none, 0.5);
    row("5.", none, 5);
    row("4.23855247789e-07", none, 4.23855247789e-07);
    row("1e-400", none, 0);
    row("-1E-999", none, 0);
    row("1e400", NumberFault::TooLarge, 0);
    row("1e31", NumberFault::TooLarge, 0);
    row("nan", NumberFault::NotFinite, 0);
    row("-nan(ind)", NumberFault::NotFinite, 0);
    row("INF", NumberFault::NotFinite, 0);
    row("1,5", NumberFault::DecimalComma, 0);
    row("1.5x", NumberFault::NotANumber, 0);
    row("0x10", NumberFault::NotANumber, 0);
    row("--1", NumberFault::NotANumber, 0);
    row("+-1", NumberFault::NotANumber, 0);
    row("+", NumberFault::NotANumber, 0);
    row("1.#QNAN", NumberFault::NotANumber, 0);
    row("", NumberFault::NotANumber, 0);
}

void TextLinesTest::numbersAreReadWhole()
{
    QFETCH(QByteArray, text);
    QFETCH(int, fault);
    QFETCH(double, value);
    double read = 77.0;
    QCOMPARE(int(readNumber(text.toStdString(), read)), fault);
    QCOMPARE(read, fault == int(NumberFault::None) ? value : 77.0);
}

void TextLinesTest::numbersComeBack()
{
    Random random(6);
    for (int i = 0; i < 20000; ++i) {
        const double value = random.normal() * std::pow(10.0, random.index(50) - 25);
        std::string text;
        appendNumber(text, value);
        double back = 0.0;
        QVERIFY(readNumber(text, back) == NumberFault::None);
        QVERIFY(back == value);
    }
    std::string text;
    appendNumber(text, 0.1);
    appendNumber(text, std::int64_t(-7));
    QCOMPARE(text, std::string("0.1-7"));
}

void TextLinesTest::messagesHoldNoControlCharacters()
{
    QCOMPARE(inQuotes("a\x1b[31m\n"), std::string("'a?[31m?'"));
    QCOMPARE(inQuotes(std::string(100, 'x')).size(), std::size_t(45));
}

QTEST_APPLESS_MAIN(TextLinesTest)
#include "text_lines_test.moc"
