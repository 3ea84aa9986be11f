// HelpWindow: a page of the manual, opened at one of its headings.
#pragma once

#include <QDialog>

class QTextBrowser;

namespace ductus {

class HelpWindow : public QDialog
{
    Q_OBJECT
public:
    /// \a markdown: the page, a file or resource. A missing one is told in its place.
    explicit HelpWindow(const QString &markdown, QWidget *parent = nullptr);

    /// Puts \a heading at the upper edge; the beginning of the page if there is no such heading. True if
    /// there is.
    bool showSection(const QString &heading);
    /// The heading of what stands at the upper edge; empty above the first.
    QString shownSection() const;

private:
    QTextBrowser *mPage;
};

} // namespace ductus
