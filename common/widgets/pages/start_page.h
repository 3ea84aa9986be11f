// StartPage: what is seen before a document is open: on the left New, Open and the recent files with
// pictures, on the right the samples as cards.
#pragma once

#include <QIcon>
#include <QList>
#include <QPixmap>
#include <QWidget>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace ductus {

class FlowLayout;

struct SampleCard
{
    QString title;
    QString lesson;  // one line: what can be learned from it
    QString picture; // file or resource of about 480x300 pixels; may be missing
    QString path;    // what openSample() is emitted with
};

struct RecentCard
{
    QString path;
    QPixmap picture; // may be null
    bool isMissing = false;
};

class StartPage : public QWidget
{
    Q_OBJECT
public:
    explicit StartPage(QWidget *parent = nullptr);

    /// Big words at the top left, and one sentence on what the app is for.
    void setHeading(const QString &title, const QString &sentence);
    void setSamples(const QList<SampleCard> &samples);
    void setRecent(const QList<RecentCard> &recent);
    /// Text of the two buttons; empty hides one. Defaults: "New", "Open..."
    void setButtons(const QString &newText, const QString &openText);
    /// What a file dropped here may be: "Drop a sketch, mesh or project anywhere".
    void setDropSentence(const QString &sentence);
    /// Something of the app's at the lower end of the left column: unsaved work found after a crash.
    void setNotice(QWidget *notice);

signals:
    void newRequested();
    void openRequested();
    void openFile(const QString &path);
    void openSample(const QString &path);
    void forgetFile(const QString &path);

private:
    QLabel *mTitle;
    QLabel *mSentence;
    QPushButton *mNew;
    QPushButton *mOpen;
    QLabel *mRecentHeading;
    QVBoxLayout *mRecent;
    QVBoxLayout *mNotice;
    QLabel *mSamplesHeading;
    FlowLayout *mSamples;
    QLabel *mDrop;
};

} // namespace ductus
