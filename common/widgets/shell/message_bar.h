// MessageBar: says in the window what happened, what to do, and offers one action. Several messages stand in
// line: the newest is shown, closing it shows the one before. Nothing here interrupts.
#pragma once

#include "base/error.h"

#include <QFrame>
#include <QList>
#include <functional>

class QLabel;
class QPushButton;
class QToolButton;

namespace ductus {

enum class MessageKind { Info, Success, Warning, Error };

struct Message
{
    MessageKind kind = MessageKind::Info;
    QString what;                   // "The sketch could not be read: line 12: x is not a number."
    QString remedy = {};            // "Export it again."; may be empty
    QString action = {};            // text of the button; may be empty
    std::function<void()> run = {}; // what the button does; the message closes
    QString key = {};               // a message with the same key replaces the old one; empty: none
    int secondsShown = 0;           // closes by itself; 0: stays. Use it for Success and Info only
    QString decline = {};           // text of a button beside the action that only closes: "Not now"; may be empty
};

/// The words for \a error.
Message messageFrom(const Error &error);

class MessageBar : public QFrame
{
    Q_OBJECT
public:
    explicit MessageBar(QWidget *parent = nullptr);

    void show(const Message &message);
    /// Cancelled errors are shown to nobody.
    void show(const Error &error);
    void info(const QString &what);
    void success(const QString &what);
    void warning(const QString &what, const QString &remedy = {});
    /// Takes back the message with \a key, if it is there.
    void withdraw(const QString &key);
    void closeCurrent();
    void closeAll();

    const QList<Message> &messages() const { return mMessages; }

signals:
    /// For screen readers and tests.
    void shown(const QString &text);

protected:
    void changeEvent(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    void refresh();

    QList<Message> mMessages; // the last one is shown
    QLabel *mIcon;
    QLabel *mText;
    QLabel *mCount;
    QPushButton *mAction;
    QPushButton *mDecline;
    QToolButton *mClose;
    int mShownSerial = 0;
};

} // namespace ductus
