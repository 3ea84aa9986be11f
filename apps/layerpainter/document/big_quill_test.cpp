// "My scene has 57,000 strokes": large Quill projects come in without being held twice. Large and slow, so
// only with DUCTUS_BIG=1.
#include "layerpainter/document/import_file.h"

#include "support/big_quill.h"

#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QtTest>
#include <sys/resource.h>

using namespace ductus;

namespace {

std::int64_t peakBytes()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return std::int64_t(usage.ru_maxrss) * 1024;
}

} // namespace

class BigQuillTest : public QObject
{
    Q_OBJECT
private slots:
    void aSmallOneIsWhole();
    void aGigabyteIsNeverHeldWhole();
};

void BigQuillTest::aSmallOneIsWhole()
{
    QTemporaryDir folder;
    const std::filesystem::path path(folder.filePath("small").toStdString());
    const BigQuill big = writeBigQuill(path, 1100, 12, 3 << 20);
    QVERIFY(big.qbinBytes >= (3u << 20));
    QCOMPARE(std::filesystem::file_size(path / "Quill.qbin"), std::uintmax_t(big.qbinBytes));
    const Result<ImportedFile> imported = importFile(path, {}, {});
    QVERIFY2(imported.ok(), imported.ok() ? "" : imported.error().message().c_str());
    QCOMPARE(int(imported->painting.stacks.size()), 3);
    QCOMPARE(imported->report.points, big.points);
    int strokes = 0;
    for (const Stack &stack : imported->painting.stacks)
        strokes += stack.substrate->elementCount();
    QCOMPARE(strokes, 1100);
}

void BigQuillTest::aGigabyteIsNeverHeldWhole()
{
    if (qEnvironmentVariable("DUCTUS_BIG") != "1")
        QSKIP("writes and reads more than a gigabyte; set DUCTUS_BIG=1 to run it");
    QTemporaryDir folder;
    const std::filesystem::path path(folder.filePath("big").toStdString());
    const BigQuill big = writeBigQuill(path, 57'000, 120, std::uint64_t(1100) << 20);
    const std::int64_t before = peakBytes();
    QElapsedTimer clock;
    clock.start();
    const Result<ImportedFile> imported = importFile(path, {}, {});
    const double seconds = 1e-3 * double(clock.elapsed());
    QVERIFY2(imported.ok(), imported.ok() ? "" : imported.error().message().c_str());
    const std::int64_t grown = peakBytes() - before;
    const std::int64_t held = big.points * std::int64_t(sizeof(PaintedPoint));
    qInfo("Quill.qbin %.2f GB, %lld points: %.1f s, peak memory %.0f MB more than before; the painting's "
          "points alone are %.0f MB",
          1e-9 * double(big.qbinBytes), static_cast<long long>(big.points), seconds, 1e-6 * double(grown),
          1e-6 * double(held));
    QCOMPARE(imported->report.points, big.points);
    QVERIFY2(grown < 3 * held, "more than the points as read and as painted, and some room");
    QVERIFY(grown < std::int64_t(big.qbinBytes));
}

QTEST_APPLESS_MAIN(BigQuillTest)
#include "big_quill_test.moc"
