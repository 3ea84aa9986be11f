// "I installed it": what the install rules bring is complete, and the tools of desktops take it as sound.
#include <QDir>
#include <QDirIterator>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMimeDatabase>
#include <QProcess>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>

namespace {

struct Told
{
    int code = -1;
    QString words;
};

Told run(const QString &program, const QStringList &arguments)
{
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(program, arguments);
    if (!process.waitForFinished(120000))
        return {-1, process.errorString()};
    return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
            QString::fromUtf8(process.readAll())};
}

const QStringList apps{QStringLiteral("SketchSurfacer"), QStringLiteral("LayerPainter"),
                       QStringLiteral("DoodleStudio")};
const QStringList programs{QStringLiteral("sketchsurfacer"), QStringLiteral("layerpainter"),
                           QStringLiteral("doodlestudio"), QStringLiteral("ductus")};
const QString projectType = QStringLiteral("application/vnd.ductus.project+zip");

} // namespace

#define NEEDS(program)                                                                                       \
    if (QStandardPaths::findExecutable(program).isEmpty())                                                   \
    QSKIP(program " is not installed")

class DesktopFilesTest : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void everythingThatIsPromisedIsInstalled();
    void samplesAreCompleteAndNothingElseIs();
    void menuEntriesAreSound();
    void menuEntriesStartWhatIsInstalled();
    void metainfoIsSound();
    void theFileTypeIsSound();
    void projectsAreKnownByNameAndByContent();
    void thumbnailerStartsAProgramOfOurs();
    void iconsAreDrawnInEverySize();
    void manPagesAreCleanAndNameEveryCommand();
    void nothingNamesTheMachineItWasMadeOn();

private:
    QString file(const QString &name) const { return mRoot.filePath(name); }
    QByteArray textOf(const QString &name) const
    {
        QFile opened(file(name));
        return opened.open(QIODevice::ReadOnly) ? opened.readAll() : QByteArray();
    }
    QTemporaryDir mRoot;
};

void DesktopFilesTest::initTestCase()
{
    QVERIFY(mRoot.isValid());
    const Told told = run(QStringLiteral(DUCTUS_CMAKE),
                          {"--install", DUCTUS_BUILD_DIR, "--component", "data", "--prefix", mRoot.path()});
    QVERIFY2(told.code == 0, qPrintable(told.words));
    // Read once, before anything asks for a type. All types of the system in one folder with ours, as when
    // installed: Qt takes the first match of the last folder, whatever the priorities.
    const QString types = QStringLiteral("/usr/share/mime/packages/freedesktop.org.xml");
    if (QFileInfo::exists(types))
        QVERIFY(QFile::copy(types, file("share/mime/packages/freedesktop.org.xml")));
    QVERIFY(QDir().mkpath(file("home")));
    qputenv("XDG_DATA_HOME", QFile::encodeName(file("home")));
    qputenv("XDG_DATA_DIRS", QFile::encodeName(file("share")));
}

void DesktopFilesTest::everythingThatIsPromisedIsInstalled()
{
    QStringList wanted{"share/mime/packages/org.ductus.Project.xml",
                       "share/thumbnailers/ductus.thumbnailer",
                       "share/doc/ductus/copyright",
                       "share/doc/ductus/changelog.gz",
                       "share/applications/org.ductus.AnyProject.desktop",
                       "share/icons/hicolor/scalable/mimetypes/application-vnd.ductus.project+zip.svg",
                       "share/ductus/schemas/project.schema.json"};
    for (const QString &app : apps)
        wanted << "share/applications/org.ductus." + app + ".desktop"
               << "share/metainfo/org.ductus." + app + ".metainfo.xml"
               << "share/icons/hicolor/scalable/apps/org.ductus." + app + ".svg"
               << "share/ductus/manual/" + app.toLower() + ".md";
    for (const QString &program : programs)
        wanted << "share/man/man1/" + program + ".1.gz";
    for (const QString &name : wanted)
        QVERIFY2(QFileInfo(file(name)).size() > 0, qPrintable(name + " is missing or empty"));
}

