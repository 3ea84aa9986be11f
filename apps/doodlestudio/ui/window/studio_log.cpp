// Writing down what is done in DoodleStudio's window, for who wants to study how people work with it.
#include "doodlestudio/ui/window/studio_window.h"
#include "widgets/shell/message_bar.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QSaveFile>

namespace ductus {

void StudioWindow::addLogActions()
{
    const QString edit = tr("Edit");
    QAction *keep = actions().addToggle(
        {"edit.keepLog",
         tr("&Write down what I do"),
         tr("Every step and command with its time, from now on; nothing leaves this computer."),
         {},
         {},
         edit},
        [this](bool on) {
            mLog.setOn(on);
            actions().setDisabledReason(QStringLiteral("edit.saveLog"),
                                        on || mLog.length() > 0 ? QString()
                                                                : tr("Nothing was written down."));
            if (on)
                messages()->info(
                    tr("What you do is written down from now on. Edit > Save what I did keeps it."));
        });
    QAction *save =
        actions().add({"edit.saveLog",
                       tr("Save what I &did..."),
                       tr("A line of JSON for every step: when, what, on which canvas, in which frame."),
                       {},
                       {},
                       edit},
                      [this] {
                          const QString path = QFileDialog::getSaveFileName(
                              this, tr("Save what I did"), mDoodle.displayName() + QStringLiteral(".jsonl"),
                              tr("Action logs (*.jsonl)"));
                          if (!path.isEmpty())
                              saveActionLog(path);
                      });
    actions().setDisabledReason(QStringLiteral("edit.saveLog"), tr("Nothing was written down."));
    addToMenu(editMenu(), {keep, save});
}

void StudioWindow::saveActionLog(const QString &path)
{
    const QByteArray text = mLog.text();
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size() || !file.commit())
        showError({ErrorCode::WriteFailed, "Writing the action log", file.errorString().toStdString(),
                   "Choose another folder", path.toStdString()});
    else
        messages()->success(
            tr("%n act(s) written to %1.", nullptr, mLog.length()).arg(QFileInfo(path).fileName()));
}

} // namespace ductus
