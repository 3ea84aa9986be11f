// Every folder of common/ says in its README what it takes in, gives out and may include.
#include "architecture/source_rules.h"

#include <QtTest>
#include <fstream>
#include <sstream>

using namespace ductus;
namespace fs = std::filesystem;

namespace {

std::string textOf(const fs::path &path)
{
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

std::vector<std::string> foldersOf(const fs::path &path)
{
    std::vector<std::string> names;
    for (const fs::directory_entry &entry : fs::directory_iterator(path)) {
        // A folder without a source is one somebody is about to fill.
        const auto isCode = [](const fs::path &p) {
            return p.extension() == ".cpp" || p.extension() == ".h";
        };
        if (!entry.is_directory())
            continue;
        for (const fs::directory_entry &file : fs::recursive_directory_iterator(entry.path())) {
            if (isCode(file.path())) {
                names.push_back(entry.path().filename().string());
                break;
            }
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

const fs::path root = DUCTUS_SOURCE_DIR;

} // namespace

class FolderReadmesTest : public QObject
{
    Q_OBJECT
private slots:
    void everyFolderOfCommonHasOne_data();
    void everyFolderOfCommonHasOne();
    void architectureNamesEveryFolder();
};

void FolderReadmesTest::everyFolderOfCommonHasOne_data()
{
    QTest::addColumn<QString>("folder");
    const std::vector<std::string> folders = foldersOf(root / "common");
    QVERIFY(folders.size() >= 8);
    for (const std::string &folder : folders)
        QTest::newRow(folder.c_str()) << QString::fromStdString(folder);
}

void FolderReadmesTest::everyFolderOfCommonHasOne()
{
    QFETCH(QString, folder);
    const fs::path readme = root / "common" / folder.toStdString() / "README.md";
    QVERIFY2(fs::is_regular_file(readme), qPrintable("common/" + folder + " has no README.md"));
    const QString text = QString::fromStdString(textOf(readme));
    QVERIFY2(text.startsWith("# " + folder + "\n"), "it begins with the folder's name as its heading");
    QVERIFY2(text.contains("May include"), "it says what the folder may include");
}

void FolderReadmesTest::architectureNamesEveryFolder()
{
    const QString text = QString::fromStdString(textOf(root / "ARCHITECTURE.md"));
    QVERIFY(!text.isEmpty());
    for (const char *area : {"common", "apps"}) {
        for (const std::string &folder : foldersOf(root / area)) {
            const QString row = QString("| `%1/%2` |").arg(area, QString::fromStdString(folder));
            QVERIFY2(text.contains(row), qPrintable("ARCHITECTURE.md has no row that begins " + row));
        }
    }
}

QTEST_APPLESS_MAIN(FolderReadmesTest)
#include "folder_readmes_test.moc"
