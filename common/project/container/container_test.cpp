#include "project/container/container_reader.h"

#include "base/random.h"
#include "formats/archive/zip_directory.h"
#include "project/container/container_writer.h"
#include "project/container/entry_name.h"
#include "project/testing/container_surgery.h"

#include <zip.h>

#include <QtTest>

using namespace ductus;

namespace {

struct ForeignEntry
{
    std::string name;
    std::string content;
    bool packed = false;
};

// A zip as another program would write it, with libzip alone.
Bytes foreignZip(const std::vector<ForeignEntry> &entries)
{
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t *target = zip_source_buffer_create(nullptr, 0, 0, &error);
    zip_t *zip = zip_open_from_source(target, ZIP_CREATE | ZIP_TRUNCATE, &error);
    zip_source_keep(target);
    for (const ForeignEntry &entry : entries) {
        zip_source_t *source = zip_source_buffer(zip, entry.content.data(), entry.content.size(), 0);
        const zip_int64_t index = zip_file_add(zip, entry.name.c_str(), source, 0);
        zip_set_file_compression(zip, zip_uint64_t(index), entry.packed ? ZIP_CM_DEFLATE : ZIP_CM_STORE, 9);
    }
    zip_close(zip);
    zip_stat_t stat;
    zip_source_stat(target, &stat);
    Bytes bytes(stat.size);
    zip_source_open(target);
    zip_source_read(target, bytes.data(), bytes.size());
    zip_source_close(target);
    zip_source_free(target);
    return bytes;
}

const ForeignEntry mimeTypeEntry = {"mimetype", std::string(ductusMimeType)};

std::string problemOf(const Bytes &bytes, const ContainerLimits &limits = {})
{
    const Result<Container> container = readContainer(bytes, "x.ductus", limits);
    return container.ok() ? "" : container.error().problem;
}

} // namespace

class ContainerTest : public QObject
{
    Q_OBJECT
private slots:
    void entriesComeBack();
    void packedBytesAreCopiedAsTheyAre();
    void extremelyPackableEntriesAreStoredAndReadable();
    void namesAreChecked();
    void pathsOutOfTheContainerAreRefused();
    void repeatedNamesAreRefused();
    void missingOrWrongMimetypeIsRefused();
    void misplacedMimetypeIsMended();
    void zipBombsAreRefused();
    void limitsHold();
    void hugeEntryCountsAreSeenBeforeOpening();
    void everyTruncationIsRefused();
    void wrongChecksumIsFound();
    void otherFilesAreRefused();
    void writerKeepsItsOwnRules();
};

void ContainerTest::entriesComeBack()
{
    std::vector<StoredEntry> entries;
    Random random(1);
    for (int i = 0; i < 50; ++i) {
        std::string content(std::size_t(random.index(3000)), 'a');
        for (char &c : content)
            c = char(random.index(1 + i * 5));
        entries.push_back(packedEntry("folder/\xc3\xa9-" + std::to_string(i), asBytes(content)));
        QCOMPARE(textOf(entries.back()), content);
    }
    const Result<Bytes> bytes = writtenContainer(entries);
    QVERIFY(bytes.ok());
    const Result<Container> container = readContainer(*bytes, "a");
    QVERIFY(container.ok());
    QCOMPARE(container->entries.size(), entries.size());
    QVERIFY(container->warnings.empty());
    for (const StoredEntry &entry : entries)
        QCOMPARE(textOf(container->entries.at(entry.name)), textOf(entry));
}

void ContainerTest::packedBytesAreCopiedAsTheyAre()
{
    std::string content;
    for (int i = 0; i < 2000; ++i)
        content += "line " + std::to_string(i % 17) + "\n";
    const Bytes foreign = foreignZip({mimeTypeEntry, {"a.txt", content, true}});
    const StoredEntry read = readContainer(foreign, "a")->entries.at("a.txt"); // level 9, ours is another
    QVERIFY(*read.packed != *packedEntry("a.txt", asBytes(content)).packed);
    const Bytes written = *writtenContainer(std::span(&read, 1));
    QVERIFY(*readContainer(written, "a")->entries.at("a.txt").packed == *read.packed);
}

