#include "support/xr_runtime/runtime.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace ductus::xr {

namespace {

std::uint8_t encoded(float linear)
{
    const float v = std::clamp(linear, 0.f, 1.f);
    const float e = v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1 / 2.4f) - 0.055f;
    return std::uint8_t(std::lround(255 * e));
}

// What an eye would see: formats that are not sRGB hold linear light.
std::vector<std::uint8_t> pixelsOf(const SwapchainObject &swapchain, GLuint texture)
{
    const std::size_t count = std::size_t(swapchain.width) * std::size_t(swapchain.height) * 4;
    std::vector<std::uint8_t> pixels(count);
    if (swapchain.format == GL_SRGB8_ALPHA8) {
        glGetTextureImage(texture, 0, GL_RGBA, GL_UNSIGNED_BYTE, GLsizei(count), pixels.data());
        return pixels;
    }
    std::vector<float> values(count);
    glGetTextureImage(texture, 0, GL_RGBA, GL_FLOAT, GLsizei(count * sizeof(float)), values.data());
    for (std::size_t i = 0; i < count; ++i)
        pixels[i] = i % 4 == 3 ? std::uint8_t(std::lround(255 * std::clamp(values[i], 0.f, 1.f)))
                               : encoded(values[i]);
    return pixels;
}

} // namespace

void dumpImage(const SwapchainObject &swapchain, const XrRect2Di &part, const std::string &file)
{
    GLint packing = 0, buffer = 0, row = 0;
    glGetIntegerv(GL_PACK_ALIGNMENT, &packing);
    glGetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &buffer);
    glGetIntegerv(GL_PACK_ROW_LENGTH, &row);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glPixelStorei(GL_PACK_ROW_LENGTH, 0);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    const std::vector<std::uint8_t> pixels =
        pixelsOf(swapchain, swapchain.textures[std::size_t(swapchain.released)]);
    glPixelStorei(GL_PACK_ALIGNMENT, packing);
    glPixelStorei(GL_PACK_ROW_LENGTH, row);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, GLuint(buffer));

    const int width = part.extent.width, height = part.extent.height;
    std::vector<std::uint8_t> rows(std::size_t(width) * std::size_t(height) * 4);
    for (int y = 0; y < height; ++y) { // rows from the bottom become rows from the top
        const int from = part.offset.y + height - 1 - y;
        std::memcpy(rows.data() + std::size_t(y) * std::size_t(width) * 4,
                    pixels.data() +
                        (std::size_t(from) * std::size_t(swapchain.width) + std::size_t(part.offset.x)) * 4,
                    std::size_t(width) * 4);
    }
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = png_uint_32(width);
    image.height = png_uint_32(height);
    image.format = PNG_FORMAT_RGBA;
    if (!png_image_write_to_file(&image, file.c_str(), 0, rows.data(), 0, nullptr))
        runtime().recorder.line("mistake dump " + file + ": " + image.message);
}

} // namespace ductus::xr
