#include "layerpainter/document/texture_block.h"

#include <QCollator>
#include <QFileInfo>
#include <QImageReader>
#include <algorithm>

namespace ductus {

namespace {

constexpr char attempted[] = "Reading a texture";
constexpr int mostCells = 256; // along a side: 16 MB a block

Result<QImage> slice(const QString &path)
{
    QImageReader reader(path);
    reader.setAutoTransform(true);
    const QSize size = reader.size();
    if (size.isValid() && size.width() * double(size.height()) > 1e8)
        return Error{ErrorCode::TooLarge, attempted, "the picture has more than 100 million pixels",
                     "Make it smaller", path.toStdString()};
    const QImage image = reader.read();
    if (image.isNull())
        return Error{ErrorCode::Malformed, attempted, reader.errorString().toStdString(),
                     "Choose PNG pictures", path.toStdString()};
    return image;
}

} // namespace

Result<TextureMask> textureFromPictures(QStringList paths, const Box3 &box)
{
    if (paths.isEmpty())
        return Error{
            ErrorCode::InvalidArgument, attempted, "no picture was chosen", "Choose one or more", {}};
    // slice2 comes before slice10
    QCollator byNumbers(QLocale(QLocale::English)); // the C locale knows no numbers
    byNumbers.setNumericMode(true);
    std::sort(paths.begin(), paths.end(), byNumbers);

    TextureMask texture;
    texture.depth = std::min(int(paths.size()), mostCells);
    auto values = std::make_shared<std::vector<std::uint8_t>>();
    QSize whole;
    for (int z = 0; z < texture.depth; ++z) {
        // Of more slices than cells those in even steps.
        const QString &path = paths[int(qint64(z) * paths.size() / texture.depth)];
        const Result<QImage> image = slice(path);
        if (!image)
            return image.error();
        if (z == 0)
            whole = image->size();
        else if (image->size() != whole)
            return Error{ErrorCode::InvalidArgument, attempted, "the pictures differ in size",
                         "Choose slices of one block", path.toStdString()};
        const QSize cells = whole.boundedTo({mostCells, mostCells});
        const QImage small =
            cells == whole ? *image : image->scaled(cells, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
        texture.width = cells.width();
        texture.height = cells.height();
        // Rows of pictures grow downwards, the block's y upwards.
        for (int y = cells.height() - 1; y >= 0; --y)
            for (int x = 0; x < cells.width(); ++x) {
                const QRgb pixel = small.pixel(x, y);
                values->push_back(std::uint8_t(qGray(pixel) * qAlpha(pixel) / 255));
            }
    }
    texture.values = std::move(values);
    const double side = box.isEmpty() ? 1 : std::max((box.max - box.min).maxCoeff(), 1e-9);
    const Vec3 middle = box.isEmpty() ? Vec3(Vec3::Zero()) : box.centre();
    texture.placement.scale = side;
    texture.placement.translation = middle - Vec3::Constant(0.5 * side);
    return texture;
}

} // namespace ductus
