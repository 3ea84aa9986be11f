#include "formats/atomic_file.h"

#include <QtTest>
#include <csignal>
#include <fstream>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace ductus;
namespace fs = std::filesystem;

namespace {

constexpr const char *saving = "Saving";

Result<void> write(const fs::path &path, const std::string &text)
{
    return writeFileAtomically(path, std::as_bytes(std::span(text)), saving);
}

std::string read(const fs::path &path)
{
    const auto text = readWholeFile(path, 1 << 20, "Reading");
    return text ? *text : "<" + text.error().message() + ">";
}

std::size_t filesIn(const fs::path &folder)
{
    return std::size_t(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

/// Gives up root's right to pass by permissions while it lives.
class AsNobody
{
public:
    AsNobody() { mDropped = ::geteuid() != 0 || ::seteuid(65534) == 0; }
    ~AsNobody()
    {
        if (::getuid() == 0 && ::seteuid(0) != 0)
            std::abort();
    }
    bool ok() const { return mDropped; }

private:
    bool mDropped = false;
};

} // namespace

class AtomicFileTest : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void writesAndReplaces();
    void readsWhatWasWritten();
    void keepsPermissionsAndLinks();
    void longNamesFit();
    void saysWhyItCannotWrite();
    void saysWhyItCannotRead();
    void noPermissionIsSaid();
    void aFullDiskLeavesTheOldFileAndNothingElse();

private:
    std::unique_ptr<QTemporaryDir> mDir;
    fs::path mFolder;
};

void AtomicFileTest::init()
{
    mDir = std::make_unique<QTemporaryDir>();
    QVERIFY(mDir->isValid());
    mFolder = mDir->path().toStdString();
}

void AtomicFileTest::writesAndReplaces()
{
    QVERIFY(write(mFolder / "a.obj", "first"));
    QCOMPARE(read(mFolder / "a.obj"), std::string("first"));
    QVERIFY(write(mFolder / "a.obj", "2"));
    QCOMPARE(read(mFolder / "a.obj"), std::string("2"));
    QVERIFY(write(mFolder / "a.obj", ""));
    QCOMPARE(read(mFolder / "a.obj"), std::string());
    QCOMPARE(filesIn(mFolder), std::size_t(1));
}

void AtomicFileTest::readsWhatWasWritten()
{
    std::string all;
    for (int i = 0; i < 300000; ++i)
        all += char(i * 7);
    QVERIFY(write(mFolder / "bytes", all));
    QVERIFY(read(mFolder / "bytes") == all);
    QCOMPARE(readWholeFile(mFolder / "bytes", all.size() - 1, "Reading").error().code, ErrorCode::TooLarge);
    QVERIFY(readWholeFile(mFolder / "bytes", all.size(), "Reading").ok());
    // Files of the system say size 0 and have content all the same.
    QVERIFY(read("/proc/self/status").find("VmRSS") != std::string::npos);
}

void AtomicFileTest::keepsPermissionsAndLinks()
{
    QVERIFY(write(mFolder / "real", "a"));
    fs::permissions(mFolder / "real", fs::perms(0640));
    fs::create_symlink("real", mFolder / "link");
    fs::create_symlink("not yet", mFolder / "dangling");
    QVERIFY(write(mFolder / "link", "b"));
    QVERIFY(fs::is_symlink(mFolder / "link"));
    QCOMPARE(read(mFolder / "real"), std::string("b"));
    QCOMPARE(fs::status(mFolder / "real").permissions(), fs::perms(0640));
    QVERIFY(write(mFolder / "dangling", "c"));
    QCOMPARE(read(mFolder / "not yet"), std::string("c"));
}

void AtomicFileTest::longNamesFit()
{
    QVERIFY(write(mFolder / std::string(255, 'n'), "x"));
    QCOMPARE(write(mFolder / std::string(256, 'n'), "x").error().code, ErrorCode::WriteFailed);
    QCOMPARE(filesIn(mFolder), std::size_t(1));
}

void AtomicFileTest::saysWhyItCannotWrite()
{
    QCOMPARE(write(mFolder / "none" / "a", "x").error().code, ErrorCode::FileNotFound);
    QCOMPARE(write(mFolder, "x").error().code, ErrorCode::NotAFile);
    QCOMPARE(write(mFolder / "", "x").error().code, ErrorCode::NotAFile);
    QCOMPARE(write("/dev/null", "x").error().code, ErrorCode::NotAFile);
    QVERIFY(fs::is_character_file("/dev/null"));
    const Error error = write(mFolder / "none" / "a", "x").error();
    QCOMPARE(error.place, (mFolder / "none" / "a").string());
    QVERIFY(!error.remedy.empty());
    QCOMPARE(error.attempted, std::string(saving));
    fs::create_symlink("loop", mFolder / "loop");
    QVERIFY(!write(mFolder / "loop", "x").ok() || read(mFolder / "loop") == "x");
}

void AtomicFileTest::saysWhyItCannotRead()
{
    QCOMPARE(readWholeFile(mFolder / "none", 100, "Reading").error().code, ErrorCode::FileNotFound);
    QCOMPARE(readWholeFile(mFolder, 100, "Reading").error().code, ErrorCode::NotAFile);
    QCOMPARE(::mkfifo((mFolder / "pipe").c_str(), 0600), 0);
    QCOMPARE(readWholeFile(mFolder / "pipe", 100, "Reading").error().code, ErrorCode::NotAFile);
}

void AtomicFileTest::noPermissionIsSaid()
{
    QVERIFY(write(mFolder / "secret", "x"));
    fs::permissions(mFolder / "secret", fs::perms(0));
    fs::permissions(mFolder, fs::perms(0555));
    {
        const AsNobody nobody;
        if (!nobody.ok())
            QSKIP("running as root without the right to become somebody else");
        QCOMPARE(readWholeFile(mFolder / "secret", 100, "Reading").error().code, ErrorCode::PermissionDenied);
        QCOMPARE(write(mFolder / "new", "x").error().code, ErrorCode::PermissionDenied);
    }
    fs::permissions(mFolder, fs::perms(0755));
    QCOMPARE(filesIn(mFolder), std::size_t(1));
}

void AtomicFileTest::aFullDiskLeavesTheOldFileAndNothingElse()
{
    QVERIFY(write(mFolder / "a", "old"));
    // A limit on the size of files stops the write half-way, as a full disk does.
    rlimit before = {};
    QCOMPARE(::getrlimit(RLIMIT_FSIZE, &before), 0);
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small = {4096, before.rlim_max};
    QCOMPARE(::setrlimit(RLIMIT_FSIZE, &small), 0);
    const auto result = write(mFolder / "a", std::string(100000, 'x'));
    QCOMPARE(::setrlimit(RLIMIT_FSIZE, &before), 0);
    QVERIFY(!result.ok());
    QCOMPARE(result.error().code, ErrorCode::WriteFailed);
    QCOMPARE(read(mFolder / "a"), std::string("old"));
    QCOMPARE(filesIn(mFolder), std::size_t(1));
}

QTEST_APPLESS_MAIN(AtomicFileTest)
#include "atomic_file_test.moc"
