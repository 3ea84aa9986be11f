#include "doodling/reconstruction/knowledge_words.h"

#include <QtTest>
#include <set>

using namespace ductus;

class KnowledgeWordsTest : public QObject
{
    Q_OBJECT
private slots:
    void everyRungHasWordsOfItsOwn()
    {
        std::set<std::string> modes;
        for (CameraKnowledge knowledge :
             {CameraKnowledge::Tripod, CameraKnowledge::RotationOnly, CameraKnowledge::SolvedCameras}) {
            Shot shot;
            shot.knowledge = knowledge;
            const KnowledgeWords words = knowledgeWords(shot);
            QVERIFY(words.mode.size() > 10 && words.limit.size() > 20);
            modes.insert(words.mode);
        }
        QCOMPARE(modes.size(), std::size_t(3));
    }
};

QTEST_APPLESS_MAIN(KnowledgeWordsTest)
#include "knowledge_words_test.moc"