void DesktopFilesTest::samplesAreCompleteAndNothingElseIs()
{
    QStringList named;
    for (const QString &list :
         {QStringLiteral("samples.json"), QStringLiteral("paintings.json"), QStringLiteral("clips.json")}) {
        const QJsonObject content = QJsonDocument::fromJson(textOf("share/ductus/samples/" + list)).object();
        const QJsonArray samples = content["samples"].toArray();
        QVERIFY2(samples.size() >= 2, qPrintable(list));
        named << list;
        for (const QJsonValue &sample : samples) {
            named << sample["file"].toString();
            if (list != "samples.json") // the gallery's pictures; sketches are drawn when shown
                named << sample["id"].toString() + ".png";
            if (!sample["clip"].isUndefined())
                named << sample["clip"].toString();
        }
    }
    QStringList there = QDir(file("share/ductus/samples")).entryList(QDir::Files | QDir::Hidden);
    named.sort();
    there.sort();
    QCOMPARE(there, named);
}

void DesktopFilesTest::menuEntriesAreSound()
{
    NEEDS("desktop-file-validate");
    for (const QString &entry : QDir(file("share/applications")).entryList({"*.desktop"})) {
        const Told told = run("desktop-file-validate", {file("share/applications/" + entry)});
        QVERIFY2(told.code == 0 && told.words.isEmpty(), qPrintable(entry + "\n" + told.words));
    }
}

void DesktopFilesTest::menuEntriesStartWhatIsInstalled()
{
    const QStringList entries = QDir(file("share/applications")).entryList({"*.desktop"});
    QCOMPARE(entries.size(), 4);
    for (const QString &name : entries) {
        QSettings entry(file("share/applications/" + name), QSettings::IniFormat);
        entry.beginGroup("Desktop Entry");
        const QStringList words = entry.value("Exec").toString().split(' ');
        QVERIFY2(programs.contains(words[0]), qPrintable(name));
        QCOMPARE(words.value(1), "%F");
        QCOMPARE(entry.value("TryExec").toString(), words[0]);
        const QString icon = entry.value("Icon").toString();
        QVERIFY2(QFileInfo::exists(file("share/icons/hicolor/scalable/apps/" + icon + ".svg")) ||
                     QFileInfo::exists(file("share/icons/hicolor/scalable/mimetypes/" + icon + ".svg")),
                 qPrintable(name + ": " + icon));
        QVERIFY2(textOf("share/applications/" + name).contains("\nMimeType=" + projectType.toUtf8() + ";"),
                 qPrintable(name));
        // The first in order is what a click starts (update-desktop-database sorts them).
        QVERIFY(name >= QStringLiteral("org.ductus.AnyProject.desktop"));
        for (const char *language : {"de", "fr", "es", "ja"})
            QVERIFY2(
                textOf("share/applications/" + name).contains(QByteArray("\nComment[") + language + "]="),
                qPrintable(name + ": " + language));
    }
}

void DesktopFilesTest::metainfoIsSound()
{
    NEEDS("appstreamcli");
    const Told told = run("appstreamcli", {"validate-tree", "--no-net", mRoot.path()});
    QVERIFY2(told.code == 0, qPrintable(told.words));
    QVERIFY2(!told.words.contains(QRegularExpression("^[EW]:", QRegularExpression::MultilineOption)),
             qPrintable(told.words));
}

void DesktopFilesTest::theFileTypeIsSound()
{
    NEEDS("xmllint");
    const Told told = run("xmllint", {"--noout", file("share/mime/packages/org.ductus.Project.xml")});
    QVERIFY2(told.code == 0 && told.words.isEmpty(), qPrintable(told.words));
}

void DesktopFilesTest::projectsAreKnownByNameAndByContent()
{
    NEEDS("update-mime-database");
    if (!QFileInfo::exists(file("share/mime/packages/freedesktop.org.xml")))
        QSKIP("shared-mime-info is not installed");
    const Told told = run("update-mime-database", {file("share/mime")});
    QVERIFY2(told.code == 0, qPrintable(told.words));
    const QMimeDatabase types;
    QVERIFY(types.mimeTypeForName(projectType).isValid());
    QVERIFY(types.mimeTypeForName(projectType).inherits("application/zip"));
    QCOMPARE(types.mimeTypeForFile("x.ductus", QMimeDatabase::MatchExtension).name(), projectType);
    for (const QString &sample : QDir(file("share/ductus/samples")).entryList({"*.ductus"})) {
        const QString path = file("share/ductus/samples/" + sample);
        QCOMPARE(types.mimeTypeForFile(path).name(), projectType);
        QCOMPARE(types.mimeTypeForFile(path, QMimeDatabase::MatchContent).name(), projectType);
    }
    // Another zip stays one.
    const QByteArray other(
        "PK\003\004\024\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\010\0\0\0mimetypeapplication/epub", 60);
    QVERIFY(types.mimeTypeForData(other).name() != projectType);
}