void ContainerTest::extremelyPackableEntriesAreStoredAndReadable()
{
    const Bytes zeros(5 << 20);
    const StoredEntry entry = packedEntry("zeros", zeros);
    QCOMPARE(entry.method, PackMethod::Stored);
    QCOMPARE(problemOf(*writtenContainer(std::span(&entry, 1))), std::string());
}

void ContainerTest::namesAreChecked()
{
    for (const char *good :
         {"a", "documents/x.json", "\xe5\xb8\xbd/\xf0\x9f\x8e\xa9", "a b", "...", "a..b", "folder/"})
        QCOMPARE(entryNameProblem(good), std::string());
    for (const char *bad :
         {"", "/a", "../a", "a/../b", "a/..", "./a", "a//b", "/", "a\\b", "C:x", "a\nb", "\xff", "\xc0\x80",
          "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xe5\xb8", "a/./b", ".", ".."})
        QVERIFY2(!entryNameProblem(bad).empty(), bad);
    QVERIFY(!entryNameProblem(std::string(513, 'a')).empty());
    QVERIFY(sha256OfBufferEntry("buffers/" + std::string(64, 'a') + ".bin").size() == 64);
    QVERIFY(sha256OfBufferEntry("buffers/" + std::string(64, 'A') + ".bin").empty());
    QVERIFY(sha256OfBufferEntry("buffers/.bin").empty());
}

void ContainerTest::pathsOutOfTheContainerAreRefused()
{
    for (const char *name : {"../x", "/etc/passwd", "a/../../b", "a\\b", "c:evil"})
        QVERIFY2(!problemOf(foreignZip({mimeTypeEntry, {name, "x"}})).empty(), name);
}

void ContainerTest::repeatedNamesAreRefused()
{
    const Bytes bytes = foreignZip({mimeTypeEntry, {"aaa", "one"}, {"bbb", "two"}});
    QCOMPARE(problemOf(bytes), std::string());
    QVERIFY(problemOf(withBytesReplaced(bytes, "bbb", "aaa")).find("same name") != std::string::npos);
    const Bytes twoTypes = foreignZip({mimeTypeEntry, {"mimetypf", std::string(ductusMimeType)}});
    QVERIFY(problemOf(withBytesReplaced(twoTypes, "mimetypf", "mimetype")).find("same name") !=
            std::string::npos);
}

void ContainerTest::missingOrWrongMimetypeIsRefused()
{
    QVERIFY(problemOf(foreignZip({{"a", "b"}})).find("mimetype") != std::string::npos);
    QVERIFY(!problemOf(foreignZip({{"mimetype", "image/openraster"}})).empty());
    QVERIFY(!problemOf(foreignZip({{"mimetype", std::string(ductusMimeType) + "\n"}})).empty());
    QVERIFY(!problemOf(foreignZip({{"mimetype", std::string(100000, 'x'), true}})).empty());
}

void ContainerTest::misplacedMimetypeIsMended()
{
    const Result<Container> container = readContainer(foreignZip({{"a", "b"}, mimeTypeEntry}), "a");
    QVERIFY(container.ok());
    QCOMPARE(container->warnings.size(), std::size_t(1));
}

void ContainerTest::zipBombsAreRefused()
{
    const std::string zeros(4 << 20, '\0');
    const Bytes bomb = foreignZip({mimeTypeEntry, {"bomb", zeros, true}});
    QVERIFY(bomb.size() < 10000);
    const Result<Container> container = readContainer(bomb, "a");
    QCOMPARE(container.error().code, ErrorCode::TooLarge);
    QCOMPARE(container.error().place, std::string("a:bomb"));

    // An entry that says it is small but unpacks to more.
    StoredEntry liar = packedEntry("liar", asBytes(std::string(1000, 'x')));
    liar.size = 10;
    QCOMPARE(unpacked(liar, "p").error().code, ErrorCode::Malformed);
    liar.size = 2000;
    QCOMPARE(unpacked(liar, "p").error().code, ErrorCode::Malformed);
}

