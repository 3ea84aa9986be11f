// Opening, saving, importing and exporting in SketchSurfacer's window.
#include "document/document_files.h"
#include "document/linked_app.h"
#include "document/project_picture.h"
#include "document/stroke_clipboard.h"
#include "sketchsurfacer/ui/window/sample_pictures.h"
#include "sketchsurfacer/ui/window/surfacer_window.h"
#include "widgets/pages/start_page.h"
#include "widgets/shell/message_bar.h"
#include "widgets/theme/theme.h"

#include <QApplication>
#include <QClipboard>
#include <QEventLoop>
#include <QFileDialog>
#include <QFileInfo>
#include <QMimeData>
#include <QPointer>
#include <QUrl>
#include <algorithm>

namespace ductus {

namespace {

bool isProxyFile(const QString &path)
{
    return isMeshExtension(enginePath(path)) && !path.endsWith(QLatin1String(".obj"), Qt::CaseInsensitive);
}

} // namespace

void SurfacerWindow::fillStartPage()
{
    StartPage *page = startPage();
    page->setHeading(tr("SketchSurfacer"),
                     tr("From a 3D sketch to a surface you can print, render or take into CAD."));
    page->setButtons(tr("New sketch"), tr("Open..."));
    page->setDropSentence(
        tr("Drop a sketch (.curves, .obj, .txt), points (.xyz), a proxy mesh or a project anywhere."));
    const auto refresh = [this] {
        QList<SampleCard> cards;
        const bool dark = coloursOf(QGuiApplication::palette()).isDark;
        for (const SampleSketch &sample : mSamples)
            cards << SampleCard{sample.title, sample.lesson, samplePicturePath(sample, dark), sample.id};
        startPage()->setSamples(cards);
    };
    const auto draw = [this, refresh] {
        drawSamplePictures(jobs(), mSamples, coloursOf(QGuiApplication::palette()).isDark, this, refresh);
    };
    refresh();
    draw();
    connect(this, &MainWindowShell::themeChanged, this, [refresh, draw] {
        refresh();
        draw();
    });
    connect(page, &StartPage::newRequested, this, &SurfacerWindow::newSketch);
    connect(page, &StartPage::openRequested, this, &SurfacerWindow::chooseAndOpen);
    connect(page, &StartPage::openFile, this, &SurfacerWindow::openPath);
    connect(page, &StartPage::openSample, this, &SurfacerWindow::openSample);
    connect(page, &StartPage::forgetFile, &mRecent, &RecentFiles::remove);
    connect(&mRecent, &RecentFiles::changed, this, &SurfacerWindow::refreshRecent);
    refreshRecent();
}

void SurfacerWindow::refreshRecent()
{
    QList<RecentCard> cards;
    for (const RecentFile &file : mRecent.files())
        cards << RecentCard{file.path, QPixmap::fromImage(file.picture), file.isMissing};
    startPage()->setRecent(cards);
}

void SurfacerWindow::refreshRecentPicture()
{
    if (!mRecentPath.isEmpty())
        mRecent.add(mRecentPath, picture());
}

QImage SurfacerWindow::picture()
{
    // Never shown: OpenGL has not begun.
    return mView->frameCount() > 0 && !mSketch.isEmpty() ? mView->grabFramebuffer() : QImage();
}

void SurfacerWindow::showOpened()
{
    showCanvas();
    mView->setFocus();
    if (mSketch.shownResult())
        mFollowsResult = true; // shown as soon as it is drawable
    mPictureTimer.start();
}

void SurfacerWindow::newSketch()
{
    if (!confirmLeaving())
        return;
    mRecentPath.clear();
    mSketch.start({}, defaultSurfaceOptions(), tr("Untitled"));
    showCanvas();
    mTools->setTool(ToolKind::DrawStroke);
}

void SurfacerWindow::chooseAndOpen()
{
    const QString path = QFileDialog::getOpenFileName(
        this, tr("Open"), QFileInfo(mRecent.paths().value(0)).path(),
        tr("Sketches and projects (*.ductus *.curves *.obj *.txt *.xyz *.crv);;Proxy meshes (*.ply *.stl "
           "*.off *.glb "
           "*.obj);;All files (*)"));
    if (!path.isEmpty())
        openPath(path);
}

void SurfacerWindow::openPath(const QString &path)
{
    if (path.endsWith(QLatin1String(".ductus"), Qt::CaseInsensitive)) {
        openProject(path);
    } else if (isProxyFile(path)) {
        openProxy(path);
    } else {
        openSketch(
            tr("Reading %1").arg(QFileInfo(path).fileName()),
            [path](const JobControl &control) { return importSketch(path, control); }, path);
    }
}

void SurfacerWindow::openSample(const QString &id)
{
    for (const SampleSketch &sample : mSamples)
        if (sample.id == id)
            openSketch(tr("Opening %1").arg(sample.title),
                       [sample](const JobControl &control) { return importSample(sample, control); });
}

void SurfacerWindow::pasteSketch()
{
    const QMimeData *data = QGuiApplication::clipboard()->mimeData();
    if (hasStrokes(data)) {
        pasteStrokes(data);
        return;
    }
    if (data && data->hasUrls() && data->urls().first().isLocalFile()) {
        openPath(data->urls().first().toLocalFile());
        return;
    }
    const QString text = data ? data->text().trimmed() : QString();
    if (text.isEmpty()) {
        messages()->info(tr("The clipboard holds neither strokes nor a path to a file."));
    } else if (text.size() < 4096 && !text.contains(QLatin1Char('\n')) && QFileInfo::exists(text)) {
        openPath(text);
    } else {
        openSketch(tr("Reading the clipboard"),
                   [bytes = text.toUtf8(), name = tr("Pasted")](const JobControl &control) {
                       return importSketchText(bytes, name, control);
                   });
    }
}

// Strokes of another app of the suite join the sketch; without one they become it.
void SurfacerWindow::pasteStrokes(const QMimeData *data)
{
    Result<CopiedStrokes> copied = strokesFrom(data);
    if (!copied) {
        showError(copied.error());
        return;
    }
    if (mSketch.isEmpty() || isStartPageShown()) {
        openSketch(tr("Reading the clipboard"), [copied = *copied, name = tr("Pasted")](const JobControl &) {
            ImportedSketch sketch;
            sketch.name = name;
            sketch.strokes.metresPerUnit = copied.metresPerUnit;
            sketch.strokes.upAxis = copied.upAxis;
            for (const CopiedStroke &stroke : copied.strokes) {
                sketch.strokes.strokes.push_back(stroke.line);
                sketch.strokes.strokes.back().id.value = int(sketch.strokes.strokes.size()) - 1;
            }
            return Result<ImportedSketch>(std::move(sketch));
        });
        return;
    }
    std::vector<Stroke> strokes;
    for (CopiedStroke &stroke :
         inUnit(std::move(*copied), mSketch.strokes().metresPerUnit, mSketch.strokes().upAxis).strokes)
        strokes.push_back(std::move(stroke.line));
    const int count = int(strokes.size());
    mPresenter->setSelection(mSketch.pasteStrokes(std::move(strokes)));
    messages()->success(tr("%n strokes pasted.", nullptr, count));
}

void SurfacerWindow::copyStrokes()
{
    CopiedStrokes copied;
    copied.metresPerUnit = mSketch.strokes().metresPerUnit;
    copied.upAxis = mSketch.strokes().upAxis;
    const std::vector<StrokeId> chosen = mPresenter->selection();
    for (const Stroke &stroke : mSketch.strokes().strokes)
        if (chosen.empty() || std::ranges::find(chosen, stroke.id) != chosen.end())
            copied.strokes.push_back({stroke, {}, {}});
    if (copied.strokes.empty()) {
        messages()->info(tr("There are no strokes to copy yet."));
        return;
    }
    QGuiApplication::clipboard()->setMimeData(mimeDataOf(copied).release());
    messages()->success(tr("%n strokes copied.", nullptr, int(copied.strokes.size())));
}

void SurfacerWindow::openSketch(const QString &title,
                                std::function<Result<ImportedSketch>(const JobControl &)> read,
                                const QString &rememberedPath)
{
    if (!confirmLeaving())
        return;
    jobs().start<ImportedSketch>({QStringLiteral("open"), title}, this, std::move(read),
                                 [this, rememberedPath](Result<ImportedSketch> sketch) {
                                     if (!sketch) {
                                         showError(sketch.error());
                                         return;
                                     }
                                     mRecentPath = rememberedPath;
                                     if (!mRecentPath.isEmpty())
                                         mRecent.add(mRecentPath);
                                     adoptSketch(std::move(*sketch));
                                 });
}

void SurfacerWindow::adoptSketch(ImportedSketch sketch)
{
    messages()->closeAll();
    mSketch.start(std::move(sketch.strokes), sketch.options, sketch.name);
    showOpened();
    if (sketch.isPointCloud)
        messages()->info(tr("These %n points do not follow one another: they are taken as points of the "
                            "surface, and creases are found by its shape alone.",
                            nullptr, int(mSketch.strokes().strokes.size())));
    if (sketch.cables.size() == 1)
        messages()->info(
            tr("A stroke looks like a cable and becomes a thin tube. If it is none, select it and set "
               "its role to \u201con the surface\u201d."));
    else if (!sketch.cables.empty())
        messages()->info(
            tr("%n strokes look like cables and become thin tubes. Where one is none, select it and set "
               "its role to \u201con the surface\u201d.",
               nullptr, int(sketch.cables.size())));
    if (!sketch.warnings.isEmpty())
        messages()->warning(tr("Some of the sketch was skipped: %1").arg(sketch.warnings.first()),
                            sketch.warnings.size() > 1
                                ? tr("And %n more.", nullptr, int(sketch.warnings.size()) - 1)
                                : QString());
}

void SurfacerWindow::openProxy(const QString &path)
{
    if (mSketch.isEmpty()) {
        messages()->info(tr("A mesh serves as the proxy of a sketch. Open the sketch first, then the mesh."));
        return;
    }
    using Mesh = std::shared_ptr<const TriangleMesh>;
    auto work = [path](const JobControl &control) -> Result<Mesh> {
        Result<TriangleMesh> mesh = readMesh(enginePath(path), control);
        if (!mesh)
            return mesh.error();
        return Mesh(std::make_shared<const TriangleMesh>(std::move(*mesh)));
    };
    jobs().start<Mesh>({QStringLiteral("open"), tr("Reading the proxy")}, this, work,
                       [this, path](Result<Mesh> mesh) {
                           if (!mesh) {
                               showError(mesh.error());
                               return;
                           }
                           mSketch.setGivenProxy(*mesh);
                           messages()->success(tr("%1 is the proxy now.").arg(QFileInfo(path).fileName()));
                       });
}

void SurfacerWindow::openProject(const QString &path)
{
    if (!confirmLeaving())
        return;
    openDocument(mSketch, jobs(), path, [this, self = QPointer(this), path](Result<OpenNotes> notes) {
        if (!self)
            return;
        if (!notes) {
            showError(notes.error());
            return;
        }
        messages()->closeAll();
        mRecentPath = path;
        mRecent.add(path, projectThumbnail(mSketch.project()));
        showOpened();
        for (const QString &warning : notes->warnings)
            messages()->warning(warning);
    });
}

void SurfacerWindow::save()
{
    if (mSketch.filePath().isEmpty() || mSketch.isReadOnly())
        saveAs();
    else
        saveTo(mSketch.filePath());
}

void SurfacerWindow::saveAs()
{
    if (const QString path = askForPath(); !path.isEmpty())
        saveTo(path);
}

bool SurfacerWindow::saveForClosing()
{
    const bool hasPlace = !mSketch.filePath().isEmpty() && !mSketch.isReadOnly();
    const QString path = hasPlace ? mSketch.filePath() : askForPath();
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

QString SurfacerWindow::askForPath()
{
    QString path =
        QFileDialog::getSaveFileName(this, tr("Save as"), mSketch.displayName() + QStringLiteral(".ductus"),
                                     tr("Ductus projects (*.ductus)"));
    if (!path.isEmpty() && !path.endsWith(QLatin1String(".ductus"), Qt::CaseInsensitive))
        path += QStringLiteral(".ductus");
    return path;
}

void SurfacerWindow::saveTo(const QString &path, std::function<void(bool)> finish)
{
    const QImage shown = picture();
    mSketch.setPicture(shown);
    saveDocument(mSketch, jobs(), path,
                 [this, self = QPointer(this), path, shown, finish](Result<SaveReport> report) {
                     if (!self)
                         return;
                     if (report) {
                         mRecentPath = path;
                         mRecent.add(path, shown);
                     } else {
                         showError(report.error(), tr("Save as..."), [this] { saveAs(); });
                     }
                     if (finish)
                         finish(report.ok());
                 });
}

void SurfacerWindow::sendToLayerPainter()
{
    const QString key = QStringLiteral("send");
    messages()->withdraw(key);
    if (const auto result = mSketch.result(); !result || !result->surface) {
        messages()->show({MessageKind::Info,
                          tr("LayerPainter paints on the surface, and there is none yet."),
                          {},
                          tr("Surface it"),
                          [this] { surfaceIt(); },
                          key,
                          0});
        return;
    }
    const bool hasPlace = !mSketch.filePath().isEmpty() && !mSketch.isReadOnly();
    const auto send = [this] {
        if (const Result<void> opened = openInApp(LinkedApp::LayerPainter, mSketch.filePath()); !opened)
            showError(opened.error());
        else
            messages()->show({MessageKind::Success,
                              tr("LayerPainter opens %1.").arg(mSketch.displayName()),
                              {},
                              {},
                              {},
                              QStringLiteral("send"),
                              6});
    };
    if (hasPlace && !mSketch.isModified()) {
        send();
        return;
    }
    messages()->show({MessageKind::Info,
                      tr("LayerPainter reads the saved project, and this one has changes."),
                      {},
                      hasPlace ? tr("Save and send") : tr("Save as and send..."),
                      [this, hasPlace, send] {
                          const QString path = hasPlace ? mSketch.filePath() : askForPath();
                          if (!path.isEmpty())
                              saveTo(path, [send](bool isSaved) {
                                  if (isSaved)
                                      send();
                              });
                      },
                      key,
                      0});
}

void SurfacerWindow::exportSurface()
{
    const auto result = mSketch.result();
    if (!result || !result->surface)
        return;
    auto *dialog = new ExportDialog(result->surface, mSketch.strokes(), mExportChoice, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        mExportChoice = dialog->choice();
        const QString extension = mExportChoice.extension;
        QString path = QFileDialog::getSaveFileName(
            this, tr("Export surface"), mSketch.displayName() + extension, QStringLiteral("*") + extension);
        if (path.isEmpty())
            return;
        if (!path.endsWith(extension, Qt::CaseInsensitive))
            path += extension;
        exportTo(path, mExportChoice);
    });
    dialog->open();
}

void SurfacerWindow::exportTo(const QString &path, const ExportChoice &choice)
{
    const auto result = mSketch.result();
    if (!result || !result->surface)
        return;
    auto work = [surface = result->surface, strokes = mSketch.content().strokes, choice,
                 path](const JobControl &control) -> Result<bool> {
        const Result<void> written =
            writeMesh(exportContent(*surface, *strokes, choice), enginePath(path), control);
        if (!written)
            return written.error();
        return true;
    };
    jobs().start<bool>({QString(), tr("Exporting the surface")}, this, work,
                       [this, path](Result<bool> written) {
                           if (written)
                               messages()->success(tr("Exported to %1.").arg(QFileInfo(path).fileName()));
                           else
                               showError(written.error());
                       });
}

} // namespace ductus
