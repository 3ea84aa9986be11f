#include "architecture/source_rules.h"

#include <QTemporaryDir>
#include <QtTest>
#include <fstream>

using namespace ductus;
namespace fs = std::filesystem;

namespace {

// A tree made for the occasion.
class Tree
{
public:
    void add(const std::string &path, const std::string &text)
    {
        const fs::path file = root() / path;
        fs::create_directories(file.parent_path());
        std::ofstream(file) << text;
    }
    fs::path root() const { return fs::path(mDir.path().toStdString()); }

private:
    QTemporaryDir mDir;
};

QString joined(const std::vector<std::string> &lines)
{
    QString text;
    for (const std::string &line : lines)
        text += QString::fromStdString(line) + QLatin1Char('\n');
    return text;
}

} // namespace

class IncludeDirectionTest : public QObject
{
    Q_OBJECT
private slots:
    void theTreeKeepsItsRules();
    void aCleanTreePasses();
    void aBadTreeIsCaughtLineByLine();
};

void IncludeDirectionTest::theTreeKeepsItsRules()
{
    const SourceReport report = checkSources(DUCTUS_SOURCE_DIR);
    // An empty walk would find nothing wrong, either.
    QVERIFY(report.files > 50);
    QVERIFY(report.includes > 200);
    QVERIFY2(report.violations.empty(), qPrintable("\n" + joined(report.violations)));
}

void IncludeDirectionTest::aCleanTreePasses()
{
    Tree tree;
    tree.add("common/base/error.h", "#include <string>\n#include \"base/result.h\"\n");
    tree.add("common/base/error_test.cpp",
             "#include <QtTest>\n#include \"support/zoo.h\"\n#include \"error_test.moc\"\n");
    tree.add("common/geometry/nearest.cpp", "#include \"base/error.h\"\n#include <CGAL/AABB_tree.h>\n");
    tree.add("common/widgets/shell.cpp", "#include <QWidget>\n#include \"document/document.h\"\n");
    tree.add("apps/alpha/main.cpp", "#include \"alpha/ui/window.h\"\n#include \"widgets/shell.h\"\n");
    // Not includes, not sources.
    tree.add("common/base/text.cpp",
             "// #include \"widgets/shell.h\"\nconst char *s = \"#include <QWidget>\";\n");
    tree.add("common/base/notes.txt", "#include \"widgets/shell.h\"\n");
    tree.add("common/base/long.cpp", std::string(longestFile, '\n'));
    const SourceReport report = checkSources(tree.root());
    QVERIFY2(report.violations.empty(), qPrintable(joined(report.violations)));
    QCOMPARE(report.files, 7);
    QCOMPARE(report.includes, 11);
}

void IncludeDirectionTest::aBadTreeIsCaughtLineByLine()
{
    Tree tree;
    fs::create_directories(tree.root() / "apps/beta");
    tree.add("common/base/up.h", "#pragma once\n\n  #  include   \"geometry/nearest.h\"\r\n");
    tree.add("common/base/angle.h", "#include <widgets/shell.h>\n");
    tree.add("common/geometry/up_test.cpp", "#include \"surfacing/pipeline.h\"\n");
    tree.add("common/surfacing/qt.cpp",
             "#include <QString>\n#include <QtCore/QFile>\n#include <qglobal.h>\n");
    tree.add("common/surfacing/cgal.cpp", "#include <CGAL/Surface_mesh.h>\n");
    tree.add("common/imaging/dots.cpp", "#include \"../base/error.h\"\n#include \"image.h\"\n");
    tree.add("common/cli/app.cpp", "#include \"beta/main.h\"\n");
    tree.add("common/strange/x.cpp", "\n");
    tree.add("common/base/long.cpp", std::string(longestFile + 1, '\n'));
    tree.add("apps/alpha/main.cpp", "#include \"beta/ui/window.h\"\n#include \"support/zoo.h\"\n");
    const std::vector<std::string> expected{
        "apps/alpha/main.cpp:1: alpha may not include the app beta: \"beta/ui/window.h\"",
        "apps/alpha/main.cpp:2: begins with no known folder: \"support/zoo.h\"",
        "common/base/angle.h:1: base may not include widgets, which stands above it: \"widgets/shell.h\"",
        "common/base/long.cpp:801: longer than 800 lines",
        "common/base/up.h:3: base may not include geometry, which stands above it: \"geometry/nearest.h\"",
        "common/cli/app.cpp:1: cli may not include the app beta: \"beta/main.h\"",
        "common/geometry/up_test.cpp:1: geometry may not include surfacing, which stands above it: "
        "\"surfacing/pipeline.h\"",
        "common/imaging/dots.cpp:1: includes are written from the root, without ../: \"../base/error.h\"",
        "common/imaging/dots.cpp:2: begins with no known folder: \"image.h\"",
        "common/strange/x.cpp:1: common/strange is no known layer",
        "common/surfacing/cgal.cpp:1: CGAL is kept inside common/geometry: <CGAL/Surface_mesh.h>",
        "common/surfacing/qt.cpp:1: an engine folder includes Qt: <QString>",
        "common/surfacing/qt.cpp:2: an engine folder includes Qt: <QtCore/QFile>",
        "common/surfacing/qt.cpp:3: an engine folder includes Qt: <qglobal.h>",
    };
    QCOMPARE(joined(checkSources(tree.root()).violations), joined(expected));
}

QTEST_APPLESS_MAIN(IncludeDirectionTest)
#include "include_direction_test.moc"
