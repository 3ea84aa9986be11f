#include "widgets/pages/help_window.h"

#include <QAbstractTextDocumentLayout>
#include <QFile>
#include <QFileInfo>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextCursor>
#include <QTextDocument>
#include <QVBoxLayout>

namespace ductus {

namespace {

constexpr double pictureWidth = 560.0; // of a window as wide as it opens

// Screens are wider than a page.
void fitPictures(QTextDocument &page)
{
    for (QTextBlock block = page.begin(); block.isValid(); block = block.next())
        for (QTextBlock::iterator part = block.begin(); !part.atEnd(); ++part) {
            QTextImageFormat picture = part.fragment().charFormat().toImageFormat();
            if (!picture.isValid())
                continue;
            picture.setWidth(pictureWidth);
            QTextCursor cursor(&page);
            cursor.setPosition(part.fragment().position());
            cursor.setPosition(part.fragment().position() + part.fragment().length(),
                               QTextCursor::KeepAnchor);
            cursor.setCharFormat(picture);
            break; // its fragments are others now; a picture is alone in its paragraph
        }
}

} // namespace

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
    if (file.open(QIODevice::ReadOnly)) {
        mPage->setSearchPaths({QFileInfo(markdown).path()}); // pictures stand beside the text
        mPage->setMarkdown(QString::fromUtf8(file.readAll()));
        fitPictures(*mPage->document());
    } else {
        mPage->setPlainText(tr("The manual is missing in this installation: %1.").arg(file.errorString()));
    }
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
