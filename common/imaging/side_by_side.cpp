#include "imaging/side_by_side.h"

#include <algorithm>

namespace ductus {

Image sideBySide(const std::vector<Image> &images, int gap, Rgba background)
{
    gap = std::max(0, gap);
    int width = 0, height = 0;
    for (const Image &image : images) {
        if (image.width <= 0 || image.height <= 0)
            continue;
        width += image.width + (width > 0 ? gap : 0);
        height = std::max(height, image.height);
    }
    Image result(width, height, background);
    int left = 0;
    for (const Image &image : images) {
        if (image.width <= 0 || image.height <= 0)
            continue;
        const int top = (height - image.height) / 2;
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x)
                result.set(left + x, top + y, image.at(x, y));
        }
        left += image.width + gap;
    }
    return result;
}

} // namespace ductus
