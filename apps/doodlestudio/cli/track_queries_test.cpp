#include "doodlestudio/cli/track_queries.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>

using namespace ductus;

namespace {

Shot halfSizedShot(int frames)
{
    Shot shot;
    shot.width = 427;
    shot.clipWidth = 854;
    shot.cameras.resize(std::size_t(frames));
    return shot;
}

} // namespace

class TrackQueriesTest : public QObject
{
    Q_OBJECT
private slots:
    void readsTheDocumentedForm()
    {
        const auto queries = parseQueries(
            R"({"tracks":[{"id":"a","keyframes":[{"frame":9,"x":20,"y":4.5,"depth":3,"rotation":[0,0,0,2]},
                                                 {"frame":0,"x":100.5,"y":80.0,"depth":null,"rotation":null}]}]})",
            "q.json", halfSizedShot(10));
        QVERIFY2(queries.ok(), queries.ok() ? "" : queries.error().message().c_str());
        QCOMPARE(queries->size(), std::size_t(1));
        const TrackQuery &query = queries->front();
        QCOMPARE(query.id, std::string("a"));
        QCOMPARE(query.keyframes.size(), std::size_t(2));
        QCOMPARE(query.keyframes[0].frame, 0);                 // sorted
        QCOMPARE(query.keyframes[0].pixel, Vec2(50.25, 40.0)); // the working copy is half the size
        QVERIFY(!query.keyframes[0].depth);
        QCOMPARE(*query.keyframes[1].depth, 3.0);
        QCOMPARE(query.orientations.size(), std::size_t(1));
        QCOMPARE(query.orientations[0].frame, 9);
        QVERIFY(query.orientations[0].worldFromCanvas.isApprox(Eigen::Quaterniond::Identity()));
    }
    void saysWhereItIsWrong_data()
    {
        QTest::addColumn<QString>("json");
        QTest::addColumn<QString>("place");
        const auto row = [](const char *name, const char *json, const char *place) {
            QTest::newRow(name) << QString(json) << QString(place);
        };
        row("no json", "{", "q.json");
        row("no tracks", "{}", "tracks");
        row("no id", R"({"tracks":[{"keyframes":[]}]})", "tracks/0/id");
        row("no keyframes", R"({"tracks":[{"id":"a","keyframes":[]}]})", "tracks/0/keyframes");
        row("no x", R"({"tracks":[{"id":"a","keyframes":[{"frame":1,"y":2}]}]})", "tracks/0/keyframes/0/x");
        row("text for y", R"({"tracks":[{"id":"a","keyframes":[{"frame":1,"x":2,"y":"3"}]}]})",
            "tracks/0/keyframes/0/y");
        row("beyond", R"({"tracks":[{"id":"a","keyframes":[{"frame":10,"x":2,"y":3}]}]})",
            "tracks/0/keyframes/0/frame");
        row("fraction", R"({"tracks":[{"id":"a","keyframes":[{"frame":1.5,"x":2,"y":3}]}]})",
            "tracks/0/keyframes/0/frame");
        row("depth 0", R"({"tracks":[{"id":"a","keyframes":[{"frame":1,"x":2,"y":3,"depth":0}]}]})",
            "tracks/0/keyframes/0/depth");
        row("no rotation",
            R"({"tracks":[{"id":"a","keyframes":[{"frame":1,"x":2,"y":3,"rotation":[0,0,0,0]}]}]})",
            "tracks/0/keyframes/0/rotation");
    }
    void saysWhereItIsWrong()
    {
        QFETCH(QString, json);
        QFETCH(QString, place);
        const auto queries = parseQueries(json.toStdString(), "q.json", halfSizedShot(10));
        QVERIFY(!queries.ok());
        QCOMPARE(queries.error().code, ErrorCode::Malformed);
        QVERIFY2(queries.error().place.ends_with(place.toStdString()), queries.error().place.c_str());
        QVERIFY(!queries.error().remedy.empty());
    }
    void answersAreInPixelsOfTheClip()
    {
        QueryAnswer answer{"b",
                           {TrackedPoint{Vec3(1, 2, 3), Vec2(50.25, 40.0), 3.0, false}},
                           {Eigen::Quaterniond(1, 0, 0, 0)}};
        const QByteArray text = QByteArray::fromStdString(answersText({answer}, halfSizedShot(1)));
        const QJsonObject frame = QJsonDocument::fromJson(text)["tracks"][0]["frames"][0].toObject();
        QCOMPARE(frame["x"].toDouble(), 100.5);
        QCOMPARE(frame["y"].toDouble(), 80.0);
        QCOMPARE(frame["visible"].toBool(true), false);
        QCOMPARE(frame["position"].toArray()[2].toDouble(), 3.0);
        QCOMPARE(frame["rotation"].toArray()[3].toDouble(), 1.0);
    }
};

QTEST_APPLESS_MAIN(TrackQueriesTest)
#include "track_queries_test.moc"
