// What comes from outside: closing, drops, help, and where the window stood.
#include "widgets/main_window_shell.h"

#include "document/document_files.h"
#include "widgets/shell/message_bar.h"

#include <QAbstractButton>
#include <QApplication>
#include <QCloseEvent>
#include <QDropEvent>
#include <QEventLoop>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QScreen>
#include <QUrl>

namespace ductus {

namespace {

const QString geometryKey = QStringLiteral("window/geometry");
const QString stateKey = QStringLiteral("window/state");
constexpr int stateVersion = 1;

QStringList localFiles(const QMimeData *data)
{
    QStringList paths;
    if (data) {
        for (const QUrl &url : data->urls()) {
            if (url.isLocalFile())
                paths << url.toLocalFile();
        }
    }
    return paths;
}

} // namespace

bool MainWindowShell::confirmLeaving()
{
    if (!mDocument || !mDocument->isModified())
        return true;
    QMessageBox box(QMessageBox::NoIcon, mIdentity.name,
                    tr("Save the changes to \u201c%1\u201d?").arg(mDocument->displayName()),
                    QMessageBox::NoButton, this);
    box.setObjectName(QStringLiteral("saveQuestion"));
    box.setInformativeText(tr("Without saving, what you did since the last save is lost."));
    QAbstractButton *save = box.addButton(tr("&Save"), QMessageBox::AcceptRole);
    QAbstractButton *discard = box.addButton(tr("&Discard changes"), QMessageBox::DestructiveRole);
    QAbstractButton *cancel = box.addButton(tr("&Cancel"), QMessageBox::RejectRole);
    box.setDefaultButton(qobject_cast<QPushButton *>(save));
    box.setEscapeButton(cancel);
    save->setProperty("primary", true);
    box.exec();
    if (box.clickedButton() == discard)
        return true;
    return box.clickedButton() == save && saveForClosing();
}

bool MainWindowShell::saveForClosing()
{
    if (!mDocument || mDocument->filePath().isEmpty())
        return false;
    bool isSaved = false;
    QEventLoop loop;
    saveDocument(*mDocument, jobs(), {}, [&](Result<SaveReport> result) {
        isSaved = result.ok();
        if (!result)
            showError(result.error());
        loop.quit();
    });
    loop.exec(QEventLoop::ExcludeUserInputEvents);
    return isSaved;
}

void MainWindowShell::closeEvent(QCloseEvent *event)
{
    if (!confirmLeaving()) {
        event->ignore();
        return;
    }
    rememberWindow();
    jobs().cancelAll();
    emit closing();
    event->accept();
}

void MainWindowShell::dragEnterEvent(QDragEnterEvent *event)
{
    if (localFiles(event->mimeData()).isEmpty())
        return;
    event->setDropAction(Qt::CopyAction);
    event->accept();
}

void MainWindowShell::dropEvent(QDropEvent *event)
{
    const QStringList paths = localFiles(event->mimeData());
    if (paths.isEmpty())
        return;
    event->setDropAction(Qt::CopyAction);
    event->accept();
    // After the drop: the program the file came from waits until it has ended.
    QMetaObject::invokeMethod(
        this, [this, paths] { emit filesDropped(paths); }, Qt::QueuedConnection);
}

void MainWindowShell::requestHelp()
{
    QWidget *widget = QApplication::widgetAt(QCursor::pos());
    if (!widget || widget->window() != this)
        widget = QApplication::focusWidget();
    for (; widget; widget = widget->parentWidget()) {
        const QString topic = widget->property("helpTopic").toString();
        if (!topic.isEmpty()) {
            emit helpRequested(topic);
            return;
        }
    }
    emit helpRequested(QString());
}

void MainWindowShell::restoreWindow()
{
    const QByteArray geometry = settings().raw(geometryKey).toByteArray();
    if (geometry.isEmpty() || !restoreGeometry(geometry)) {
        const QSize room = screen() ? screen()->availableSize() : QSize(1280, 800);
        resize(std::min(1440, room.width() * 9 / 10), std::min(900, room.height() * 9 / 10));
    }
    const QByteArray state = settings().raw(stateKey).toByteArray();
    if (!state.isEmpty())
        restoreState(state, stateVersion);
}

void MainWindowShell::rememberWindow()
{
    settings().setRaw(geometryKey, saveGeometry());
    settings().setRaw(stateKey, saveState(stateVersion));
    settings().sync();
}

} // namespace ductus
