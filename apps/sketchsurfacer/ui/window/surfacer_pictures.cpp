// Pictures of the canvas: one, and a round of them.
#include "sketchsurfacer/ui/viewport/turntable.h"
#include "sketchsurfacer/ui/window/surfacer_window.h"
#include "widgets/shell/message_bar.h"

#include <QDir>
#include <QFileInfo>

namespace ductus {

namespace {

Error cannotWrite(const QString &path)
{
    return {ErrorCode::WriteFailed, "Writing the picture", "the file cannot be written",
            "Choose another folder, or make room on the disk", path.toStdString()};
}

} // namespace

void SurfacerWindow::savePicture(const QString &path)
{
    auto work = [picture = mView->smoothPicture(), path](const JobControl &) -> Result<bool> {
        if (!picture.save(path, "PNG"))
            return cannotWrite(path);
        return true;
    };
    jobs().start<bool>(
        {QString(), tr("Writing the picture")}, this, work, [this, path](Result<bool> written) {
            if (written)
                messages()->success(tr("The picture is in %1.").arg(QFileInfo(path).fileName()));
            else
                showError(written.error());
        });
}

void SurfacerWindow::saveTurntable(const QString &folder, int count)
{
    mTurntable->setTurning(false);
    mTurntable->takePictures(count, [this, folder, count](int number, const QImage &picture) {
        const QString path =
            QDir(folder).filePath(QStringLiteral("turntable-%1.png").arg(number, 3, 10, QLatin1Char('0')));
        if (!picture.save(path, "PNG")) {
            showError(cannotWrite(path));
            return false;
        }
        if (number + 1 == count)
            messages()->success(tr("%n pictures are in %1.", nullptr, count).arg(QDir(folder).dirName()));
        return true;
    });
}

} // namespace ductus