void DesktopFilesTest::thumbnailerStartsAProgramOfOurs()
{
    const QByteArray text = textOf("share/thumbnailers/ductus.thumbnailer");
    QVERIFY(text.startsWith("[Thumbnailer Entry]\n"));
    QVERIFY(text.contains("\nTryExec=ductus\n"));
    QVERIFY(text.contains("\nExec=ductus thumbnail "));
    for (const char *code : {"%s", "%o", "%i"})
        QVERIFY2(text.contains(code), code);
    QVERIFY(text.contains("\nMimeType=" + projectType.toUtf8() + ";\n"));
}

void DesktopFilesTest::iconsAreDrawnInEverySize()
{
    QStringList names{"mimetypes/application-vnd.ductus.project+zip"};
    for (const QString &app : apps)
        names << "apps/org.ductus." + app;
    for (const QString &name : names)
        for (const int size : {16, 22, 24, 32, 48, 64, 128, 256}) {
            const QImage icon(file(QString("share/icons/hicolor/%1x%1/%2.png").arg(size).arg(name)));
            QCOMPARE(icon.size(), QSize(size, size));
            QCOMPARE(qAlpha(icon.pixel(0, 0)), 0); // round corners
            QCOMPARE(qAlpha(icon.pixel(size / 2, size / 2)), 255);
        }
}

void DesktopFilesTest::manPagesAreCleanAndNameEveryCommand()
{
    NEEDS("groff");
    for (const QString &program : programs) {
        const QString page = QStringLiteral(DUCTUS_SOURCE_DIR "/packaging/man/") + program + ".1";
        const Told told = run("groff", {"-man", "-Tutf8", "-ww", "-z", "-rCHECKSTYLE=1", page});
        QVERIFY2(told.code == 0 && told.words.isEmpty(), qPrintable(page + "\n" + told.words));
        QFile opened(page);
        QVERIFY(opened.open(QIODevice::ReadOnly));
        const QByteArray text = opened.readAll();
        QVERIFY2(text.startsWith(".TH " + program.toUpper().toUtf8() + " 1"), qPrintable(page));
        // The commands are those main.cpp's usage lists, two spaces in.
        QFile main(QStringLiteral(DUCTUS_SOURCE_DIR "/apps/") + program + "/main.cpp");
        QVERIFY(main.open(QIODevice::ReadOnly));
        auto found = QRegularExpression("\"  ([a-z]+) [A-Z]").globalMatch(QString::fromUtf8(main.readAll()));
        int commands = 0;
        for (; found.hasNext(); ++commands) {
            const QString command = found.next().captured(1);
            QVERIFY2(text.contains("\n.B " + command.toUtf8() + "\n") ||
                         text.contains(program.toUtf8() + " " + command.toUtf8()),
                     qPrintable(page + " does not tell of " + command));
        }
        QVERIFY(commands >= 1);
    }
}

void DesktopFilesTest::nothingNamesTheMachineItWasMadeOn()
{
    QDirIterator files(mRoot.path(), QDir::Files, QDirIterator::Subdirectories);
    int seen = 0;
    for (; files.hasNext(); ++seen) {
        QFile opened(files.next());
        QVERIFY(opened.open(QIODevice::ReadOnly));
        const QByteArray bytes = opened.readAll();
        QVERIFY2(!bytes.contains(DUCTUS_SOURCE_DIR) && !bytes.contains(DUCTUS_BUILD_DIR),
                 qPrintable(opened.fileName()));
    }
    QVERIFY(seen > 40);
}

QTEST_GUILESS_MAIN(DesktopFilesTest)
#include "desktop_files_test.moc"
