#include "doodling/cache/analysis_cache.h"

#include <QTemporaryDir>
#include <QtTest>

#include <fstream>

using namespace ductus;
namespace fs = std::filesystem;

class AnalysisCacheTest : public QObject
{
    Q_OBJECT
private slots:
    void whatWasUsedLongestAgoMakesRoom()
    {
        QTemporaryDir folder;
        const AnalysisCache cache{fs::path(folder.path().toStdString()) / "clips", 2500};
        const auto now = fs::file_time_type::clock::now();
        int age = 3;
        for (const char *key : {"old", "middle", "young"}) {
            const auto made = cache.folder(key);
            QVERIFY(made.ok());
            std::ofstream(*made / "data") << std::string(1000, 'x');
            fs::last_write_time(*made / "used", now - std::chrono::hours(age--));
        }
        cache.makeRoom("young");
        QVERIFY(!fs::exists(cache.root / "old"));
        QVERIFY(fs::exists(cache.root / "middle") && fs::exists(cache.root / "young"));
        // Looking at one again makes it the youngest.
        fs::last_write_time(cache.root / "middle/used", now - std::chrono::hours(9));
        QVERIFY(cache.folder("middle").ok());
        AnalysisCache tight = cache;
        tight.mostBytes = 1500;
        tight.makeRoom("other");
        QVERIFY(fs::exists(cache.root / "middle") && !fs::exists(cache.root / "young"));
        tight.mostBytes = 0;
        tight.makeRoom("middle"); // never the one that is in use
        QVERIFY(fs::exists(cache.root / "middle/data"));
    }
    void aRootThatCannotBeWrittenIsTold()
    {
        QTemporaryDir folder;
        const fs::path file = fs::path(folder.path().toStdString()) / "file";
        std::ofstream(file) << "in the way";
        const auto made = AnalysisCache{file}.folder("key");
        QVERIFY(!made.ok());
        QCOMPARE(made.error().code, ErrorCode::WriteFailed);
        QVERIFY(!made.error().remedy.empty());
    }
    void theUserSaysWhere()
    {
        qputenv("XDG_CACHE_HOME", "/somewhere/cache");
        qunsetenv("DUCTUS_CACHE_MEGABYTES");
        QCOMPARE(userAnalysisCache().root, fs::path("/somewhere/cache/ductus/clips"));
        qputenv("XDG_CACHE_HOME", "relative"); // to be ignored, says the standard
        qputenv("HOME", "/home/me");
        QCOMPARE(userAnalysisCache().root, fs::path("/home/me/.cache/ductus/clips"));
        qputenv("DUCTUS_CACHE_MEGABYTES", "100");
        QCOMPARE(userAnalysisCache().mostBytes, std::uint64_t(100) << 20);
        qputenv("DUCTUS_CACHE_MEGABYTES", "0");
        QVERIFY(!userAnalysisCache().isOn());
        qputenv("DUCTUS_CACHE_MEGABYTES", "many");
        QVERIFY(userAnalysisCache().isOn());
    }
};

QTEST_APPLESS_MAIN(AnalysisCacheTest)
#include "analysis_cache_test.moc"
