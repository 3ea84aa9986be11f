// Strokes and paintings for the other apps: the clipboard, and sending.
#include "document/linked_app.h"
#include "layerpainter/document/stroke_exchange.h"
#include "layerpainter/ui/window/painter_window.h"
#include "project/saving/project_save.h"
#include "widgets/shell/message_bar.h"

#include <QClipboard>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>

namespace ductus {

namespace {

const QString sendKey = QStringLiteral("send");

// "name sketch.ductus" beside the painting, numbered where there is one already.
QString freePathBeside(const QString &path, const QString &word)
{
    const QFileInfo info(path);
    const QString stem = info.dir().filePath(info.completeBaseName() + QLatin1Char(' ') + word);
    QString free = stem + QStringLiteral(".ductus");
    for (int i = 2; QFileInfo::exists(free); ++i)
        free = QStringLiteral("%1 %2.ductus").arg(stem).arg(i);
    return free;
}

} // namespace

void PainterWindow::addExchangeActions()
{
    ActionCatalogue &all = actions();
    const QString file = tr("File"), edit = tr("Edit");
    all.add({"edit.copy",
             tr("&Copy strokes"),
             tr("Puts the chosen strokes on the clipboard, for this app and the others of the suite."),
             "edit-copy",
             {QKeySequence::Copy},
             edit},
            [this] { copyStrokes(); });
    all.add({"edit.paste",
             tr("&Paste strokes"),
             tr("Draws the strokes on the clipboard into the active layer, whichever app they come from."),
             "edit-paste",
             {QKeySequence::Paste},
             edit},
            [this] { pasteStrokes(); });
    all.add(
        {"file.sendToSketchSurfacer",
         tr("Send strokes to S&ketchSurfacer"),
         tr("Makes a sketch of the chosen strokes, or of the active layer, and opens it in SketchSurfacer."),
         "document-send",
         {},
         file},
        [this] { sendToSketchSurfacer(); });
    all.add({"file.sendToDoodleStudio",
             tr("Send to &DoodleStudio"),
             tr("Opens DoodleStudio, where this painting can stand in a filmed scene."),
             "document-send",
             {},
             file},
            [this] { sendToDoodleStudio(); });
}

void PainterWindow::copyStrokes()
{
    const CopiedStrokes copied = copiedElements(mPainting.painting(), mView->selection());
    if (copied.strokes.empty()) {
        messages()->info(tr("Choose strokes first: they are copied then."));
        return;
    }
    QGuiApplication::clipboard()->setMimeData(mimeDataOf(copied).release());
    messages()->success(tr("%n strokes copied.", nullptr, int(copied.strokes.size())));
}

void PainterWindow::pasteStrokes()
{
    Result<CopiedStrokes> strokes = strokesFrom(QGuiApplication::clipboard()->mimeData());
    if (!strokes) {
        messages()->show(strokes.error());
        return;
    }
    const auto made = mPainting.perform(
        drawnStrokes(*strokes, mPainting.painting(), mBrush.layer, mBrush.halfWidth, mBrush.colour));
    if (!made)
        return;
    std::vector<ElementId> pasted;
    for (const std::int32_t id : *made)
        pasted.push_back(ElementId{id});
    mView->setSelection(std::move(pasted));
    messages()->success(tr("%n strokes pasted.", nullptr, int(made->size())));
}

void PainterWindow::sendToSketchSurfacer()
{
    const std::vector<ElementId> chosen =
        mView->selection().empty() ? elementsOf(mPainting.painting(), mBrush.layer) : mView->selection();
    const CopiedStrokes copied = copiedElements(mPainting.painting(), chosen);
    if (copied.strokes.empty()) {
        messages()->info(tr("Choose strokes, or a layer with strokes: they become the sketch."));
        return;
    }
    QString path = mPainting.filePath();
    if (path.isEmpty()) {
        path =
            QFileDialog::getSaveFileName(this, tr("Save the sketch as"),
                                         mPainting.displayName() + tr(" sketch") + QStringLiteral(".ductus"),
                                         tr("Ductus projects (*.ductus)"));
        if (path.isEmpty())
            return;
        if (!path.endsWith(QLatin1String(".ductus"), Qt::CaseInsensitive))
            path += QStringLiteral(".ductus");
    } else {
        path = freePathBeside(path, tr("sketch"));
    }
    jobs().start<SaveReport>(
        {QStringLiteral("send"), tr("Writing the sketch")}, this,
        [path, project = sketchProject(copied, mPainting.displayName().toStdString())](const JobControl &) {
            return saveProject(project, enginePath(path));
        },
        [this, path](Result<SaveReport> saved) {
            if (!saved)
                showError(saved.error());
            else
                open(LinkedApp::SketchSurfacer, path);
        });
}

void PainterWindow::sendToDoodleStudio()
{
    messages()->withdraw(sendKey);
    if (mPainting.isEmpty()) {
        messages()->info(tr("There is nothing painted yet."));
        return;
    }
    const bool hasPlace = !mPainting.filePath().isEmpty() && !mPainting.isReadOnly();
    if (hasPlace && !mPainting.isModified()) {
        open(LinkedApp::DoodleStudio, mPainting.filePath());
        return;
    }
    Message message;
    message.what = tr("DoodleStudio reads the saved painting, and this one has changes.");
    message.action = hasPlace ? tr("Save and send") : tr("Save as and send...");
    message.key = sendKey;
    message.run = [this, hasPlace] {
        const QString path = hasPlace ? mPainting.filePath() : askForPath();
        if (!path.isEmpty())
            saveTo(path, [this, path](bool isSaved) {
                if (isSaved)
                    open(LinkedApp::DoodleStudio, path);
            });
    };
    messages()->show(message);
}

void PainterWindow::open(LinkedApp app, const QString &path)
{
    if (const Result<void> opened = openInApp(app, path); !opened) {
        showError(opened.error());
        return;
    }
    const QString name = app == LinkedApp::DoodleStudio ? tr("DoodleStudio") : tr("SketchSurfacer");
    messages()->show({MessageKind::Success,
                      tr("%1 opens %2.").arg(name, QFileInfo(path).completeBaseName()),
                      {},
                      {},
                      {},
                      sendKey,
                      6});
}

} // namespace ductus
