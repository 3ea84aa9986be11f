#include "widgets/shell/inspector.h"

#include "document/settings/settings.h"
#include "widgets/controls/folding_section.h"

#include <QScrollArea>
#include <QVBoxLayout>

namespace ductus {

namespace {

constexpr int inspectorWidth = 300;

} // namespace

Inspector::Inspector(Settings &settings, QWidget *parent)
    : QWidget(parent), mSettings(settings), mHead(new QVBoxLayout), mSections(nullptr), mArea(new QScrollArea)
{
    setObjectName(QStringLiteral("inspector"));
    setAttribute(Qt::WA_StyledBackground);
    setAccessibleName(tr("Inspector"));
    setFixedWidth(inspectorWidth + 1); // and its line
    auto *column = new QWidget;
    column->setObjectName(QStringLiteral("scrolled"));
    mSections = new QVBoxLayout(column);
    mSections->setContentsMargins(0, 0, 0, 16);
    mSections->setSpacing(0);
    mSections->addStretch(1);
    mArea->setFrameShape(QFrame::NoFrame);
    mArea->setWidgetResizable(true);
    mArea->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    mArea->setFocusPolicy(Qt::NoFocus);
    mArea->setWidget(column);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(1, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(mHead);
    layout->addWidget(mArea, 1);
}

void Inspector::setHead(QWidget *widget)
{
    mHead->setContentsMargins(16, 16, 16, 12);
    mHead->addWidget(widget);
}

FoldingSection *Inspector::addSection(const QString &id, const QString &title, QWidget *content)
{
    auto *section = new FoldingSection(title, content);
    section->setObjectName(id);
    mSections->insertWidget(mSections->count() - 1, section);
    const QByteArray key = ("inspector/folded/" + id).toUtf8();
    section->setFolded(mSettings.raw(QString::fromUtf8(key)).toBool());
    connect(section, &FoldingSection::foldedChanged, this,
            [this, key](bool folded) { mSettings.setRaw(QString::fromUtf8(key), folded); });
    return section;
}

} // namespace ductus
