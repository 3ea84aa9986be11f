#include "sketchsurfacer/ui/window/stroke_panel.h"

#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

namespace ductus {

namespace {

constexpr StrokeRole roles[] = {StrokeRole::Surface, StrokeRole::Boundary, StrokeRole::Ignored,
                                StrokeRole::Inner, StrokeRole::Skeletal};

QIcon roleIcon(StrokeRole role)
{
    const Rgba c = roleColour(role, true);
    QPixmap pixmap(32, 32);
    pixmap.setDevicePixelRatio(2.0);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(QColor(c[0], c[1], c[2]), 3.5, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(QPointF(3, 13), QPointF(13, 3));
    return QIcon(pixmap);
}

} // namespace

QString roleName(StrokeRole role)
{
    switch (role) {
    case StrokeRole::Surface:
        return StrokePanel::tr("on the surface");
    case StrokeRole::Boundary:
        return StrokePanel::tr("border of the surface");
    case StrokeRole::Ignored:
        return StrokePanel::tr("ignored");
    case StrokeRole::Inner:
        return StrokePanel::tr("inside, not used");
    case StrokeRole::Skeletal:
        return StrokePanel::tr("thin tube");
    }
    return {};
}

StrokePanel::StrokePanel(SketchDocument &document, SketchPresenter &presenter, ToolBox &tools,
                         QWidget *parent)
    : QWidget(parent), mDocument(document), mPresenter(presenter), mTools(tools)
{
    auto *form = new QFormLayout(this);
    mLivePresenter = &presenter;
    form->setContentsMargins(0, 0, 0, 0);
    form->setVerticalSpacing(6);
    mChosen = new QLabel;
    mRole = new QComboBox;
    mRole->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    mRole->setMinimumContentsLength(6);
    mRole->setAccessibleName(tr("Role"));
    mRole->setToolTip(tr("With strokes chosen: what they are for. Otherwise: what the role brush paints."));
    for (StrokeRole role : roles)
        mRole->addItem(roleIcon(role), roleName(role), int(role));
    mDelete = new QPushButton(tr("&Delete"));
    mDelete->setToolTip(tr("Takes the chosen strokes out of the sketch (Del). Undo brings them back."));
    // A row of its own: its words would take the room of the role beside them.
    auto *chosen = new QHBoxLayout;
    chosen->addWidget(mChosen);
    chosen->addWidget(mDelete, 1);
    form->addRow(chosen);
    form->addRow(tr("&Role"), mRole);
    mFoundRow = newFoundRow();
    form->addRow(mFoundRow);
    connect(mRole, &QComboBox::activated, this, [this] {
        const StrokeRole role = StrokeRole(mRole->currentData().toInt());
        mTools.setBrushRole(role);
        if (!mPresenter.selection().empty())
            mDocument.setRole(mPresenter.selection(), role);
    });
    connect(mDelete, &QPushButton::clicked, this, [this] {
        const std::vector<StrokeId> chosen = mPresenter.selection();
        mPresenter.setSelection({});
        mDocument.deleteStrokes(chosen);
    });
    connect(&presenter, &SketchPresenter::selectionChanged, this, &StrokePanel::refresh);
    connect(&presenter, &SketchPresenter::resultShown, this, &StrokePanel::refresh);
    connect(&document, &Document::changed, this, &StrokePanel::refresh);
    connect(&tools, &ToolBox::toolChanged, this, &StrokePanel::refresh);
    refresh();
}

QWidget *StrokePanel::newFoundRow()
{
    auto *row = new QWidget;
    row->setObjectName(QStringLiteral("foundBorders"));
    auto *layout = new QVBoxLayout(row);
    layout->setContentsMargins(0, 2, 0, 0);
    layout->setSpacing(4);
    mFound = new QLabel;
    mFound->setWordWrap(true);
    mFound->setProperty("dim", true);
    mConfirm = new QPushButton(tr("Mark as &border"));
    mConfirm->setObjectName(QStringLiteral("confirmBorders"));
    mConfirm->setToolTip(tr("Nobody marked these strokes; the surface ends along them because nothing lies "
                            "beyond. Marked, they stay its border whatever else is drawn."));
    layout->addWidget(mFound);
    layout->addWidget(mConfirm);
    // They are shown while one points at the row, or comes to its button by Tab.
    row->installEventFilter(this);
    mConfirm->installEventFilter(this);
    connect(mConfirm, &QPushButton::clicked, this,
            [this] { mDocument.setRole(mPresenter.foundBorders(), StrokeRole::Boundary); });
    return row;
}

bool StrokePanel::eventFilter(QObject *watched, QEvent *event)
{
    if (!mLivePresenter)
        return false; // the window is going
    switch (event->type()) {
    case QEvent::Enter:
    case QEvent::Leave:
    case QEvent::FocusIn:
    case QEvent::FocusOut:
    case QEvent::Hide:
        // The row keeps the pointer while it is over the button.
        mPresenter.setBordersPointedOut(mFoundRow->isVisible() &&
                                        (mConfirm->hasFocus() || event->type() == QEvent::Enter ||
                                         (watched == mConfirm && mFoundRow->underMouse())));
        break;
    default:
        break;
    }
    return QWidget::eventFilter(watched, event);
}

void StrokePanel::refresh()
{
    const int found = int(mPresenter.foundBorders().size());
    mFound->setText(tr("Border found: the surface ends along %n strokes nobody marked.", nullptr, found));
    mFoundRow->setVisible(found > 0);

    const std::vector<StrokeId> &chosen = mPresenter.selection();
    mChosen->setText(chosen.empty()       ? tr("No stroke chosen")
                     : chosen.size() == 1 ? tr("One stroke chosen")
                                          : tr("%n strokes chosen", nullptr, int(chosen.size())));
    mDelete->setEnabled(!chosen.empty());
    StrokeRole shown = mTools.brushRole();
    for (const Stroke &stroke : mDocument.strokes().strokes)
        if (!chosen.empty() && stroke.id == chosen.front())
            shown = stroke.role;
    mRole->setCurrentIndex(int(std::find(std::begin(roles), std::end(roles), shown) - std::begin(roles)));
}

} // namespace ductus
