#include "doodling/cache/record.h"

#include <QTemporaryDir>
#include <QtTest>

#include <fstream>

using namespace ductus;
namespace fs = std::filesystem;

namespace {

const std::vector<std::uint8_t> odd{1, 2, 3, 4, 5};
const std::vector<std::int16_t> steps{-7, 300, 32767};

RecordWriter sample()
{
    RecordWriter writer;
    writer.addNumbers({1.5, -2.0});
    writer.add<std::uint8_t>(odd);
    writer.add<std::int16_t>(steps);
    writer.add<std::uint8_t>({});
    return writer;
}

std::shared_ptr<const MappedFile> mapped(const fs::path &path)
{
    const auto file = MappedFile::open(path);
    return file ? *file : nullptr;
}

bool isSample(RecordReader &reader)
{
    const auto numbers = reader.array<double>(2);
    const auto bytes = reader.array<std::uint8_t>(odd.size());
    const auto shorts = reader.array<std::int16_t>(steps.size());
    const auto none = reader.array<std::uint8_t>(0);
    return !reader.failed() && reader.isAtEnd() && numbers[0] == 1.5 && numbers[1] == -2.0 &&
           bytes == SharedArray<std::uint8_t>(odd) && shorts == SharedArray<std::int16_t>(steps) &&
           none.empty();
}

} // namespace

class RecordTest : public QObject
{
    Q_OBJECT
private slots:
    void init() { mFolder = std::make_unique<QTemporaryDir>(); }

    void comesBackAsItWas()
    {
        QVERIFY(sample().write(path()).ok());
        RecordReader reader(mapped(path()));
        QVERIFY(reader.isSound());
        QVERIFY(isSample(reader));
        QCOMPARE(std::distance(fs::directory_iterator(path().parent_path()), fs::directory_iterator()),
                 1); // nothing is left beside
    }
    void arraysOutliveTheReaderAndTheFile()
    {
        QVERIFY(sample().write(path()).ok());
        SharedArray<std::uint8_t> bytes;
        {
            RecordReader reader(mapped(path()));
            (void)reader.numbers();
            bytes = reader.array<std::uint8_t>(odd.size());
            reader.file()->forgetPages();
        }
        fs::remove(path());
        QVERIFY(bytes == SharedArray<std::uint8_t>(odd));
    }
    void everyDamagedByteIsNoticed()
    {
        QVERIFY(sample().write(path()).ok());
        std::ifstream in(path(), std::ios::binary);
        const std::string good((std::istreambuf_iterator<char>(in)), {});
        for (std::size_t i = 0; i < good.size(); ++i)
            for (char change : {char(1), char(128)}) {
                std::string bad = good;
                bad[i] = char(bad[i] ^ change);
                put(bad);
                QVERIFY2(!RecordReader(mapped(path())).isSound(), qPrintable(QString::number(i)));
            }
        for (std::size_t length = 0; length < good.size(); ++length) {
            put(good.substr(0, length));
            QVERIFY(!RecordReader(mapped(path())).isSound());
        }
        QVERIFY(!RecordReader(nullptr).isSound());
    }
    void whatIsNotThereIsNotRead()
    {
        QVERIFY(sample().write(path()).ok());
        RecordReader wrong(mapped(path()));
        QVERIFY(wrong.array<double>(3).empty() && wrong.failed());
        RecordReader beyond(mapped(path()));
        QVERIFY(isSample(beyond));
        QVERIFY(beyond.array<std::uint8_t>(0).empty() && beyond.failed());
    }
    void aFolderThatIsGoneIsAnError()
    {
        const Result<void> written = sample().write(path() / "none" / "a.rec");
        QVERIFY(!written.ok());
        QCOMPARE(written.error().code, ErrorCode::WriteFailed);
    }

private:
    fs::path path() const { return fs::path(mFolder->path().toStdString()) / "a.rec"; }
    void put(const std::string &bytes)
    {
        fs::remove(path()); // never written into while it is mapped
        std::ofstream(path(), std::ios::binary) << bytes;
    }

    std::unique_ptr<QTemporaryDir> mFolder;
};

QTEST_APPLESS_MAIN(RecordTest)
#include "record_test.moc"
