#include "widgets/language/language.h"

#include "document/words/engine_words.h"
#include "widgets/pages/sample_words.h"
#include "widgets/testing/widget_test_main.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLibraryInfo>
#include <QTemporaryDir>

using namespace ductus;

namespace {

// By variables, or lupdate would take the texts of tests for some of the program.
QString inLanguage(const char *context, const char *source, int number = -1)
{
    return QCoreApplication::translate(context, source, nullptr, number);
}

} // namespace

class LanguageTest : public QObject
{
    Q_OBJECT
private slots:
    void cleanup() { speak(*qApp, QStringLiteral("en"), {}); }
    void choosesOneOfOurs();
    void speaks();
    void countsInEnglish();
    void speaksTheEnginesWords();
    void knowsEverySample();
    void remembersTheChoice();
};

void LanguageTest::choosesOneOfOurs()
{
    QCOMPARE(languageToSpeak({}, {"de-AT", "de", "en"}), QString("de"));
    QCOMPARE(languageToSpeak({}, {"nl-NL", "fr_CA"}), QString("fr"));
    QCOMPARE(languageToSpeak({}, {"nl"}), QString("en"));
    QCOMPARE(languageToSpeak("ja", {"de"}), QString("ja"));
    QCOMPARE(languageToSpeak("xx", {"es-MX"}), QString("es"));
    QCOMPARE(languages().size(), 5);
}

void LanguageTest::speaks()
{
    const auto word = [] { return inLanguage("ductus::MainWindowShell", "File"); };
    QCOMPARE(word(), QString("File"));
    for (const Language &language : languages())
        QVERIFY2(speak(*qApp, language.code, "layerpainter"), qPrintable(language.code));
    QVERIFY(speak(*qApp, "de", "layerpainter"));
    QCOMPARE(word(), QString("Datei"));
    QCOMPARE(inLanguage("ductus::LayerPanel", "Opacity"), QString("Deckkraft"));
    QVERIFY(speak(*qApp, "ja", {}));
    QCOMPARE(word(), QString("ファイル"));
    QCOMPARE(inLanguage("ductus::LayerPanel", "Opacity"), QString("Opacity"));
    QVERIFY(!speak(*qApp, "ja", "no-such-program"));
}

void LanguageTest::countsInEnglish()
{
    QVERIFY(speak(*qApp, "en", "sketchsurfacer"));
    const auto strokes = [](int n) { return inLanguage("ductus::StrokePanel", "%n strokes chosen", n); };
    QCOMPARE(strokes(1), QString("1 stroke chosen"));
    QCOMPARE(strokes(2), QString("2 strokes chosen"));
    QVERIFY(speak(*qApp, "fr", "sketchsurfacer"));
    QCOMPARE(strokes(0), QString("0 trait choisi"));
    QCOMPARE(strokes(2), QString("2 traits choisis"));
}

void LanguageTest::speaksTheEnginesWords()
{
    QCOMPARE(engineWords("Reading the sketch"), QString("Reading the sketch"));
    QVERIFY(speak(*qApp, "es", {}));
    QCOMPARE(engineWords("Reading the sketch"), QString("Leer el boceto"));
    QCOMPARE(engineWords("line 7 has no number"), QString("line 7 has no number"));
    QCOMPARE(engineWords(""), QString());
}

void LanguageTest::knowsEverySample()
{
    QVERIFY(speak(*qApp, "ja", {}));
    int seen = 0;
    for (const char *list : {"samples", "paintings", "clips"}) {
        QFile file(QStringLiteral(DUCTUS_SOURCE_DIR "/resources/samples/%1.json").arg(list));
        QVERIFY(file.open(QIODevice::ReadOnly));
        for (const QJsonValue &sample : QJsonDocument::fromJson(file.readAll())["samples"].toArray())
            for (const char *key : {"title", "lesson"}) {
                const QString english = sample[QLatin1String(key)].toString();
                QVERIFY2(sampleWords(english) != english, qPrintable(english));
                ++seen;
            }
    }
    QVERIFY(seen > 20);
}

void LanguageTest::remembersTheChoice()
{
    QTemporaryDir dir;
    Settings settings(dir.filePath("settings.ini"));
    settings.set(chosenLanguage, QStringLiteral("fr"));
    const QLocale before;
    speakAsChosen(*qApp, settings, {});
    QCOMPARE(inLanguage("ductus::MainWindowShell", "File"), QString("Fichier"));
    QCOMPARE(QLocale().language(), QLocale::French);
    QLocale::setDefault(before);
}

DUCTUS_WIDGET_TEST_MAIN(LanguageTest)
#include "language_test.moc"
