// What LayerPainter's window writes for other programs: pictures, films, meshes.
#include "document/document_files.h"
#include "formats/atomic_file.h"
#include "formats/png_file.h"
#include "layerpainter/document/export_mesh.h"
#include "layerpainter/ui/window/film_dialog.h"
#include "layerpainter/ui/window/painter_window.h"
#include "layerpainter/ui/window/picture_dialog.h"
#include "widgets/shell/message_bar.h"

#include <QDesktopServices>
#include <QFileDialog>
#include <QFileInfo>
#include <QUrl>
#include <span>

namespace ductus {

void PainterWindow::chooseExport()
{
    if (mPainting.isEmpty()) {
        messages()->info(tr("There is nothing to export yet; paint or open something first."));
        return;
    }
    auto *dialog = new PictureDialog(mView->size(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        const FrameOptions options = dialog->choice();
        const QString path = QFileDialog::getSaveFileName(this, tr("Export picture"),
                                                          mPainting.displayName() + QStringLiteral(".png"),
                                                          tr("Pictures (*.png)"));
        if (!path.isEmpty())
            exportPicture(path.endsWith(QLatin1String(".png"), Qt::CaseInsensitive) ? path : path + ".png",
                          options);
    });
    dialog->open();
}

void PainterWindow::exportPicture(const QString &path, const FrameOptions &options)
{
    const auto work = [painting = mPainting.sharedPainting(), options, camera = mView->camera().frame(),
                       seconds = mView->seconds(), path](const JobControl &control) -> Result<QSize> {
        const Result<Image> image = makeFrames(painting, options)->frame({seconds, {}}, camera, control);
        if (!image)
            return image.error();
        const Result<std::vector<std::byte>> png = encodePng(*image);
        if (!png)
            return png.error();
        if (const Result<void> written = writeFileAtomically(enginePath(path), *png, "Writing the picture");
            !written)
            return written.error();
        return QSize(image->width, image->height);
    };
    jobs().start<QSize>(
        {QStringLiteral("picture:") + path, tr("Exporting %1").arg(QFileInfo(path).fileName())}, this, work,
        [this, path](Result<QSize> size) {
            if (!size)
                showError(size.error());
            else
                messages()->success(tr("Exported to %1, %2 x %3 pixels.")
                                        .arg(QFileInfo(path).fileName())
                                        .arg(size->width())
                                        .arg(size->height()));
        });
}

void PainterWindow::chooseFilm()
{
    if (mPainting.isEmpty()) {
        messages()->info(tr("There is nothing to film yet; paint or open something first."));
        return;
    }
    auto *dialog = new FilmDialog(mPainting.sharedPainting(), mView->camera().key(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        const FilmChoice choice = dialog->choice();
        const QString name = mPainting.displayName() + choice.extension;
        const QString path = QFileDialog::getSaveFileName(
            this, tr("Export film"), name,
            choice.extension.isEmpty() ? tr("Folders (*)") : QStringLiteral("*") + choice.extension);
        if (path.isEmpty())
            return;
        const bool isNamed = path.endsWith(choice.extension, Qt::CaseInsensitive);
        exportFilm(isNamed ? path : path + choice.extension, choice);
    });
    dialog->open();
}

void PainterWindow::exportFilm(const QString &path, const FilmChoice &choice)
{
    const auto painting = mPainting.sharedPainting();
    std::vector<std::pair<std::filesystem::path, std::optional<LookId>>> films;
    if (choice.everyLook)
        for (const Look &look : painting->looks)
            films.emplace_back(pathForLook(enginePath(path), look.name, int(films.size()) + 1), look.id);
    else
        films.emplace_back(enginePath(path), choice.film.look);
    const auto work = [painting, films,
                       film = choice.film](const JobControl &control) mutable -> Result<int> {
        for (std::size_t i = 0; i < films.size(); ++i) {
            film.look = films[i].second;
            const JobControl part =
                control.part(double(i) / double(films.size()), double(i + 1) / double(films.size()));
            if (const Result<void> written = writeFilm(painting, film, films[i].first, part); !written)
                return written.error();
        }
        return int(films.size());
    };
    // Films may be made side by side, but not two of one file.
    jobs().start<int>(
        {QStringLiteral("film:") + path, tr("Exporting %1").arg(QFileInfo(path).fileName())}, this, work,
        [this, path](Result<int> films) {
            if (!films) {
                showError(films.error());
                return;
            }
            messages()->show(
                {MessageKind::Success,
                 *films == 1 ? tr("The film %1 is ready.").arg(QFileInfo(path).fileName())
                             : tr("%n films are ready.", nullptr, *films),
                 {},
                 tr("Show in folder"),
                 [path] { QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(path).absolutePath())); }});
        });
}

void PainterWindow::chooseMesh()
{
    const QString path = QFileDialog::getSaveFileName(this, tr("Export mesh"),
                                                      mPainting.displayName() + QStringLiteral(".glb"),
                                                      tr("Meshes with colours (*.glb)"));
    if (!path.isEmpty())
        exportMesh(path.endsWith(QLatin1String(".glb"), Qt::CaseInsensitive) ? path : path + ".glb");
}

void PainterWindow::exportMesh(const QString &path)
{
    struct Counts
    {
        std::int64_t vertices = 0, triangles = 0;
    };
    const auto work = [painting = mPainting.sharedPainting(), path,
                       seconds = mView->seconds()](const JobControl &control) -> Result<Counts> {
        MeshExportOptions options;
        options.moment.timeSeconds = seconds;
        const Result<ExportedMesh> mesh = exportedMesh(*painting, options, control);
        if (!mesh)
            return mesh.error();
        if (const Result<void> written = writeFileAtomically(
                enginePath(path), std::as_bytes(std::span(mesh->bytes)), "Writing the mesh");
            !written)
            return written.error();
        return Counts{mesh->vertices, mesh->triangles};
    };
    jobs().start<Counts>({QStringLiteral("mesh:") + path, tr("Exporting %1").arg(QFileInfo(path).fileName())},
                         this, work, [this, path](Result<Counts> counts) {
                             if (!counts)
                                 showError(counts.error());
                             else
                                 messages()->success(tr("Exported %L1 triangles with their colours to %2.")
                                                         .arg(counts->triangles)
                                                         .arg(QFileInfo(path).fileName()));
                         });
}

} // namespace ductus
