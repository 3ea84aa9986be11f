// FoldingSection: a heading that folds what is below it. By mouse or, with the focus on the heading, Space
// and left/right.
#pragma once

#include <QWidget>

class QToolButton;
class QVBoxLayout;

namespace ductus {

class FoldingSection : public QWidget
{
    Q_OBJECT
public:
    /// Takes the content.
    FoldingSection(const QString &title, QWidget *content, QWidget *parent = nullptr);

    QString title() const;
    void setTitle(const QString &title);
    QWidget *content() const { return mContent; }
    bool isFolded() const { return mIsFolded; }
    void setFolded(bool folded);
    /// A small widget at the right of the heading: a count, a menu button. Takes it.
    void setHeadingWidget(QWidget *widget);

signals:
    void foldedChanged(bool folded);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QToolButton *mHeading;
    QWidget *mContent;
    QWidget *mFrame; // the content with its margins
    QVBoxLayout *mLayout;
    QWidget *mHeadingRow;
    bool mIsFolded = false;
};

} // namespace ductus
