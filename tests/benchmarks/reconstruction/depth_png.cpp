#include "benchmarks/reconstruction/depth_png.h"

#include <cstdio>
#include <memory>
#include <png.h>

namespace ductus {

DepthPicture readDepthPng(const std::filesystem::path &path)
{
    const std::unique_ptr<std::FILE, int (*)(std::FILE *)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png ? png_create_info_struct(png) : nullptr;
    DepthPicture picture;
    std::vector<png_bytep> rows;
    if (file && info && setjmp(png_jmpbuf(png)) == 0) {
        png_init_io(png, file.get());
        png_read_info(png, info);
        const bool is16Grey =
            png_get_bit_depth(png, info) == 16 && png_get_color_type(png, info) == PNG_COLOR_TYPE_GRAY;
        if (is16Grey) {
            png_set_swap(png);
            picture.width = int(png_get_image_width(png, info));
            picture.height = int(png_get_image_height(png, info));
            picture.values.resize(std::size_t(picture.width) * std::size_t(picture.height));
            for (int y = 0; y < picture.height; ++y)
                rows.push_back(reinterpret_cast<png_bytep>(picture.values.data() +
                                                           std::size_t(y) * std::size_t(picture.width)));
            png_read_image(png, rows.data());
        }
    }
    png_destroy_read_struct(&png, info ? &info : nullptr, nullptr);
    return picture;
}

} // namespace ductus
