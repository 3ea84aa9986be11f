#include "ductus/project_thumbnail.h"

#include "document/document_files.h"
#include "document/project_picture.h"
#include "ductus/project_kind.h"
#include "formats/png_file.h"
#include "project/project_reader.h"

#include <QProcess>
#include <QTemporaryDir>

#include <cstring>

namespace ductus {

namespace {

constexpr char attempted[] = "Drawing the thumbnail";

Image plainImage(const QImage &picture)
{
    const QImage rows = picture.convertToFormat(QImage::Format_RGBA8888);
    Image image(rows.width(), rows.height());
    for (int y = 0; y < image.height; ++y)
        std::memcpy(image.pixels.data() + std::size_t(y) * image.width * 4, rows.constScanLine(y),
                    std::size_t(image.width) * 4);
    return image;
}

/// `APP thumbnail PROJECT`, waited for.
Result<Image> drawnByApp(LinkedApp app, const std::filesystem::path &project, int longerSide,
                         const JobControl &control)
{
    const std::string name = programOf(app).toStdString();
    const QString program = findProgram(app);
    if (program.isEmpty())
        return Error{ErrorCode::FileNotFound, attempted,
                     name + " is not installed, and the project holds no picture",
                     "Install it beside this program, or put its folder into PATH", project.string()};
    const QTemporaryDir folder;
    if (!folder.isValid())
        return Error{ErrorCode::WriteFailed, attempted, folder.errorString().toStdString(), "",
                     project.string()};
    const QString picture = folder.filePath(QStringLiteral("picture.png"));
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.setStandardInputFile(QProcess::nullDevice());
    process.start(program, {QStringLiteral("thumbnail"), QFile::decodeName(project.c_str()),
                            QStringLiteral("-o"), picture, QStringLiteral("--size"),
                            QString::number(longerSide), QStringLiteral("--quiet")});
    while (!process.waitForFinished(50)) {
        if (process.state() == QProcess::NotRunning)
            break; // never started
        if (control.isCancelled()) {
            process.kill();
            process.waitForFinished();
            return cancelledError(attempted);
        }
    }
    if (process.exitStatus() != QProcess::NormalExit || process.exitCode() != 0)
        return Error{ErrorCode::Unsupported, attempted,
                     name + " cannot draw it: " + process.readAll().trimmed().toStdString(),
                     "Open the project in its window and save it, so that it holds a picture",
                     project.string()};
    return readPng(enginePath(picture));
}

} // namespace

Result<Image> thumbnailOf(const std::filesystem::path &path, int longerSide, const JobControl &control)
{
    const Result<Project> project = openProject(path);
    if (!project)
        return project.error();
    QImage picture = projectThumbnail(*project);
    if (!picture.isNull()) {
        if (std::max(picture.width(), picture.height()) > longerSide)
            picture = picture.scaled(longerSide, longerSide, Qt::KeepAspectRatio, Qt::SmoothTransformation);
        return plainImage(picture);
    }
    const std::optional<LinkedApp> app = appOf(*project);
    if (!app)
        return Error{ErrorCode::Unsupported, attempted,
                     "the project holds no picture and no document of the suite", "", path.string()};
    return drawnByApp(*app, path, longerSide, control);
}

} // namespace ductus
