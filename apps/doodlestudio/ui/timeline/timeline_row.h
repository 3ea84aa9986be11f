// What the timeline shows: a row a canvas, in words the timeline needs and no more.
#pragma once

#include <QColor>
#include <QList>
#include <QString>
#include <vector>

namespace ductus {

enum class TimelineMarkKind { Position, Depth, Turn, Size };

/// A keyframe.
struct TimelineMark
{
    TimelineMarkKind kind = TimelineMarkKind::Position;
    int frame = 0;
    bool interpolatesNext = false;

    bool operator==(const TimelineMark &other) const = default;
};

/// A drawing shown for some frames.
struct TimelineDrawing
{
    int index = 0; // of the canvas' drawings
    int first = 0, last = 0;
    bool isEmpty = false;
    bool isRepeat = false; // of a loop
};

struct TimelineRow
{
    int id = 0;
    QString name;
    QColor colour;
    bool follows = false;
    bool isVisible = true;
    bool isChosen = false;
    QList<TimelineMark> marks;
    QList<TimelineDrawing> drawings;
    /// How squarely the canvas faces the camera, 0 from the side .. 1; one a frame, or empty.
    std::vector<float> facing;
    /// Whether its middle is outside the picture or hidden; one a frame, or empty.
    std::vector<bool> hidden;
};

} // namespace ductus
