#include "widgets/shell/message_bar.h"

#include "document/words/engine_words.h"
#include "widgets/theme/icons.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QTimer>
#include <QToolButton>

namespace ductus {

namespace {

constexpr int successSeconds = 6;
constexpr int mostMessages = 20; // older ones are dropped

QString kindName(MessageKind kind)
{
    switch (kind) {
    case MessageKind::Info:
        return QStringLiteral("info");
    case MessageKind::Success:
        return QStringLiteral("success");
    case MessageKind::Warning:
        return QStringLiteral("warning");
    case MessageKind::Error:
        return QStringLiteral("error");
    }
    return {};
}

IconTint tintOf(MessageKind kind)
{
    switch (kind) {
    case MessageKind::Info:
        return IconTint::Accent;
    case MessageKind::Success:
        return IconTint::Success;
    case MessageKind::Warning:
        return IconTint::Warning;
    case MessageKind::Error:
        return IconTint::Error;
    }
    return IconTint::Text;
}

QString sentence(const std::string &words)
{
    QString text = engineWords(words);
    if (text.isEmpty())
        return text;
    text[0] = text[0].toUpper();
    const QString ends = QStringLiteral(".?\u3002"); // the last one is the Japanese full stop
    if (!ends.contains(text.back()))
        text += MessageBar::tr(".", "ends a sentence");
    return text;
}

} // namespace

Message messageFrom(const Error &error)
{
    Message message;
    message.kind = MessageKind::Error;
    QString where;
    if (!error.place.empty())
        where = QStringLiteral(" (%1)").arg(QString::fromStdString(error.place));
    const QString problem = engineWords(error.problem);
    message.what = error.attempted.empty()
                       ? sentence(error.problem)
                       : MessageBar::tr("%1 failed: %2%3.").arg(engineWords(error.attempted), problem, where);
    message.remedy = sentence(error.remedy);
    return message;
}

MessageBar::MessageBar(QWidget *parent)
    : QFrame(parent), mIcon(new QLabel), mText(new QLabel), mCount(new QLabel), mAction(new QPushButton),
      mDecline(new QPushButton), mClose(new QToolButton)
{
    setObjectName(QStringLiteral("messageBar"));
    setAccessibleName(tr("Messages"));
    mText->setWordWrap(true);
    mText->setTextFormat(Qt::RichText);
    mText->setTextInteractionFlags(Qt::TextSelectableByMouse);
    mText->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    mCount->setProperty("dim", true);
    mClose->setIcon(icon(QStringLiteral("close")));
    mClose->setIconSize({16, 16});
    mClose->setFixedSize(28, 28);
    mClose->setAccessibleName(tr("Close message"));
    mClose->setToolTip(tr("Close this message (Esc)"));
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(16, 6, 8, 6);
    layout->setSpacing(12);
    layout->addWidget(mIcon);
    layout->addWidget(mText, 1);
    layout->addWidget(mCount);
    layout->addWidget(mAction);
    layout->addWidget(mDecline);
    layout->addWidget(mClose);
    connect(mClose, &QToolButton::clicked, this, &MessageBar::closeCurrent);
    connect(mDecline, &QPushButton::clicked, this, &MessageBar::closeCurrent);
    connect(mAction, &QPushButton::clicked, this, [this] {
        const std::function<void()> run = mMessages.last().run;
        closeCurrent();
        if (run)
            run();
    });
    hide();
}

void MessageBar::show(const Message &message)
{
    if (!message.key.isEmpty())
        mMessages.removeIf([&](const Message &old) { return old.key == message.key; });
    mMessages.append(message);
    if (mMessages.size() > mostMessages)
        mMessages.removeFirst();
    refresh();
    emit shown(message.remedy.isEmpty() ? message.what : message.what + QLatin1Char(' ') + message.remedy);
    if (message.secondsShown > 0) {
        const int serial = mShownSerial;
        QTimer::singleShot(message.secondsShown * 1000, this, [this, serial] {
            if (serial == mShownSerial)
                closeCurrent();
        });
    }
}

void MessageBar::show(const Error &error)
{
    if (!error.isCancelled())
        show(messageFrom(error));
}

void MessageBar::info(const QString &what)
{
    show(Message{MessageKind::Info, what});
}

void MessageBar::success(const QString &what)
{
    Message message{MessageKind::Success, what};
    message.secondsShown = successSeconds;
    message.key = QStringLiteral("success");
    show(message);
}

void MessageBar::warning(const QString &what, const QString &remedy)
{
    show(Message{MessageKind::Warning, what, remedy});
}

void MessageBar::withdraw(const QString &key)
{
    if (mMessages.removeIf([&](const Message &old) { return old.key == key; }) > 0)
        refresh();
}

void MessageBar::closeCurrent()
{
    if (mMessages.isEmpty())
        return;
    mMessages.removeLast();
    refresh();
}

void MessageBar::closeAll()
{
    mMessages.clear();
    refresh();
}

void MessageBar::refresh()
{
    ++mShownSerial;
    setVisible(!mMessages.isEmpty());
    if (mMessages.isEmpty())
        return;
    const Message &message = mMessages.last();
    setProperty("kind", kindName(message.kind));
    style()->unpolish(this);
    style()->polish(this);
    mIcon->setPixmap(icon(QStringLiteral("status-") + kindName(message.kind), tintOf(message.kind))
                         .pixmap(QSize(20, 20), devicePixelRatioF()));
    QString text = message.what.toHtmlEscaped();
    if (!message.remedy.isEmpty())
        text = QStringLiteral("<b>%1</b> %2").arg(text, message.remedy.toHtmlEscaped());
    mText->setText(text);
    mText->setAccessibleName(message.what + QLatin1Char(' ') + message.remedy);
    mAction->setVisible(!message.action.isEmpty());
    mAction->setText(message.action);
    mAction->setAccessibleName(message.action);
    mDecline->setVisible(!message.decline.isEmpty());
    mDecline->setText(message.decline);
    mDecline->setAccessibleName(message.decline);
    mCount->setVisible(mMessages.size() > 1);
    mCount->setText(tr("%n more", nullptr, int(mMessages.size()) - 1));
}

void MessageBar::changeEvent(QEvent *event)
{
    QFrame::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && !mMessages.isEmpty())
        mIcon->setPixmap(
            icon(QStringLiteral("status-") + kindName(mMessages.last().kind), tintOf(mMessages.last().kind))
                .pixmap(QSize(20, 20), devicePixelRatioF()));
}

void MessageBar::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Escape)
        closeCurrent();
    else
        QFrame::keyPressEvent(event);
}

} // namespace ductus
