// "I gave it the wrong file": one clear message with the file, the line where there is one, and nothing
// written.
#include "journeys/sketch_journey.h"

#include <QDir>
#include <QFile>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>

using namespace ductus;

class BadInputTest : public QObject
{
    Q_OBJECT
private slots:
    void saysWhereAndWhat_data();
    void saysWhereAndWhat();
    void tenMillionPoints_data();
    void tenMillionPoints();
    void folderInsteadOfAFile();
    void fileThatIsNotThere();
    void fileIMayNotRead();
    void strokesThatAreNotThere();
    void outputOverTheSketch();
    void outOfMemory();
    void messagesAreAlsoThereInAPlainLocale();
};

namespace {

QByteArray sampleBytes()
{
    return bytesOf(samplePath(QStringLiteral("bent-leaf")));
}

// The sample with line \a number (from 1) replaced.
QByteArray sampleWithLine(int number, const QByteArray &line)
{
    QList<QByteArray> lines = sampleBytes().split('\n');
    lines[number - 1] = line;
    return lines.join('\n');
}

QByteArray pointCloud()
{
    QByteArray text;
    quint32 state = 1;
    const auto number = [&state] {
        state = state * 1664525u + 1013904223u;
        return QByteArray::number(double(state >> 8) / (1 << 24), 'f', 6);
    };
    for (int i = 0; i < 500; ++i)
        text += number() + " " + number() + " " + number() + "\n";
    return text;
}

QByteArray noise()
{
    QByteArray bytes;
    quint32 state = 7;
    for (int i = 0; i < 20000; ++i) {
        state = state * 1664525u + 1013904223u;
        bytes.append(char(state >> 24));
    }
    return bytes;
}

} // namespace

void BadInputTest::saysWhereAndWhat_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QStringList>("says"); // beside the name
    QTest::newRow("empty") << "empty.curves" << QByteArray() << QStringList{"empty"};
    QTest::newRow("blank lines") << "blank.xyz" << QByteArray("\n\n  \n") << QStringList{};
    QTest::newRow("not a number") << "nan.curves" << sampleWithLine(5, "0.1 nan 0.3") << QStringList{":5"};
    QTest::newRow("infinite") << "inf.curves" << sampleWithLine(5, "0.1 0.2 inf") << QStringList{":5"};
    QTest::newRow("overflow") << "big.curves" << sampleWithLine(5, "0.1 1e999 0") << QStringList{":5"};
    QTest::newRow("word") << "word.curves" << sampleWithLine(5, "0.1 zwei 0") << QStringList{":5"};
    QTest::newRow("decimal commas") << "comma.curves" << sampleWithLine(5, "0,1 0,2 0,3")
                                    << QStringList{":5"};
    QTest::newRow("two coordinates") << "two.curves" << sampleWithLine(5, "0.1 0.2") << QStringList{":5"};
    QTest::newRow("one-point strokes")
        << "points.curves" << QByteArray("v 1\n0 0 0\nv 1\n1 0 0\nv 1\n0 1 0\n") << QStringList{};
    QTest::newRow("cut off") << "cut.curves" << sampleBytes().left(sampleBytes().size() / 2 + 3)
                             << QStringList{":"};
    QTest::newRow("too many points announced")
        << "more.curves" << QByteArray("v 5\n0 0 0\n1 0 0\n") << QStringList{":"};
    QTest::newRow("too few points announced")
        << "fewer.curves" << QByteArray("v 1\n0 0 0\n1 0 0\n2 0 0\n") << QStringList{":"};
    QTest::newRow("negative count") << "negative.curves" << QByteArray("v -3\n0 0 0\n") << QStringList{":1"};
    QTest::newRow("absurd count") << "absurd.curves" << QByteArray("v 999999999999\n0 0 0\n")
                                  << QStringList{":1"};
    QTest::newRow("index out of range")
        << "index.obj" << QByteArray("v 0 0 0\nv 1 0 0\nl 1 3\n") << QStringList{":3"};
    QTest::newRow("mesh without strokes")
        << "mesh.obj" << QByteArray("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n") << QStringList{};
    QTest::newRow("binary") << "noise.curves" << noise() << QStringList{};
    QTest::newRow("binary obj") << "noise.obj" << noise() << QStringList{};
    QTest::newRow("binary xyz") << "noise.xyz" << noise() << QStringList{};
    QTest::newRow("zeros") << "zeros.xyz" << QByteArray(5000, '\0') << QStringList{};
    QTest::newRow("picture") << "sketch.png" << QByteArray("\x89PNG\r\n\x1a\n and so on")
                             << QStringList{"PNG"};
    QTest::newRow("zip") << "sketch.ductus" << QByteArray("PK\x03\x04 and so on") << QStringList{"zip"};
    QTest::newRow("cloud") << "cloud.xyz" << pointCloud() << QStringList{"cloud of points", "stroke"};
}

