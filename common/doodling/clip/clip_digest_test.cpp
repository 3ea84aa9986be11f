#include "doodling/clip/clip_digest.h"

#include <QTemporaryDir>
#include <QtTest>

#include <fstream>

using namespace ductus;
namespace fs = std::filesystem;

namespace {

void write(const fs::path &path, const std::string &text)
{
    std::ofstream(path, std::ios::binary) << text;
}

} // namespace

class ClipDigestTest : public QObject
{
    Q_OBJECT
private slots:
    void isTheHashOfTheBytes()
    {
        QTemporaryDir folder;
        const fs::path file = fs::path(folder.path().toStdString()) / "a.mp4";
        write(file, "abc");
        // FIPS 180-4, example of a one-block message
        QCOMPARE(*clipDigest(file, {}),
                 std::string("ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"));
    }
    void foldersAreTheirPictures()
    {
        QTemporaryDir folder;
        const fs::path root(folder.path().toStdString());
        write(root / "1.png", "one");
        write(root / "2.png", "two");
        const std::string before = *clipDigest(root, {});
        write(root / "notes.txt", "no picture");
        QCOMPARE(*clipDigest(root, {}), before);
        write(root / "2.png", "other");
        const std::string changed = *clipDigest(root, {});
        QVERIFY(changed != before);
        write(root / "2.png", "two");
        fs::rename(root / "2.png", root / "3.png");
        QVERIFY(*clipDigest(root, {}) != before);
    }
    void missingFilesAreTold()
    {
        const auto digest = clipDigest("/no/such/clip.mp4", {});
        QVERIFY(!digest.ok());
        QCOMPARE(digest.error().code, ErrorCode::FileNotFound);
    }
};

QTEST_APPLESS_MAIN(ClipDigestTest)
#include "clip_digest_test.moc"
