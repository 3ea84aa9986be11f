// import, info and validate as a script uses them: files, exit codes, reports.
#include "layerpainter/cli/import_command.h"
#include "layerpainter/cli/inspect_commands.h"

#include "document/document_files.h"
#include "layerpainter/document/painting_project.h"
#include "project/project_reader.h"
#include "support/quill_sample.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QtTest>

using namespace ductus;

namespace {

void write(const QString &path, const QByteArray &bytes)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        qFatal("cannot write %s", qPrintable(path));
}

QByteArray read(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QJsonObject json(const QString &path)
{
    return QJsonDocument::fromJson(read(path)).object();
}

} // namespace

class ImportCommandTest : public QObject
{
    Q_OBJECT
private slots:
    void init() { QVERIFY(mFolder.isValid()); }
    void importsAQuillFolder();
    void importsAMesh();
    void theSameFileGivesTheSameBytes();
    void refusesInWords_data();
    void refusesInWords();
    void validateFindsDamage();

private:
    QString file(const QString &name) const { return mFolder.filePath(name); }
    int run(const QStringList &arguments) const { return int(runImportCommand(arguments)); }
    // A Quill folder with a name of many alphabets.
    QString quill() const
    {
        const QString folder = file(QStringLiteral("été 木"));
        QDir().mkpath(folder);
        const QuillSample sample = quillSample();
        write(folder + "/Quill.json", QByteArray::fromStdString(sample.json));
        write(folder + "/Quill.qbin", QByteArray::fromStdString(sample.qbin));
        return folder;
    }

    QTemporaryDir mFolder;
};

void ImportCommandTest::importsAQuillFolder()
{
    QCOMPARE(run({quill(), "-q", "-o", file("q.ductus"), "--report", file("q.json")}), 0);
    const QJsonObject report = json(file("q.json"));
    QCOMPARE(report["schema"].toString(), "import-report");
    QCOMPARE(report["kind"].toString(), "quill");
    QCOMPARE(report["painting"]["stacks"].toInt(), 2);
    QVERIFY(report["skipped"].toVariant().toStringList().join('|').contains("Music"));
    const Result<Project> project = openProject(enginePath(file("q.ductus")), knownDocuments());
    QVERIFY(project.ok());
    const Result<StoredPainting> stored = paintingFromProject(*project);
    QVERIFY(stored.ok());
    QCOMPARE(stored->name, std::string("été 木"));
    const Painting &painting = stored->content->painting();
    QCOMPARE(painting.stacks[0].substrate->drawings[0].elements.size(), std::size_t(2));
    QCOMPARE(painting.stacks[1].substrate->frames.drawingOfFrame.size(), std::size_t(4));
    QCOMPARE(painting.pictures.size(), std::size_t(1));
    QCOMPARE(int(runValidateCommand({file("q.ductus")})), 0);
    QCOMPARE(int(runInfoCommand({file("q.ductus"), "--json"})), 0);
}

void ImportCommandTest::importsAMesh()
{
    write(file("corner.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 3 4\n");
    QCOMPARE(run({file("corner.obj"), "-q", "-o", file("m.ductus")}), 0);
    const Result<Project> project = openProject(enginePath(file("m.ductus")), knownDocuments());
    const Painting &painting = paintingFromProject(*project)->content->painting();
    const auto &mesh = std::get<MeshShape>(*painting.stacks[0].substrate->drawings[0].elements[0].shape);
    QCOMPARE(mesh.mesh.triangleCount(), 2);
    QCOMPARE(painting.stacks[0].name, std::string("corner"));
}

void ImportCommandTest::theSameFileGivesTheSameBytes()
{
    const QString folder = quill();
    QCOMPARE(run({folder, "-q", "-o", file("a.ductus")}), 0);
    QCOMPARE(run({folder, "-q", "-o", file("b.ductus")}), 0);
    QVERIFY(!read(file("a.ductus")).isEmpty());
    QCOMPARE(read(file("a.ductus")), read(file("b.ductus")));
}

void ImportCommandTest::refusesInWords_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("code");
    QTest::newRow("nothing") << QStringList{} << 2;
    QTest::newRow("no output") << QStringList{"x.obj"} << 2;
    QTest::newRow("two inputs") << QStringList{"x.obj", "y.obj", "-o", "p.ductus"} << 2;
    QTest::newRow("not a project") << QStringList{"x.obj", "-o", "p.zip"} << 2;
    QTest::newRow("unknown option") << QStringList{"x.obj", "-o", "p.ductus", "--odd"} << 2;
    QTest::newRow("no such file") << QStringList{"none.obj", "-o", "p.ductus"} << 1;
    QTest::newRow("no such folder") << QStringList{"bad.obj", "-o", "none/p.ductus"} << 1;
    QTest::newRow("not a mesh") << QStringList{"bad.obj", "-o", "p.ductus"} << 1;
    QTest::newRow("half a Quill folder") << QStringList{"half", "-o", "p.ductus"} << 1;
    QTest::newRow("itself") << QStringList{"self.ductus", "-o", "self.ductus"} << 1;
}

void ImportCommandTest::refusesInWords()
{
    QFETCH(QStringList, arguments);
    QFETCH(int, code);
    write(file("bad.obj"), "v 0 0 nan\nf 1 1 1\n");
    write(file("self.ductus"), "PK");
    QDir().mkpath(file("half"));
    write(file("half/Quill.json"), QByteArray::fromStdString(quillSample().json));
    const QString before = QDir::currentPath();
    QDir::setCurrent(mFolder.path());
    const int found = run(arguments);
    QDir::setCurrent(before);
    QCOMPARE(found, code);
    QVERIFY(!QFile::exists(file("p.ductus")));
    QCOMPARE(read(file("self.ductus")), QByteArray("PK"));
}

void ImportCommandTest::validateFindsDamage()
{
    QCOMPARE(run({quill(), "-q", "-o", file("v.ductus")}), 0);
    QByteArray bytes = read(file("v.ductus"));
    bytes[bytes.size() / 2] = char(bytes[bytes.size() / 2] ^ 0x55);
    write(file("damaged.ductus"), bytes);
    QCOMPARE(int(runValidateCommand({file("damaged.ductus")})), 1);
    QCOMPARE(int(runValidateCommand({file("none.ductus")})), 1);
    QCOMPARE(int(runValidateCommand({})), 2);
}

QTEST_GUILESS_MAIN(ImportCommandTest)
#include "import_command_test.moc"
