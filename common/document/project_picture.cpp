#include "document/project_picture.h"

#include <QBuffer>
#include <QImageReader>

namespace ductus {

namespace {

constexpr int longestSide = 256;
constexpr int longestReadSide = 2048; // of files other programs wrote

} // namespace

QImage projectThumbnail(const Project &project)
{
    if (!project.thumbnail)
        return {};
    const Result<Bytes> bytes = unpacked(*project.thumbnail, "thumbnail.png");
    if (!bytes)
        return {};
    QByteArray data(reinterpret_cast<const char *>(bytes->data()), qsizetype(bytes->size()));
    QBuffer buffer(&data);
    QImageReader reader(&buffer, "png");
    // The size is asked before anything is unpacked: a small file can claim a picture of gigabytes.
    const QSize size = reader.size();
    if (!size.isValid() || size.width() > longestReadSide || size.height() > longestReadSide)
        return {};
    return reader.read();
}

void setProjectThumbnail(Project &project, const QImage &picture)
{
    if (picture.isNull()) {
        project.thumbnail.reset();
        return;
    }
    QImage image = picture.convertToFormat(QImage::Format_ARGB32);
    image.setDevicePixelRatio(1.0);
    if (std::max(image.width(), image.height()) > longestSide)
        image = image.scaled(longestSide, longestSide, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    QByteArray data;
    QBuffer buffer(&data);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "png");
    project.thumbnail =
        storedEntry("thumbnail.png", std::as_bytes(std::span(data.constData(), std::size_t(data.size()))));
}

} // namespace ductus
