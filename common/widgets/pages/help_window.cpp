#include "widgets/pages/help_window.h"

#include <QAbstractTextDocumentLayout>
#include <QFile>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace ductus {

HelpWindow::HelpWindow(const QString &markdown, QWidget *parent) : QDialog(parent), mPage(new QTextBrowser)
{
    setWindowTitle(tr("Manual"));
    resize(640, 720);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(mPage);
    mPage->setAccessibleName(tr("Manual"));
    mPage->setFrameShape(QFrame::NoFrame);
    mPage->setOpenExternalLinks(true);
    mPage->document()->setDocumentMargin(24);
    QFile file(markdown);
    if (file.open(QIODevice::ReadOnly))
        mPage->setMarkdown(QString::fromUtf8(file.readAll()));
    else
        mPage->setPlainText(tr("The manual is missing in this installation: %1.").arg(file.errorString()));
}

bool HelpWindow::showSection(const QString &heading)
{
    for (QTextBlock block = mPage->document()->begin(); block.isValid(); block = block.next()) {
        if (block.blockFormat().headingLevel() == 0 ||
            block.text().compare(heading, Qt::CaseInsensitive) != 0)
            continue;
        // The last sections can come to the upper edge only if the page goes on below them.
        QTextFrameFormat frame = mPage->document()->rootFrame()->frameFormat();
        frame.setBottomMargin(height());
        mPage->document()->rootFrame()->setFrameFormat(frame);
        const QRectF place = mPage->document()->documentLayout()->blockBoundingRect(block);
        mPage->setTextCursor(QTextCursor(block));
        mPage->verticalScrollBar()->setValue(int(place.top()) - 8);
        return true;
    }
    mPage->moveCursor(QTextCursor::Start);
    return false;
}

QString HelpWindow::shownSection() const
{
    for (QTextBlock block = mPage->cursorForPosition(QPoint(30, 24)).block(); block.isValid();
         block = block.previous())
        if (block.blockFormat().headingLevel() > 0)
            return block.text();
    return {};
}

} // namespace ductus
