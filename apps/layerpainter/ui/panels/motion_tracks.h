// MotionTracks: below the timeline a row for each layer and group that moves, and for the layer in work: its
// name, its keys in time, keys set and taken away at the playhead. An armed row takes what the transform tool
// drags as keys of the whole layer or group.
#pragma once

#include "layerpainter/document/motion_keys.h"
#include "layerpainter/document/painting_document.h"

#include <QWidget>

class QGridLayout;
class QToolButton;

namespace ductus {

class KeyTrack;
class PaintingView;

class MotionTracks : public QWidget
{
    Q_OBJECT
public:
    MotionTracks(PaintingDocument &document, PaintingView &view, QWidget *parent = nullptr);

    /// The layer in work has a row even where it has no keys yet; invalid: none.
    void setCurrentLayer(LayerId layer);
    void setTime(double seconds, double length);
    /// Keeps where \a thing is now as its key at the playhead, or takes that key away.
    void setKey(const MovedThing &thing);
    void removeKey(const MovedThing &thing);
    int rowCount() const { return int(mRows.size()); }

signals:
    void scrubbed(double seconds);

private:
    struct Row
    {
        MovedThing thing;
        KeyTrack *track = nullptr;
        QToolButton *arm = nullptr, *set = nullptr, *remove = nullptr;
    };

    void refresh();
    void build(const std::vector<MovedThing> &things);
    void arm(const MovedThing &thing, bool armed);
    void showKeys();

    PaintingDocument &mDocument;
    PaintingView &mView;
    QWidget *mInside;
    QGridLayout *mLayout;
    std::vector<Row> mRows;
    LayerId mCurrent;
    double mSeconds = 0, mLength = 4;
};

} // namespace ductus
