#include "support/box_sketch.h"
#include "surfacing/pipeline/surface_pipeline.h"

#include <QFile>
#include <QtTest>
#include <mutex>
#include <set>

using namespace ductus;

// What surfacing says of how far it is must be words for designers that translators have.
class ProgressWordsTest : public QObject
{
    Q_OBJECT

private slots:
    void stagesAreTranslatable()
    {
        QFile list(QStringLiteral(DUCTUS_SOURCE_DIR "/common/document/words/engine_words.cpp"));
        QVERIFY(list.open(QIODevice::ReadOnly));
        const QByteArray known = list.readAll();
        std::mutex mutex;
        std::set<std::string> told;
        const JobControl control(nullptr, [&](double, std::string_view text) {
            const std::lock_guard lock(mutex);
            told.insert(std::string(text));
        });
        SurfaceOptions options;
        options.segmentation.runs = 2;
        options.proxy.targetVertices = 2000;
        const Result<SurfaceResult> surface = surfaceSketch(boxSketch(), std::nullopt, options, control);
        QVERIFY2(surface, surface ? "" : surface.error().message().c_str());
        QVERIFY(told.size() > 4);
        for (const std::string &text : told)
            QVERIFY2(known.contains('"' + QByteArray::fromStdString(text) + '"'), text.c_str());
    }
};

QTEST_GUILESS_MAIN(ProgressWordsTest)
#include "progress_words_test.moc"