void BadInputTest::saysWhereAndWhat()
{
    QFETCH(QString, name);
    QFETCH(QByteArray, content);
    QFETCH(QStringList, says);
    QTemporaryDir folder;
    QVERIFY(writeBytes(folder.filePath(name), content));
    const QStringList before = namesBelow(folder.path());
    const ProgramRun run = runSketchSurfacer(
        surfaceArguments(folder.filePath(name), folder.filePath("out.obj"),
                         {"--report", folder.filePath("r.json"), "--picture", folder.filePath("p.png")}));
    if (!says.isEmpty() && says.first().startsWith(':'))
        says.first().prepend(name); // file:line
    says.append(name);
    QVERIFY2(faultOfRefusal(run, says, folder.path(), before).isEmpty(),
             qPrintable(faultOfRefusal(run, says, folder.path(), before) + '\n' + run.told()));
    QVERIFY2(run.messages().first().startsWith("sketchsurfacer: "), run.told().constData());
    QCOMPARE(bytesOf(folder.filePath(name)), content);
}

void BadInputTest::tenMillionPoints_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("header");
    QTest::newRow("announced") << "huge.curves" << QByteArray("v 10000000\n");
    QTest::newRow("unannounced") << "huge.xyz" << QByteArray();
}

void BadInputTest::tenMillionPoints()
{
    QFETCH(QString, name);
    QFETCH(QByteArray, header);
    QTemporaryDir folder;
    {
        QFile file(folder.filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QByteArray text = header;
        for (int i = 0; i < 10'000'000; ++i) {
            text += QByteArray::number(i % 1000) + ' ' + QByteArray::number(i / 1000) + " 1\n";
            if (text.size() > 1 << 20) {
                if (file.write(text) != text.size())
                    QSKIP("there is not enough space for a file of ten million points");
                text.clear();
            }
        }
        QCOMPARE(file.write(text), text.size());
    }
    const QStringList before = namesBelow(folder.path());
    RunOptions options;
    options.largestMemory = quint64(1) << 30; // refused without filling the memory
    const ProgramRun run =
        runSketchSurfacer(surfaceArguments(folder.filePath(name), folder.filePath("out.obj")), options);
    const QString fault = faultOfRefusal(run, {name + ':', "points"}, folder.path(), before);
    QVERIFY2(fault.isEmpty(), qPrintable(fault + '\n' + run.told()));
    QVERIFY2(run.seconds < 30.0, qPrintable(QString::number(run.seconds)));
}

void BadInputTest::folderInsteadOfAFile()
{
    QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkdir("sketch.curves"));
    const QStringList before = namesBelow(folder.path());
    const ProgramRun run =
        runSketchSurfacer(surfaceArguments(folder.filePath("sketch.curves"), folder.filePath("out.obj")));
    const QString fault = faultOfRefusal(run, {"sketch.curves", "folder"}, folder.path(), before);
    QVERIFY2(fault.isEmpty(), qPrintable(fault + '\n' + run.told()));
}

void BadInputTest::fileThatIsNotThere()
{
    QTemporaryDir folder;
    const ProgramRun run =
        runSketchSurfacer(surfaceArguments(folder.filePath("nowhere.curves"), folder.filePath("out.obj")));
    const QString fault = faultOfRefusal(run, {"nowhere.curves", "no such file"}, folder.path(), {});
    QVERIFY2(fault.isEmpty(), qPrintable(fault + '\n' + run.told()));
}

void BadInputTest::fileIMayNotRead()
{
    if (!canRunWithoutRights())
        QSKIP("as root, with the program out of reach of the unprivileged user");
    QTemporaryDir folder;
    const auto everybody = QFile::Permissions(0x7777);
    QVERIFY(QFile::setPermissions(folder.path(), everybody));
    const QString in = folder.filePath("secret.curves");
    QVERIFY(writeBytes(in, sampleBytes()));
    QVERIFY(QFile::setPermissions(in, QFile::Permissions()));
    const QStringList before = namesBelow(folder.path());
    RunOptions options;
    options.withoutRights = true;
    options.folder = folder.path();
    const ProgramRun run = runSketchSurfacer(surfaceArguments(in, folder.filePath("out.obj")), options);
    const QString fault = faultOfRefusal(run, {"secret.curves", "allow"}, folder.path(), before);
    QVERIFY2(fault.isEmpty(), qPrintable(fault + '\n' + run.told()));
}