void ContainerTest::limitsHold()
{
    const Bytes bytes =
        foreignZip({mimeTypeEntry, {"a", std::string(100, 'a')}, {"b", std::string(100, 'b')}});
    const auto with = [&](auto change) {
        ContainerLimits limits;
        change(limits);
        const Result<Container> container = readContainer(bytes, "a", limits);
        return container.ok() ? -1 : int(container.error().code);
    };
    QCOMPARE(with([](ContainerLimits &) {}), -1);
    QCOMPARE(with([](ContainerLimits &l) { l.maxEntries = 3; }), -1);
    QCOMPARE(with([](ContainerLimits &l) { l.maxEntries = 2; }), int(ErrorCode::TooLarge));
    QCOMPARE(with([](ContainerLimits &l) { l.maxEntryBytes = 99; }), int(ErrorCode::TooLarge));
    QCOMPARE(with([](ContainerLimits &l) { l.maxTotalBytes = 199; }), int(ErrorCode::TooLarge));
    QCOMPARE(with([](ContainerLimits &l) { l.maxFileBytes = 100; }), int(ErrorCode::TooLarge));
}

void ContainerTest::hugeEntryCountsAreSeenBeforeOpening()
{
    Bytes bytes = foreignZip({mimeTypeEntry});
    QCOMPARE(largestEntryCount(bytes), std::uint64_t(1));
    // A zip64 directory that claims 2^40 entries, before an ordinary end record.
    const Bytes end(bytes.end() - 22, bytes.end());
    const std::uint64_t recordOffset = bytes.size() - 22;
    bytes.resize(recordOffset);
    const auto append = [&bytes](std::uint64_t value, int count) {
        for (int k = 0; k < count; ++k)
            bytes.push_back(std::byte(value >> (8 * k)));
    };
    append(0x06064b50, 4);
    append(44, 8);
    append(45, 2);
    append(45, 2);
    append(0, 8);
    append(1ull << 40, 8);
    append(1ull << 40, 8);
    append(46, 8);
    append(0, 8);
    append(0x07064b50, 4);
    append(0, 4);
    append(recordOffset, 8);
    append(1, 4);
    bytes.insert(bytes.end(), end.begin(), end.end());
    QCOMPARE(largestEntryCount(bytes), std::uint64_t(1) << 40);
    QVERIFY(problemOf(bytes).find("too many entries") != std::string::npos);
    QCOMPARE(largestEntryCount({}), std::uint64_t(0));
}

void ContainerTest::everyTruncationIsRefused()
{
    const Bytes bytes = foreignZip({mimeTypeEntry, {"a", std::string(100, 'a'), true}});
    for (std::size_t size = 0; size < bytes.size(); ++size)
        QVERIFY(!readContainer(std::span(bytes).first(size), "a").ok());
}

void ContainerTest::wrongChecksumIsFound()
{
    const Bytes bytes =
        withBytesReplaced(foreignZip({mimeTypeEntry, {"a", "the content"}}), "the content", "The content");
    const Result<Container> container = readContainer(bytes, "a");
    QVERIFY(container.ok()); // contents are checked when they are needed
    QCOMPARE(unpacked(container->entries.at("a"), "p").error().code, ErrorCode::Malformed);
}

void ContainerTest::otherFilesAreRefused()
{
    const std::string text(1000, 'P');
    for (const std::string &content : {std::string(), std::string("PK"), text}) {
        const Result<Container> container = readContainer(asBytes(content), "a");
        QCOMPARE(container.error().code, ErrorCode::Malformed);
    }
}

void ContainerTest::writerKeepsItsOwnRules()
{
    const auto codeOf = [](const std::vector<StoredEntry> &entries) {
        return writtenContainer(entries).error().code;
    };
    QCOMPARE(codeOf({storedEntry("../a", {})}), ErrorCode::InvalidArgument);
    QCOMPARE(codeOf({storedEntry("a", {}), storedEntry("a", {})}), ErrorCode::InvalidArgument);
    QCOMPARE(codeOf({storedEntry("mimetype", {})}), ErrorCode::InvalidArgument);
    ContainerLimits limits;
    limits.maxTotalBytes = 10;
    const StoredEntry large = storedEntry("a", asBytes("eleven byte"));
    QCOMPARE(writtenContainer(std::span(&large, 1), limits).error().code, ErrorCode::TooLarge);
}

QTEST_APPLESS_MAIN(ContainerTest)
#include "container_test.moc"
