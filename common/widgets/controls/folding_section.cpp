#include "widgets/controls/folding_section.h"

#include "document/settings/action_catalogue.h"
#include "widgets/theme/icons.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QToolButton>
#include <QVBoxLayout>

namespace ductus {

FoldingSection::FoldingSection(const QString &title, QWidget *content, QWidget *parent)
    : QWidget(parent), mHeading(new QToolButton), mContent(content), mFrame(new QWidget),
      mLayout(new QVBoxLayout(this)), mHeadingRow(new QWidget)
{
    mHeading->setObjectName(QStringLiteral("foldingHeading"));
    mHeading->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    mHeading->setIconSize({16, 16});
    mHeading->setFixedHeight(28);
    mHeading->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    mHeading->setFocusPolicy(Qt::TabFocus);
    mHeading->installEventFilter(this);
    connect(mHeading, &QToolButton::clicked, this, [this] { setFolded(!mIsFolded); });

    auto *row = new QHBoxLayout(mHeadingRow);
    row->setContentsMargins(8, 4, 16, 0);
    row->setSpacing(4);
    row->addWidget(mHeading);
    mLayout->setContentsMargins(0, 0, 0, 0);
    mLayout->setSpacing(0);
    mLayout->addWidget(mHeadingRow);
    auto *inner = new QVBoxLayout(mFrame);
    inner->setContentsMargins(16, 4, 16, 12);
    inner->addWidget(content);
    mLayout->addWidget(mFrame);
    auto *line = new QWidget;
    line->setObjectName(QStringLiteral("sectionLine"));
    line->setAttribute(Qt::WA_StyledBackground);
    line->setFixedHeight(1);
    mLayout->addWidget(line);
    setTitle(title);
    setFolded(false);
}

QString FoldingSection::title() const
{
    return mHeading->text();
}

void FoldingSection::setTitle(const QString &title)
{
    mHeading->setText(title);
    setAccessibleName(plainText(title));
    setFolded(mIsFolded);
}

void FoldingSection::setFolded(bool folded)
{
    const bool isNew = folded != mIsFolded;
    mIsFolded = folded;
    mFrame->setVisible(!folded);
    mHeading->setIcon(icon(folded ? QStringLiteral("chevron-right") : QStringLiteral("chevron-down")));
    mHeading->setAccessibleName(folded ? tr("%1, folded").arg(plainText(title()))
                                       : tr("%1, unfolded").arg(plainText(title())));
    if (isNew)
        emit foldedChanged(folded);
}

void FoldingSection::setHeadingWidget(QWidget *widget)
{
    mHeadingRow->layout()->addWidget(widget);
}

bool FoldingSection::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == mHeading && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent *>(event)->key();
        if (key == Qt::Key_Left || key == Qt::Key_Right) {
            setFolded(key == Qt::Key_Left);
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace ductus
