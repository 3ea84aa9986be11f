// Opening, saving, importing and exporting in LayerPainter's window.
#include "document/bundled_sample.h"
#include "document/document_files.h"
#include "document/project_picture.h"
#include "layerpainter/document/import_into.h"
#include "layerpainter/document/painting_project.h"
#include "layerpainter/ui/window/painter_window.h"
#include "painting/edit/layer_edits.h"
#include "widgets/pages/start_page.h"
#include "widgets/shell/message_bar.h"

#include <QEventLoop>
#include <QFileDialog>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>

namespace ductus {

namespace {

QByteArray resource(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

void PainterWindow::fillStartPage()
{
    StartPage *page = startPage();
    page->setHeading(tr("LayerPainter"), tr("Light, shadow and mood for 3D paintings, layer by layer."));
    page->setButtons(tr("New painting"), tr("Open..."));
    page->setDropSentence(tr("Drop a Quill or .tilt painting, a mesh or a project anywhere."));
    QList<SampleCard> cards;
    const QJsonObject list =
        QJsonDocument::fromJson(resource(QStringLiteral(":/paintings/paintings.json"))).object();
    for (const QJsonValue &sample : list["samples"].toArray()) {
        const QString id = sample["id"].toString();
        cards << SampleCard{sample["title"].toString(), sample["lesson"].toString(),
                            QStringLiteral(":/paintings/%1.png").arg(id), id};
    }
    page->setSamples(cards);
    connect(page, &StartPage::newRequested, this, &PainterWindow::newPainting);
    connect(page, &StartPage::openRequested, this, &PainterWindow::chooseAndOpen);
    connect(page, &StartPage::openFile, this, &PainterWindow::openPath);
    connect(page, &StartPage::openSample, this, &PainterWindow::openSample);
    connect(page, &StartPage::forgetFile, &mRecent, &RecentFiles::remove);
    connect(&mRecent, &RecentFiles::changed, this, &PainterWindow::refreshRecent);
    refreshRecent();
}

void PainterWindow::refreshRecent()
{
    QList<RecentCard> cards;
    for (const RecentFile &file : mRecent.files())
        cards << RecentCard{file.path, QPixmap::fromImage(file.picture), file.isMissing};
    startPage()->setRecent(cards);
}

void PainterWindow::showOpened()
{
    showCanvas();
    mView->setFocus();
    mView->frameAll();
}

void PainterWindow::newPainting()
{
    if (!confirmLeaving())
        return;
    mPainting.start({}, tr("Untitled"));
    mLayers->addStack();
    showOpened();
    setTool(PainterTool::Paint);
}

void PainterWindow::chooseAndOpen()
{
    const QString path =
        QFileDialog::getOpenFileName(this, tr("Open"), QFileInfo(mRecent.paths().value(0)).path(),
                                     tr("Paintings and meshes (*.ductus *.quill Quill.json *.tilt *.obj "
                                        "*.ply *.stl *.off *.glb);;All files (*)"));
    if (!path.isEmpty())
        openPath(path);
}

void PainterWindow::openPath(const QString &path)
{
    if (path.endsWith(QLatin1String(".ductus"), Qt::CaseInsensitive)) {
        if (const QString id = bundledSampleId(path, QStringLiteral("paintings.json")); !id.isEmpty())
            openSample(id);
        else
            openProject(path);
        return;
    }
    if (!confirmLeaving())
        return;
    jobs().start<ImportedFile>(
        {QStringLiteral("open"), tr("Reading %1").arg(QFileInfo(path).fileName())},
        [path](const JobControl &control) { return importFile(enginePath(path), {}, control); },
        [this, path](Result<ImportedFile> file) {
            if (!file)
                showError(file.error());
            else
                adopt(std::move(*file), QFileInfo(path).absoluteFilePath());
        });
}

void PainterWindow::chooseImport()
{
    const QString path = QFileDialog::getOpenFileName(
        this, tr("Import"), QFileInfo(mRecent.paths().value(0)).path(),
        tr("Paintings and meshes (*.quill Quill.json *.tilt *.obj *.ply *.stl *.off *.glb);;Surfaces of "
           "SketchSurfacer (*.ductus)"));
    if (!path.isEmpty())
        importPath(path);
}

void PainterWindow::importPath(const QString &path)
{
    jobs().start<ImportedFile>(
        {QStringLiteral("import"), tr("Reading %1").arg(QFileInfo(path).fileName()), false, true, true}, this,
        [path](const JobControl &control) { return importFile(enginePath(path), {}, control); },
        [this](Result<ImportedFile> file) {
            if (!file) {
                showError(file.error());
                return;
            }
            const AddedImport added = addImported(mPainting, *file);
            showCanvas();
            mView->frameAll();
            QString what = tr("%n strokes joined the painting", nullptr, added.strokes) +
                           tr(" in %n stacks.", nullptr, added.stacks);
            if (added.leftFramesOut)
                what += tr(" Of drawings frame by frame the first came along.");
            messages()->success(what);
        });
}

// Projects are opened; what else is dropped on a painting joins it.
void PainterWindow::takeDropped(const QStringList &paths)
{
    const bool joins = !mPainting.isEmpty() && !isStartPageShown();
    for (const QString &path : paths)
        if (joins && !path.endsWith(QLatin1String(".ductus"), Qt::CaseInsensitive))
            importPath(path);
        else
            openPath(path);
}

void PainterWindow::openSample(const QString &id)
{
    if (!confirmLeaving())
        return;
    const QString path = QStringLiteral(":/paintings/%1.ductus").arg(id);
    const QByteArray bytes = resource(path);
    const std::string_view view(bytes.constData(), std::size_t(bytes.size()));
    const Result<Project> project =
        parseProject(asBytes(view), id.toStdString() + ".ductus", knownDocuments());
    if (!project) {
        showError(project.error());
        return;
    }
    const Result<StoredPainting> stored = paintingFromProject(*project);
    if (!stored) {
        showError(stored.error());
        return;
    }
    adopt({stored->content->painting(), "sample", stored->name, {}, {}}, path);
}

void PainterWindow::adopt(ImportedFile file, const QString &source)
{
    messages()->closeAll();
    mPainting.start(std::move(file.painting), QString::fromStdString(file.name), source);
    showOpened();
    const std::vector<std::string> &skipped = file.report.skipped;
    if (skipped.empty())
        return;
    const QString what = tr("Some of it was skipped: %1").arg(QString::fromStdString(skipped.front()));
    if (int(skipped.size()) == file.report.unseenSkips) // nothing to warn of
        messages()->info(what);
    else
        messages()->warning(what, skipped.size() > 1 ? tr("And %n more.", nullptr, int(skipped.size()) - 1)
                                                     : QString());
}

void PainterWindow::openProject(const QString &path)
{
    if (!confirmLeaving())
        return;
    openDocument(mPainting, jobs(), path, [this, path](Result<OpenNotes> notes) {
        if (!notes) {
            showError(notes.error());
            return;
        }
        messages()->closeAll();
        mRecent.add(path, projectThumbnail(mPainting.project()));
        if (mPainting.isReadOnly() && mPainting.isMadeOfSurfaces()) {
            // Sent here by an app that still has the project: the painting gets a file of its own.
            paintOnSurfacesOf(path);
            return;
        }
        showOpened();
        lookForNewerSurfaces(false);
        for (const QString &warning : notes->warnings)
            messages()->warning(warning);
    });
}

void PainterWindow::save()
{
    if (mPainting.filePath().isEmpty() || mPainting.isReadOnly())
        saveAs();
    else
        saveTo(mPainting.filePath());
}

void PainterWindow::saveAs()
{
    if (const QString path = askForPath(); !path.isEmpty())
        saveTo(path);
}

QString PainterWindow::askForPath()
{
    QString path =
        QFileDialog::getSaveFileName(this, tr("Save as"), mPainting.displayName() + QStringLiteral(".ductus"),
                                     tr("Ductus projects (*.ductus)"));
    if (!path.isEmpty() && !path.endsWith(QLatin1String(".ductus"), Qt::CaseInsensitive))
        path += QStringLiteral(".ductus");
    return path;
}

bool PainterWindow::saveForClosing()
{
    const bool hasPlace = !mPainting.filePath().isEmpty() && !mPainting.isReadOnly();
    const QString path = hasPlace ? mPainting.filePath() : askForPath();
    if (path.isEmpty())
        return false;
    bool isSaved = false;
    QEventLoop loop;
    saveTo(path, [&](bool saved) {
        isSaved = saved;
        loop.quit();
    });
    loop.exec(QEventLoop::ExcludeUserInputEvents);
    return isSaved;
}

void PainterWindow::saveTo(const QString &path, std::function<void(bool)> finish)
{
    const QImage shown = mView->picture();
    mPainting.setPicture(shown);
    saveDocument(mPainting, jobs(), path, [this, path, shown, finish](Result<SaveReport> report) {
        if (report)
            mRecent.add(path, shown);
        else
            showError(report.error(), tr("Save as..."), [this] { saveAs(); });
        if (finish)
            finish(report.ok());
    });
}

void PainterWindow::chooseLogFile()
{
    const QString path = QFileDialog::getSaveFileName(this, tr("Save action log"),
                                                      mPainting.displayName() + QStringLiteral(".jsonl"),
                                                      tr("Action logs (*.jsonl)"));
    if (!path.isEmpty())
        saveActionLog(path);
}

void PainterWindow::saveActionLog(const QString &path)
{
    const std::string text = mPainting.actionLog();
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(text.data(), qint64(text.size())) < 0 ||
        !file.commit())
        showError({ErrorCode::WriteFailed, "Writing the action log", file.errorString().toStdString(),
                   "Choose another folder", path.toStdString()});
    else
        messages()->success(tr("The log of %n actions is saved.", nullptr, mPainting.logLength()));
}

} // namespace ductus
