// SegmentedSwitch: one of a few views, side by side: Sketch | Proxy | Regions | Surface | Deviation.
// Keys 1..9 of the window choose; holding such a key peeks: the view is back when the key is released. Left
// and right move when it has the focus.
#pragma once

#include <QIcon>
#include <QList>
#include <QWidget>

class QAbstractButton;
class QButtonGroup;

namespace ductus {

struct Segment
{
    QString text;
    QString teaches; // tooltip sentence; the key is added
    QIcon icon = {}; // may be null
};

class SegmentedSwitch : public QWidget
{
    Q_OBJECT
public:
    /// \a name: what is switched, for screen readers ("View"). With \a keys the segments answer to 1, 2, ...
    SegmentedSwitch(const QString &name, const QList<Segment> &segments, bool keys = true,
                    QWidget *parent = nullptr);

    int count() const;
    /// The chosen one; while peeking still the one to come back to.
    int current() const { return mCurrent; }
    /// What is to be seen now: current() or the one peeked at.
    int shown() const { return mPeeked >= 0 ? mPeeked : mCurrent; }
    void setCurrent(int index);
    /// A segment that cannot be chosen now, with the reason for its tooltip; empty: it can.
    void setDisabledReason(int index, const QString &reason);
    /// Keys are heard in \a window (default: the widget's own window).
    void listenTo(QWidget *window);

signals:
    /// shown() changed, by click, key or peek.
    void shownChanged(int index);
    /// current() changed for good.
    void currentChanged(int index);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void showEvent(QShowEvent *event) override;

private:
    void choose(int index);
    void updateChecked();
    void updateToolTip(int index);
    bool handleKey(const QKeyEvent &event);

    QList<Segment> mSegments;
    QList<QString> mReasons;
    QButtonGroup *mGroup;
    QWidget *mListened = nullptr;
    bool mHasKeys;
    int mCurrent = 0;
    int mPeeked = -1;
    int mHeldKey = 0;
    quint64 mHeldSince = 0; // timestamp of the press, ms
};

} // namespace ductus