void BadInputTest::strokesThatAreNotThere()
{
    QTemporaryDir folder;
    for (const char *option : {"--boundary", "--ignore"}) {
        const ProgramRun run = runSketchSurfacer(
            surfaceArguments(samplePath("bent-leaf"), folder.filePath("out.obj"), {option, "2,19"}));
        const QString fault = faultOfRefusal(run, {"no stroke 19", "0 to 18", option}, folder.path(), {});
        QVERIFY2(fault.isEmpty(), qPrintable(fault + '\n' + run.told()));
    }
    const ProgramRun run = runSketchSurfacer(
        surfaceArguments(samplePath("bent-leaf"), folder.filePath("out.obj"), {"--ignore", "0-18"}));
    const QString fault = faultOfRefusal(run, {"few strokes"}, folder.path(), {});
    QVERIFY2(fault.isEmpty(), qPrintable(fault + '\n' + run.told()));
}

void BadInputTest::outputOverTheSketch()
{
    QTemporaryDir folder;
    const QByteArray sketch = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nl 1 2 3 4\nl 1 3 2 4\n";
    QVERIFY(writeBytes(folder.filePath("sketch.obj"), sketch));
    QVERIFY(QDir(folder.path()).mkdir("sub"));
    QVERIFY(QFile::link(folder.filePath("sketch.obj"), folder.filePath("link.obj")));
    const QStringList before = namesBelow(folder.path());
    for (const char *out : {"sketch.obj", "sub/../sketch.obj", "link.obj"}) {
        const ProgramRun run =
            runSketchSurfacer(surfaceArguments(folder.filePath("sketch.obj"), folder.filePath(out)));
        const QString fault = faultOfRefusal(run, {"overwritten", out}, folder.path(), before);
        QVERIFY2(fault.isEmpty(), qPrintable(fault + '\n' + run.told()));
        QCOMPARE(bytesOf(folder.filePath("sketch.obj")), sketch);
    }
}

void BadInputTest::outOfMemory()
{
    QTemporaryDir folder;
    if (QStandardPaths::findExecutable("taskset").isEmpty())
        QSKIP("taskset is not installed: each core would take memory for a thread of its own");
    RunOptions options;
    options.largestMemory = quint64(120) << 20; // enough to start, not for the fit
    options.environment = QStringList{"MALLOC_ARENA_MAX=1"};
    options.prefix = QStringList{"taskset", "-c", "0"};
    const ProgramRun run = runSketchSurfacer(
        surfaceArguments(samplePath("car"), folder.filePath("out.obj"), {"--proxy-vertices", "60000"}),
        options);
    if (run.exitCode == 127 || run.exitCode == 0)
        QSKIP("the limit is not between starting and surfacing on this machine");
    const QString fault = faultOfRefusal(run, {"memory"}, folder.path(), {});
    QVERIFY2(fault.isEmpty(), qPrintable(fault + '\n' + run.told()));
}

void BadInputTest::messagesAreAlsoThereInAPlainLocale()
{
    QTemporaryDir folder;
    const QString in = folder.filePath(QString::fromUtf8("Skizze – 草图.curves"));
    QVERIFY(writeBytes(in, sampleWithLine(5, "x")));
    const QStringList before = namesBelow(folder.path());
    for (const char *locale : {"C", "POSIX", "C.UTF-8", "de_DE@nowhere"}) {
        RunOptions options;
        options.environment = QStringList{QString("LC_ALL=") + locale, QString("LANG=") + locale};
        const ProgramRun run = runSketchSurfacer(surfaceArguments(in, folder.filePath("out.obj")), options);
        const QString fault =
            faultOfRefusal(run, {QString::fromUtf8("草图.curves:5")}, folder.path(), before);
        QVERIFY2(fault.isEmpty(), qPrintable(QString(locale) + ": " + fault + '\n' + run.told()));
    }
}

QTEST_GUILESS_MAIN(BadInputTest)
#include "bad_input_test.moc"
