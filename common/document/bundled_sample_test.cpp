#include "document/bundled_sample.h"

#include <QDir>
#include <QTemporaryDir>
#include <QtTest>

using namespace ductus;

class BundledSampleTest : public QObject
{
    Q_OBJECT
private slots:
    void theBundledOnesAreKnown();
    void othersAreNot();
};

void BundledSampleTest::theBundledOnesAreKnown()
{
    const QDir samples(QStringLiteral(DUCTUS_SOURCE_DIR "/resources/samples"));
    QCOMPARE(bundledSampleId(samples.filePath("forest-path.ductus"), "paintings.json"),
             QString("forest-path"));
    QCOMPARE(bundledSampleId(samples.filePath("passing-box.ductus"), "clips.json"), QString("passing-box"));
    QCOMPARE(bundledSampleId(samples.filePath("passing-box.ductus"), "paintings.json"), QString());
}

void BundledSampleTest::othersAreNot()
{
    QTemporaryDir folder;
    const QString copy = folder.filePath("forest-path.ductus");
    QVERIFY(QFile::copy(QStringLiteral(DUCTUS_SOURCE_DIR "/resources/samples/forest-path.ductus"), copy));
    QCOMPARE(bundledSampleId(copy, "paintings.json"), QString());
    QFile list(folder.filePath("paintings.json"));
    QVERIFY(list.open(QIODevice::WriteOnly));
    list.write("{\"samples\": 3}");
    list.close();
    QCOMPARE(bundledSampleId(copy, "paintings.json"), QString());
    QCOMPARE(bundledSampleId(folder.filePath("none.ductus"), "paintings.json"), QString());
}

QTEST_GUILESS_MAIN(BundledSampleTest)
#include "bundled_sample_test.moc"
