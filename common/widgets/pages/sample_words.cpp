#include "widgets/pages/sample_words.h"

#include <QCoreApplication>

namespace ductus {

namespace {

// For the translators; sample_words_test.cpp holds it against the files.
[[maybe_unused]] const char *const words[] = {
    QT_TRANSLATE_NOOP("ductus::SampleWords", "Saloon car"),
    QT_TRANSLATE_NOOP(
        "ductus::SampleWords",
        "Symmetric sketch with sharp shoulder, pillars and detail strokes: half is solved and mirrored."),
    QT_TRANSLATE_NOOP("ductus::SampleWords", "Bottle"),
    QT_TRANSLATE_NOOP("ductus::SampleWords",
                      "Round shapes with sharp rings: a crease at the shoulder, none along the meridians."),
    QT_TRANSLATE_NOOP("ductus::SampleWords", "Box with a bevel"),
    QT_TRANSLATE_NOOP("ductus::SampleWords",
                      "Flat faces meet in straight edges although every stroke is a little off."),
    QT_TRANSLATE_NOOP("ductus::SampleWords", "Folded leaf"),
    QT_TRANSLATE_NOOP("ductus::SampleWords",
                      "An open shell: boundary strokes say where the surface ends, the midrib is a fold."),
    QT_TRANSLATE_NOOP("ductus::SampleWords", "Computer mouse"),
    QT_TRANSLATE_NOOP("ductus::SampleWords",
                      "A smooth dome with a sharp belt: detail strokes lie on the surface and bend nothing."),
    QT_TRANSLATE_NOOP("ductus::SampleWords", "Table lamp"),
    QT_TRANSLATE_NOOP("ductus::SampleWords",
                      "Thick and thin parts in one sketch: the stem needs a tight proxy."),
    QT_TRANSLATE_NOOP("ductus::SampleWords", "Iron with a handle"),
    QT_TRANSLATE_NOOP("ductus::SampleWords",
                      "A closed surface with a hole: the proxy must find the way through the handle."),
    QT_TRANSLATE_NOOP("ductus::SampleWords", "Forest path"),
    QT_TRANSLATE_NOOP("ductus::SampleWords",
                      "Two looks, day and dawn: light is a layer of strokes, mist a gradient."),
    QT_TRANSLATE_NOOP("ductus::SampleWords", "Over the clouds"),
    QT_TRANSLATE_NOOP("ductus::SampleWords",
                      "Shadows are copies of strokes with tolerance; plane and shadow move as one."),
    QT_TRANSLATE_NOOP("ductus::SampleWords", "Desk by day and night"),
    QT_TRANSLATE_NOOP("ductus::SampleWords",
                      "A sunbeam through the window, a lamp for the night: one scene, two looks."),
    QT_TRANSLATE_NOOP("ductus::SampleWords", "Passing box"),
    QT_TRANSLATE_NOOP("ductus::SampleWords",
                      "A face follows the box behind the post; words and arrow stay in the room."),
    QT_TRANSLATE_NOOP("ductus::SampleWords", "Walk through the room"),
    QT_TRANSLATE_NOOP("ductus::SampleWords",
                      "Labels and stickers keep their place in the room while the camera walks in."),
    QT_TRANSLATE_NOOP("ductus::SampleWords", "One vase, three glazes"),
    QT_TRANSLATE_NOOP("ductus::SampleWords",
                      "Ornament is painted once; looks give every layer another colour."),
    QT_TRANSLATE_NOOP("ductus::SampleWords", "Campfire"),
    QT_TRANSLATE_NOOP("ductus::SampleWords",
                      "Flames are five drawings shown in turn; night and firelight are gradients."),
    QT_TRANSLATE_NOOP("ductus::SampleWords", "Lighthouse"),
    QT_TRANSLATE_NOOP("ductus::SampleWords",
                      "Noise makes foam and crests, the beam is clear paint that turns."),
    QT_TRANSLATE_NOOP("ductus::SampleWords", "Koi pond"),
    QT_TRANSLATE_NOOP("ductus::SampleWords",
                      "Spots reach no further than the fish they touch; shadows swim along."),
    QT_TRANSLATE_NOOP("ductus::SampleWords", "Pendulum"),
    QT_TRANSLATE_NOOP("ductus::SampleWords",
                      "A still camera; the arrow rides on the bob and is drawn anew twelve times a swing."),
    QT_TRANSLATE_NOOP("ductus::SampleWords", "Chalk in the yard"),
    QT_TRANSLATE_NOOP(
        "ductus::SampleWords",
        "Canvases lie on the ground and on the wall and keep their perspective as the camera goes by."),
    QT_TRANSLATE_NOOP("ductus::SampleWords", "A ghost in the store"),
    QT_TRANSLATE_NOOP("ductus::SampleWords",
                      "Six drawings in a loop; keyframes carry them around the post and behind the boxes."),
    QT_TRANSLATE_NOOP("ductus::SampleWords", "Over the hills"),
    QT_TRANSLATE_NOOP("ductus::SampleWords",
                      "The camera only turns: birds fly by keyframes, one of them behind the house."),
};

} // namespace

QString sampleWords(const QString &english)
{
    return QCoreApplication::translate("ductus::SampleWords", english.toUtf8().constData());
}

} // namespace ductus
