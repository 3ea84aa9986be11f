#include "widgets/pages/start_page.h"

#include "document/settings/action_catalogue.h"
#include "widgets/controls/flow_layout.h"
#include "widgets/pages/recent_row.h"
#include "widgets/pages/sample_card.h"
#include "widgets/pages/sample_words.h"
#include "widgets/theme/icons.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

namespace ductus {

namespace {

constexpr int rowInset = 8; // of a recent file's picture in its row
constexpr int leftWidth = 312 + rowInset;
constexpr int outerMargin = 32;
constexpr int cardGap = 24;

QLabel *caption(const QString &text)
{
    auto *label = new QLabel(text);
    label->setProperty("caption", true);
    return label;
}

void clearLayout(QLayout *layout)
{
    while (QLayoutItem *item = layout->takeAt(0)) {
        if (QWidget *widget = item->widget()) {
            // Not now: the click that led here may still be on its way through it.
            widget->hide();
            widget->deleteLater();
        }
        delete item;
    }
}

QScrollArea *scrolling(QWidget *content, const QString &name)
{
    auto *area = new QScrollArea;
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setFocusPolicy(Qt::NoFocus);
    area->setAccessibleName(name);
    content->setObjectName(QStringLiteral("scrolled"));
    area->setWidget(content);
    return area;
}

} // namespace

StartPage::StartPage(QWidget *parent)
    : QWidget(parent), mTitle(new QLabel), mSentence(new QLabel), mNew(new QPushButton(tr("&New"))),
      mOpen(new QPushButton(tr("&Open..."))), mRecentHeading(caption(tr("Recent"))), mRecent(nullptr),
      mNotice(new QVBoxLayout), mSamplesHeading(caption(tr("Samples"))), mSamples(nullptr), mDrop(new QLabel)
{
    setAccessibleName(tr("Start"));
    mTitle->setProperty("heading", true);
    mSentence->setProperty("dim", true);
    mSentence->setWordWrap(true);
    mDrop->setProperty("dim", true);
    mDrop->setWordWrap(true);
    mNew->setProperty("primary", true);
    mNew->setIcon(icon(QStringLiteral("document-new"), IconTint::OnAccent));
    mOpen->setIcon(icon(QStringLiteral("document-open")));
    mOpen->setProperty("large", true);
    for (QPushButton *button : {mNew, mOpen}) {
        button->setIconSize({16, 16});
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    }
    setButtons(mNew->text(), mOpen->text());

    auto *recentColumn = new QWidget;
    mRecent = new QVBoxLayout(recentColumn);
    mRecent->setContentsMargins(0, 0, 0, 0);
    mRecent->setSpacing(0);
    mRecent->setAlignment(Qt::AlignTop);

    auto *left = new QWidget;
    left->setFixedWidth(leftWidth);
    auto *leftLayout = new QVBoxLayout(left);
    leftLayout->setContentsMargins(0, outerMargin, 0, 24);
    leftLayout->setSpacing(8);
    leftLayout->addWidget(mTitle);
    leftLayout->addWidget(mSentence);
    leftLayout->addSpacing(8);
    auto *buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    buttons->setContentsMargins(rowInset, 0, 0, 0);
    // All but the rows are inset, so that the rows' pictures stand below the headings.
    for (QLabel *label : {mTitle, mSentence, mRecentHeading, mDrop})
        label->setContentsMargins(rowInset, 0, 0, 0);
    buttons->addWidget(mNew);
    buttons->addWidget(mOpen);
    leftLayout->addLayout(buttons);
    leftLayout->addLayout(mNotice);
    leftLayout->addSpacing(16);
    leftLayout->addWidget(mRecentHeading);
    leftLayout->addWidget(scrolling(recentColumn, tr("Recent files")), 1);
    leftLayout->addWidget(mDrop);

    auto *cards = new QWidget;
    auto *cardsLayout = new QVBoxLayout(cards);
    cardsLayout->setContentsMargins(0, 0, 0, outerMargin);
    mSamples = new FlowLayout(cardGap);
    cardsLayout->addLayout(mSamples);
    cardsLayout->addStretch(1);
    auto *right = new QVBoxLayout;
    right->setContentsMargins(0, outerMargin, 0, 0);
    right->setSpacing(12);
    right->addWidget(mSamplesHeading);
    right->addWidget(scrolling(cards, tr("Samples")), 1);

    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(outerMargin - rowInset, 0, 16, 0);
    layout->setSpacing(48);
    layout->addWidget(left);
    layout->addLayout(right, 1);

    connect(mNew, &QPushButton::clicked, this, &StartPage::newRequested);
    connect(mOpen, &QPushButton::clicked, this, &StartPage::openRequested);
    setRecent({});
    setSamples({});
    setDropSentence(tr("Or drop a file anywhere in this window."));
}

void StartPage::setHeading(const QString &title, const QString &sentence)
{
    mTitle->setText(title);
    mSentence->setText(sentence);
}

void StartPage::setButtons(const QString &newText, const QString &openText)
{
    mNew->setVisible(!newText.isEmpty());
    mOpen->setVisible(!openText.isEmpty());
    mNew->setText(newText);
    mOpen->setText(openText);
    mNew->setAccessibleName(plainText(newText));
    mOpen->setAccessibleName(plainText(openText));
}

void StartPage::setDropSentence(const QString &sentence)
{
    mDrop->setText(sentence);
}

void StartPage::setNotice(QWidget *notice)
{
    clearLayout(mNotice);
    if (notice) {
        mNotice->setContentsMargins(rowInset, 16, 0, 0);
        mNotice->addWidget(notice);
    }
}

void StartPage::setSamples(const QList<SampleCard> &samples)
{
    clearLayout(mSamples);
    mSamplesHeading->setVisible(!samples.isEmpty());
    for (SampleCard sample : samples) {
        sample.title = sampleWords(sample.title);
        sample.lesson = sampleWords(sample.lesson);
        auto *card = new SampleCardButton(sample);
        connect(card, &QAbstractButton::clicked, this, [this, path = sample.path] { emit openSample(path); });
        mSamples->addWidget(card);
    }
}

void StartPage::setRecent(const QList<RecentCard> &recent)
{
    clearLayout(mRecent);
    if (recent.isEmpty()) {
        auto *none = new QLabel(tr("Files you open will be listed here."));
        none->setProperty("dim", true);
        none->setWordWrap(true);
        none->setContentsMargins(rowInset, 0, 0, 0);
        mRecent->addWidget(none);
    }
    for (const RecentCard &card : recent) {
        auto *row = new RecentRow(card);
        connect(row, &RecentRow::opened, this, &StartPage::openFile);
        connect(row, &RecentRow::forgotten, this, &StartPage::forgetFile);
        mRecent->addWidget(row);
    }
}

} // namespace ductus
