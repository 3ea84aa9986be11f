#include "layerpainter/ui/panels/motion_tracks.h"

#include "layerpainter/ui/panels/key_track.h"
#include "layerpainter/ui/view/painting_view.h"
#include "widgets/theme/icons.h"

#include <QGridLayout>
#include <QLabel>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

namespace ductus {

namespace {

constexpr int rowHeight = 30;
constexpr int mostRowsSeen = 3; // more scroll: the canvas is what matters
constexpr int nameWidth = 132;

QToolButton *button(const QString &iconName, const QString &name, const QString &teaches)
{
    auto *made = new QToolButton;
    made->setIcon(icon(iconName));
    made->setIconSize({18, 18});
    made->setAutoRaise(true);
    made->setAccessibleName(name);
    made->setToolTip(QStringLiteral("<b>%1</b><br>%2").arg(name.toHtmlEscaped(), teaches));
    return made;
}

} // namespace

MotionTracks::MotionTracks(PaintingDocument &document, PaintingView &view, QWidget *parent)
    : QWidget(parent), mDocument(document), mView(view), mInside(new QWidget),
      mLayout(new QGridLayout(mInside))
{
    mLayout->setContentsMargins(12, 0, 12, 4);
    mLayout->setHorizontalSpacing(8);
    mLayout->setVerticalSpacing(0);
    mLayout->setColumnStretch(2, 1);
    auto *area = new QScrollArea;
    area->setWidget(mInside);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->viewport()->setAutoFillBackground(false); // the strip's shows
    mInside->setAutoFillBackground(false);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setAccessibleName(tr("What moves"));
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(area);
    connect(&mDocument, &Document::changed, this, [this](const ChangeEvent &event) {
        const auto *change = event.as<PaintingChanged>();
        if (!change) { // another painting
            mCurrent = {};
            mView.setKeyedThing(std::nullopt);
        }
        if (!change || change->scene || change->layers)
            refresh();
    });
    refresh();
}

void MotionTracks::setCurrentLayer(LayerId layer)
{
    if (layer == mCurrent)
        return;
    mCurrent = layer;
    refresh();
}

void MotionTracks::setTime(double seconds, double length)
{
    mSeconds = seconds;
    mLength = length;
    showKeys();
}

void MotionTracks::refresh()
{
    const Painting &painting = mDocument.painting();
    std::vector<MovedThing> things;
    for (const Layer *layer : painting.layers())
        if (!layer->motion.empty() || layer->id == mCurrent)
            things.emplace_back(layer->id);
    for (const MotionGroup &group : painting.motionGroups)
        things.emplace_back(group.id);
    const bool same = std::ranges::equal(things, mRows, {}, {}, &Row::thing);
    if (!same)
        build(things);
    if (const auto &keyed = mView.keyedThing(); keyed && std::ranges::find(things, *keyed) == things.end())
        mView.setKeyedThing(std::nullopt);
    showKeys();
}

void MotionTracks::build(const std::vector<MovedThing> &things)
{
    // Not at once: a row's own button may be what this comes from.
    while (QLayoutItem *item = mLayout->takeAt(0)) {
        item->widget()->hide();
        item->widget()->deleteLater();
        delete item;
    }
    mRows.clear();
    for (const MovedThing &thing : things) {
        const QString name = QString::fromStdString(nameOf(mDocument.painting(), thing));
        const int row = int(mRows.size());
        Row made{thing};
        made.arm = button(QStringLiteral("keyframe-record"), tr("Arm %1").arg(name),
                          tr("While armed, what the transform tool drags becomes keys of all of it."));
        made.arm->setCheckable(true);
        auto *label = new QLabel(QFontMetrics(font()).elidedText(name, Qt::ElideRight, nameWidth - 4));
        label->setFixedWidth(nameWidth);
        label->setToolTip(name);
        made.track = new KeyTrack;
        made.track->setAccessibleName(tr("Keys of %1").arg(name));
        made.set = button(QStringLiteral("keyframe-add"), tr("Set key of %1").arg(name),
                          tr("Keeps where it is now as a key, here in time."));
        made.remove = button(QStringLiteral("keyframe-remove"), tr("Remove key of %1").arg(name),
                             tr("Takes away its key under the playhead."));
        int column = 0;
        for (QWidget *part :
             std::initializer_list<QWidget *>{made.arm, label, made.track, made.set, made.remove})
            mLayout->addWidget(part, row, column++);
        connect(made.arm, &QToolButton::clicked, this, [this, thing](bool armed) { arm(thing, armed); });
        connect(made.set, &QToolButton::clicked, this, [this, thing] { setKey(thing); });
        connect(made.remove, &QToolButton::clicked, this, [this, thing] { removeKey(thing); });
        connect(made.track, &KeyTrack::scrubbed, this, &MotionTracks::scrubbed);
        mRows.push_back(made);
    }
    setFixedHeight(std::min<int>(int(mRows.size()), mostRowsSeen) * rowHeight + (mRows.empty() ? 0 : 4));
}

void MotionTracks::showKeys()
{
    for (const Row &row : mRows) {
        const PlacementKeys *keys = keysOf(mDocument.painting(), row.thing);
        if (!keys)
            continue;
        std::vector<TrackKey> shown;
        for (const PlacementKey &key : *keys)
            shown.push_back({key.timeSeconds, false});
        row.track->setKeys(std::move(shown));
        row.track->setLength(mLength);
        row.track->setSeconds(mSeconds);
        row.remove->setEnabled(hasKeyAt(*keys, mSeconds));
        row.arm->setChecked(mView.keyedThing() == row.thing);
    }
}

void MotionTracks::arm(const MovedThing &thing, bool armed)
{
    mView.setKeyedThing(armed ? std::optional(thing) : std::nullopt);
    showKeys();
}

void MotionTracks::setKey(const MovedThing &thing)
{
    if (const PlacementKeys *keys = keysOf(mDocument.painting(), thing))
        (void)mDocument.perform(settingKeys(thing, withKey(*keys, mSeconds, placementAt(*keys, mSeconds))));
}

void MotionTracks::removeKey(const MovedThing &thing)
{
    if (const PlacementKeys *keys = keysOf(mDocument.painting(), thing))
        (void)mDocument.perform(settingKeys(thing, withoutKey(*keys, mSeconds)));
}

} // namespace ductus
