// Every text of the sources is in every language, and in each it keeps its places for numbers and names, its
// dots, its access key and its plural forms.
#include <QDir>
#include <QHash>
#include <QProcess>
#include <QRegularExpression>
#include <QSet>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <QtTest>

namespace {

struct Text
{
    QString key; // context and source
    QString source;
    QString state; // "unfinished", "vanished", "obsolete" or empty
    QStringList forms;
    bool isPlural = false;
};

const QString folder = QStringLiteral(DUCTUS_SOURCE_DIR "/translations/");

QList<Text> textsOf(const QString &path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    QList<Text> texts;
    QString context;
    QXmlStreamReader xml(&file);
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        const auto name = xml.name();
        if (name == u"name") {
            context = xml.readElementText();
        } else if (name == u"message") {
            texts.append(Text{});
            texts.last().isPlural = xml.attributes().value(QLatin1String("numerus")) == u"yes";
        } else if (name == u"source") {
            texts.last().source = xml.readElementText();
            texts.last().key = context + QLatin1Char('/') + texts.last().source;
        } else if (name == u"translation") {
            texts.last().state = xml.attributes().value(QLatin1String("type")).toString();
            if (!texts.last().isPlural)
                texts.last().forms << xml.readElementText();
        } else if (name == u"numerusform") {
            texts.last().forms << xml.readElementText();
        }
    }
    return xml.hasError() ? QList<Text>() : texts;
}

QStringList placesIn(const QString &text)
{
    static const QRegularExpression place(QStringLiteral("%L?\\d|%n"));
    QSet<QString> places;
    for (auto match = place.globalMatch(text); match.hasNext();)
        places << match.next().captured();
    QStringList sorted = places.values();
    sorted.sort();
    return sorted;
}

bool hasAccessKey(const QString &text)
{
    static const QRegularExpression key(QStringLiteral("&[^&\\s]"));
    return key.match(text).hasMatch() && !text.contains(QLatin1String("&nbsp;"));
}

// The words of what is wrong with one form of a text; empty if nothing is.
QString wrongForm(const Text &text, const QString &form)
{
    if (form.trimmed().isEmpty())
        return QStringLiteral("is empty");
    if (placesIn(form) != placesIn(text.source))
        return QStringLiteral("has other places for numbers and names");
    if (hasAccessKey(form) != hasAccessKey(text.source))
        return QStringLiteral("lost or gained its access key");
    if (text.source.endsWith(QLatin1Char(':')) && !form.endsWith(QLatin1Char(':')))
        return QStringLiteral("lost its colon");
    return {};
}

} // namespace

class CompleteTest : public QObject
{
    Q_OBJECT
private slots:
    void everyTextIsTranslated_data();
    void everyTextIsTranslated();
    void sourcesHaveNoOtherTexts_data();
    void sourcesHaveNoOtherTexts();
    void findsWhatIsWrong();
};

void CompleteTest::everyTextIsTranslated_data()
{
    QTest::addColumn<QString>("part");
    QTest::addColumn<QString>("language");
    for (const char *part : {"common", "sketchsurfacer", "layerpainter", "doodlestudio"})
        for (const char *language : {"fr", "de", "es", "ja"})
            QTest::addRow("%s_%s", part, language) << QString(part) << QString(language);
}

void CompleteTest::everyTextIsTranslated()
{
    QFETCH(QString, part);
    QFETCH(QString, language);
    const QList<Text> texts = textsOf(folder + part + '_' + language + ".ts");
    QVERIFY(texts.size() > 100);
    const int forms = language == QLatin1String("ja") ? 1 : 2;
    QStringList wrong;
    for (const Text &text : texts) {
        if (!text.state.isEmpty())
            wrong << text.key + QStringLiteral(" is ") + text.state;
        if (text.forms.size() != (text.isPlural ? forms : 1))
            wrong << text.key + QStringLiteral(" has %1 forms").arg(text.forms.size());
        for (const QString &form : text.forms)
            if (const QString problem = wrongForm(text, form); !problem.isEmpty())
                wrong << text.key + QStringLiteral(" -> ") + form + QLatin1Char(' ') + problem;
    }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
}

void CompleteTest::sourcesHaveNoOtherTexts_data()
{
    QTest::addColumn<QString>("part");
    for (const char *part : {"common", "sketchsurfacer", "layerpainter", "doodlestudio"})
        QTest::newRow(part) << QString(part);
}

void CompleteTest::sourcesHaveNoOtherTexts()
{
    QFETCH(QString, part);
    const QString root = QStringLiteral(DUCTUS_SOURCE_DIR);
    const QString sources = part == QLatin1String("common") ? root + "/common" : root + "/apps/" + part;
    QTemporaryDir dir;
    const QString made = dir.filePath("made.ts");
    QProcess lupdate;
    lupdate.start(QStringLiteral(DUCTUS_LUPDATE),
                  {"-silent", "-no-obsolete", "-locations", "none", "-I", root + "/common", "-I",
                   root + "/apps", sources, "-extensions", "cpp,h", "-source-language", "en",
                   "-target-language", "fr", "-ts", made});
    QVERIFY(lupdate.waitForFinished(120'000));
    QCOMPARE(lupdate.exitCode(), 0);
    QSet<QString> said;
    for (const Text &text : textsOf(made))
        said << text.key;
    QVERIFY(said.size() > 100);
    for (const char *language : {"fr", "de", "es", "ja"}) {
        QSet<QString> known;
        for (const Text &text : textsOf(folder + part + '_' + language + ".ts"))
            known << text.key;
        const QStringList fresh = (said - known).values(), gone = (known - said).values();
        QVERIFY2(fresh.isEmpty(), qPrintable(QStringLiteral("not in %1: ").arg(language) + fresh.join("\n")));
        QVERIFY2(gone.isEmpty(),
                 qPrintable(QStringLiteral("nobody says, but %1 has: ").arg(language) + gone.join("\n")));
    }
}

void CompleteTest::findsWhatIsWrong()
{
    const Text text{"c/&Open %1...", "&Open %1...", {}, {}, false};
    QCOMPARE(wrongForm(text, "Öff&nen %1..."), QString());
    QVERIFY(!wrongForm(text, "Öff&nen...").isEmpty());
    QVERIFY(!wrongForm(text, "Öffnen %1...").isEmpty());
    QVERIFY(!wrongForm(text, " ").isEmpty());
    QCOMPARE(placesIn("%n of %L1, %1, %1"), (QStringList{"%1", "%L1", "%n"}));
}

QTEST_GUILESS_MAIN(CompleteTest)
#include "complete_test.moc"
