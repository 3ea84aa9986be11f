// The timeline read back as JSON: tracks, ranges and markers are where an editing program looks for them.
#include "doodling/export/timeline_text.h"

#include <QtTest>
#include <nlohmann/json.hpp>

using namespace ductus;
using nlohmann::json;

class TimelineTextTest : public QObject
{
    Q_OBJECT
private slots:
    void clipAndCanvasesAreTracks();
    void keyframesAreMarkers();
    void aClipOfOneFrame();
};

namespace {

Shot shotOf(int frames)
{
    Shot shot;
    shot.width = 80;
    shot.height = 45;
    shot.clipWidth = 160;
    shot.clipHeight = 90;
    shot.cameras.resize(std::size_t(frames));
    return shot;
}

ClipReference clipOfFrames(int frames)
{
    ClipReference clip;
    clip.path = "film.mp4";
    clip.frameCount = frames;
    clip.width = 160;
    clip.height = 90;
    clip.framesPerSecond = 24.0;
    return clip;
}

Canvas canvas()
{
    Canvas canvas;
    canvas.name = "Gesicht";
    canvas.motion = CanvasMotion::Dynamic;
    canvas.shownFrom = 4;
    canvas.shownUntil = 9;
    canvas.keyframes.positions = {{4, Vec2(10.0, 20.0), std::nullopt, true},
                                  {8, Vec2(30.0, 5.0), 2.5, false}};
    canvas.keyframes.turns = {{6, Eigen::Quaterniond(0.6, 0.8, 0.0, 0.0), false}};
    return canvas;
}

json timeline(int frames, const DoodleScene &scene)
{
    return json::parse(timelineText("lesson", "film.mp4", clipOfFrames(frames), shotOf(frames), scene));
}

} // namespace

void TimelineTextTest::clipAndCanvasesAreTracks()
{
    Canvas always;
    always.name = "words";
    const json made = timeline(12, {{always, canvas()}});
    QCOMPARE(made["OTIO_SCHEMA"], json("Timeline.1"));
    const json &tracks = made["tracks"]["children"];
    QCOMPARE(int(tracks.size()), 3);
    const json &clip = tracks[0]["children"][0];
    QCOMPARE(clip["media_reference"]["target_url"], json("film.mp4"));
    QCOMPARE(clip["source_range"]["duration"]["value"], json(12.0));
    QCOMPARE(clip["source_range"]["duration"]["rate"], json(24.0));
    QCOMPARE(int(tracks[1]["children"].size()), 1); // no gap before what is there from the begin
    const json &face = tracks[2]["children"];
    QCOMPARE(face[0]["OTIO_SCHEMA"], json("Gap.1"));
    QCOMPARE(face[0]["source_range"]["duration"]["value"], json(4.0));
    QCOMPARE(face[1]["name"], json("Gesicht"));
    QCOMPARE(face[1]["source_range"]["duration"]["value"], json(6.0));
}

void TimelineTextTest::keyframesAreMarkers()
{
    const json made = timeline(12, {{canvas()}});
    const json &markers = made["tracks"]["children"][1]["children"][1]["markers"];
    QCOMPARE(int(markers.size()), 3);
    QCOMPARE(markers[0]["name"], json("pin"));
    QCOMPARE(markers[0]["marked_range"]["start_time"]["value"], json(0.0)); // of the canvas' own time
    QCOMPARE(markers[0]["metadata"]["ductus"]["frame"], json(4));
    QCOMPARE(markers[0]["metadata"]["ductus"]["pixel"],
             json({20.0, 40.0})); // of the clip, not the working copy
    QCOMPARE(markers[0]["metadata"]["ductus"]["straight"], json(true));
    QCOMPARE(markers[1]["metadata"]["ductus"]["depth"], json(2.5));
    QCOMPARE(markers[2]["name"], json("turn"));
    QCOMPARE(markers[2]["metadata"]["ductus"]["rotation"], json({0.8, 0.0, 0.0, 0.6}));
}

void TimelineTextTest::aClipOfOneFrame()
{
    const json made = timeline(1, {{canvas()}}); // its frames are all beyond the clip
    const json &children = made["tracks"]["children"][1]["children"];
    QCOMPARE(int(children.size()), 1);
    QCOMPARE(children[0]["source_range"]["duration"]["value"], json(1.0));
}

QTEST_APPLESS_MAIN(TimelineTextTest)
#include "timeline_text_test.moc"
