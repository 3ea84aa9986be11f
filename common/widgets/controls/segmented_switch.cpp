#include "widgets/controls/segmented_switch.h"

#include "document/settings/action_catalogue.h"
#include "widgets/controls/segment_button.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QButtonGroup>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QTextEdit>

namespace ductus {

namespace {

constexpr quint32 peekMs = 250; // a key held longer than this peeks

bool isTyping()
{
    const QWidget *focus = QApplication::focusWidget();
    return qobject_cast<const QLineEdit *>(focus) || qobject_cast<const QAbstractSpinBox *>(focus) ||
           qobject_cast<const QTextEdit *>(focus);
}

} // namespace

SegmentedSwitch::SegmentedSwitch(const QString &name, const QList<Segment> &segments, bool keys,
                                 QWidget *parent)
    : QWidget(parent), mSegments(segments), mReasons(segments.size()), mGroup(new QButtonGroup(this)),
      mHasKeys(keys)
{
    setAccessibleName(name);
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    for (int i = 0; i < segments.size(); ++i) {
        auto *button = new SegmentButton(segments[i].text, segments[i].icon);
        button->setEnds(i == 0, i + 1 == segments.size());
        button->setAccessibleName(plainText(segments[i].text));
        button->setAccessibleDescription(segments[i].teaches);
        // One stop for Tab; the arrows go on from there.
        button->setFocusPolicy(i == 0 ? Qt::StrongFocus : Qt::ClickFocus);
        button->installEventFilter(this);
        mGroup->addButton(button, i);
        layout->addWidget(button);
        updateToolTip(i);
    }
    mGroup->setExclusive(true);
    connect(mGroup, &QButtonGroup::idClicked, this, &SegmentedSwitch::choose);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    updateChecked();
}

int SegmentedSwitch::count() const
{
    return int(mSegments.size());
}

void SegmentedSwitch::setCurrent(int index)
{
    if (index < 0 || index >= count() || index == mCurrent)
        return;
    const int before = shown();
    mCurrent = index;
    updateChecked();
    emit currentChanged(index);
    if (shown() != before)
        emit shownChanged(shown());
}

void SegmentedSwitch::setDisabledReason(int index, const QString &reason)
{
    if (index < 0 || index >= count())
        return;
    mReasons[index] = reason;
    mGroup->button(index)->setEnabled(reason.isEmpty());
    updateToolTip(index);
}

void SegmentedSwitch::listenTo(QWidget *window)
{
    if (mListened)
        qApp->removeEventFilter(this);
    mListened = window;
    // The keys go to whatever has the focus, so they are met on their way there.
    if (mListened && mHasKeys)
        qApp->installEventFilter(this);
}

void SegmentedSwitch::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    if (!mListened)
        listenTo(window());
}

void SegmentedSwitch::choose(int index)
{
    mPeeked = -1;
    mHeldKey = 0;
    setCurrent(index);
    updateChecked();
}

void SegmentedSwitch::updateChecked()
{
    mGroup->button(shown())->setChecked(true);
    for (int i = 0; i < count(); ++i) {
        auto *button = static_cast<SegmentButton *>(mGroup->button(i));
        button->setComesBack(mPeeked >= 0 && i == mCurrent);
        button->setFocusPolicy(i == mCurrent ? Qt::StrongFocus : Qt::ClickFocus);
    }
}

void SegmentedSwitch::updateToolTip(int index)
{
    QString tip =
        QStringLiteral("<p style='margin:0'><b>%1</b>").arg(plainText(mSegments[index].text).toHtmlEscaped());
    if (mHasKeys && index < 9)
        tip += QStringLiteral("&nbsp;&nbsp;%1").arg(index + 1);
    tip += QStringLiteral("</p>");
    if (!mSegments[index].teaches.isEmpty())
        tip += QStringLiteral("<p style='margin:4px 0 0 0'>%1</p>")
                   .arg(mSegments[index].teaches.toHtmlEscaped());
    if (mHasKeys && mReasons[index].isEmpty())
        tip += QStringLiteral("<p style='margin:4px 0 0 0'>%1</p>")
                   .arg(tr("Hold the key to peek.").toHtmlEscaped());
    if (!mReasons[index].isEmpty())
        tip +=
            QStringLiteral("<p style='margin:4px 0 0 0'><i>%1</i></p>").arg(mReasons[index].toHtmlEscaped());
    mGroup->button(index)->setToolTip(tip);
}

bool SegmentedSwitch::handleKey(const QKeyEvent &event)
{
    const int key = event.key();
    const bool pressed = event.type() == QEvent::KeyPress;
    const int index = key - Qt::Key_1;
    if (index < 0 || index >= std::min(count(), 9) || !mReasons[index].isEmpty())
        return false;
    if (event.isAutoRepeat())
        return true;
    if (pressed) {
        mHeldKey = key;
        mHeldSince = event.timestamp();
        const int before = shown();
        mPeeked = index == mCurrent ? -1 : index;
        updateChecked();
        if (shown() != before)
            emit shownChanged(shown());
        return true;
    }
    if (key != mHeldKey)
        return false;
    mHeldKey = 0;
    if (mPeeked < 0)
        return true;
    // When the fingers moved, and not when we came to hear of it: a slow frame may lie between. X11 counts
    // milliseconds in 32 bits and begins again after seven weeks.
    const bool isPeek = quint32(event.timestamp() - mHeldSince) > peekMs;
    const int peeked = mPeeked;
    mPeeked = -1;
    if (isPeek) {
        updateChecked();
        emit shownChanged(mCurrent);
    } else {
        mCurrent = peeked;
        updateChecked();
        emit currentChanged(peeked);
    }
    return true;
}

bool SegmentedSwitch::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::WindowDeactivate && watched == mListened && mPeeked >= 0) {
        // The release will go to another window.
        mPeeked = -1;
        mHeldKey = 0;
        updateChecked();
        emit shownChanged(mCurrent);
        return false;
    }
    if (event->type() != QEvent::KeyPress && event->type() != QEvent::KeyRelease)
        return false;
    auto *key = static_cast<QKeyEvent *>(event);
    if (mGroup->buttons().contains(qobject_cast<QAbstractButton *>(watched)) &&
        (key->key() == Qt::Key_Left || key->key() == Qt::Key_Right)) {
        if (event->type() == QEvent::KeyPress)
            keyPressEvent(key);
        return true;
    }
    auto *widget = qobject_cast<QWidget *>(watched);
    const bool isPlain = (key->modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
    const bool isRelease = event->type() == QEvent::KeyRelease && key->key() == mHeldKey;
    if (!widget || !mListened || widget->window() != mListened || !isVisible() || !isEnabled())
        return false;
    if (!isRelease && (!isPlain || isTyping()))
        return false;
    return handleKey(*key);
}

void SegmentedSwitch::keyPressEvent(QKeyEvent *event)
{
    if (event->key() != Qt::Key_Left && event->key() != Qt::Key_Right) {
        QWidget::keyPressEvent(event);
        return;
    }
    const bool forward = (event->key() == Qt::Key_Right) != isRightToLeft();
    for (int index = mCurrent + (forward ? 1 : -1); index >= 0 && index < count();
         index += forward ? 1 : -1) {
        if (mReasons[index].isEmpty()) {
            choose(index);
            mGroup->button(index)->setFocus(Qt::TabFocusReason);
            return;
        }
    }
}

} // namespace ductus
