// Qt 5 must never enter a Qt 6 process: OpenCV's highgui, VTK's Qt modules and others would bring it along.
// Every program of this build is asked which libraries it names itself and which the loader would map.
#include <QtTest>
#include <filesystem>
#include <fstream>

namespace fs = std::filesystem;

namespace {

bool isProgram(const fs::directory_entry &entry)
{
    using fs::perms;
    if (!entry.is_regular_file() || (entry.status().permissions() & perms::owner_exec) == perms::none)
        return false;
    char magic[4] = {};
    std::ifstream(entry.path(), std::ios::binary).read(magic, 4);
    return std::string_view(magic, 4) == "\177ELF";
}

// Programs and shared libraries of the build; what CMake compiles to try the compiler is none of ours.
QStringList builtPrograms(const fs::path &build)
{
    QStringList programs;
    for (auto it = fs::recursive_directory_iterator(build); it != fs::recursive_directory_iterator(); ++it) {
        if (it->is_directory() && it->path().filename() == "CMakeFiles")
            it.disable_recursion_pending();
        else if (isProgram(*it))
            programs << QString::fromStdString(it->path().string());
    }
    programs.sort();
    return programs;
}

QString outputOf(const QString &program, const QStringList &arguments)
{
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(program, arguments);
    if (!process.waitForFinished(60000))
        return {};
    return QString::fromLocal8Bit(process.readAll());
}

// The lines of \a output that name a Qt 5 library.
QStringList qt5Lines(const QString &output)
{
    return output.split(QLatin1Char('\n')).filter(QStringLiteral("libQt5"));
}

} // namespace

class NoQt5Test : public QObject
{
    Q_OBJECT
private slots:
    void theCheckSeesWhatIsThere();
    void noProgramLoadsQt5_data();
    void noProgramLoadsQt5();
    void thisProcessMapsNoQt5();
};

void NoQt5Test::theCheckSeesWhatIsThere()
{
    const QString self = QCoreApplication::applicationFilePath();
    QVERIFY(outputOf("ldd", {self}).contains("libQt6Test.so"));
    QVERIFY(outputOf("readelf", {"-d", self}).contains("libQt6Test.so"));
    const QString bad =
        "\tlibm.so.6 => /lib/libm.so.6 (0x1)\n\tlibQt5Core.so.5 => /usr/lib/libQt5Core.so.5 (0x2)\n";
    QCOMPARE(qt5Lines(bad).size(), 1);
}

void NoQt5Test::noProgramLoadsQt5_data()
{
    QTest::addColumn<QString>("program");
    const QStringList programs = builtPrograms(DUCTUS_BUILD_DIR);
    QVERIFY(programs.contains(QFileInfo(QCoreApplication::applicationFilePath()).canonicalFilePath()));
    for (const QString &program : programs)
        QTest::newRow(qPrintable(QDir(DUCTUS_BUILD_DIR).relativeFilePath(program))) << program;
}

void NoQt5Test::noProgramLoadsQt5()
{
    QFETCH(QString, program);
    const QString named = outputOf("readelf", {"-d", program});
    QVERIFY2(named.contains("Dynamic section") || named.contains("no dynamic section"), qPrintable(named));
    QCOMPARE(qt5Lines(named), QStringList());
    const QString mapped = outputOf("ldd", {program});
    QVERIFY2(mapped.contains("libc.so") || mapped.contains("statically linked"), qPrintable(mapped));
    QVERIFY2(!mapped.contains("not found"), qPrintable(mapped));
    QCOMPARE(qt5Lines(mapped), QStringList());
}

void NoQt5Test::thisProcessMapsNoQt5()
{
    QFile maps("/proc/self/maps");
    QVERIFY(maps.open(QIODevice::ReadOnly));
    const QString text = QString::fromLocal8Bit(maps.readAll());
    QVERIFY(text.contains("libQt6Core.so"));
    QCOMPARE(qt5Lines(text), QStringList());
}

QTEST_GUILESS_MAIN(NoQt5Test)
#include "no_qt5_test.moc"
