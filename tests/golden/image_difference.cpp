#include "golden/image_difference.h"

#include <algorithm>
#include <cstdlib>

namespace ductus {

namespace {

QImage quarter(const QImage &image)
{
    return image.convertToFormat(QImage::Format_RGB32)
        .scaled(image.size() / 4, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

} // namespace

ImageDifference differenceOf(const QImage &made, const QImage &kept, const DifferenceOptions &options)
{
    ImageDifference difference;
    if (made.isNull() || made.size() != kept.size())
        return difference;
    const QImage a = quarter(made), b = quarter(kept);
    difference.picture = a;
    int failing = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
            const int most = std::max({std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)),
                                       std::abs(qBlue(p) - qBlue(q))});
            const bool fails = most > options.channelTolerance;
            failing += fails;
            difference.picture.setPixel(
                x, y, fails ? qRgb(255, 40, 40) : qRgb(qGray(p) / 3, qGray(p) / 3, qGray(p) / 3));
        }
    difference.failingShare = double(failing) / std::max(1, a.width() * a.height());
    return difference;
}

QImage toBeKept(const QImage &image)
{
    QImage kept = image.convertToFormat(QImage::Format_RGB888);
    const auto coarse = [](uchar value) { return uchar((value & 0xf0) | 8); };
    for (int y = 0; y < kept.height(); ++y) {
        uchar *line = kept.scanLine(y);
        std::transform(line, line + 3 * kept.width(), line, coarse);
    }
    return kept;
}

} // namespace ductus
