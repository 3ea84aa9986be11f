#include "layerpainter/vr/panels/panel_texture.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>

namespace ductus {

PanelTexture &PanelTexture::operator=(PanelTexture &&other) noexcept
{
    std::swap(mName, other.mName);
    std::swap(mWidth, other.mWidth);
    std::swap(mHeight, other.mHeight);
    return *this;
}

PanelTexture::~PanelTexture()
{
    if (mName)
        glDeleteTextures(1, &mName);
}

void PanelTexture::upload(const unsigned char *rgba, int width, int height)
{
    if (!mName || width != mWidth || height != mHeight) {
        if (mName)
            glDeleteTextures(1, &mName);
        mWidth = width;
        mHeight = height;
        glGenTextures(1, &mName);
        glBindTexture(GL_TEXTURE_2D, mName);
        const int levels = 1 + int(std::log2(std::max({width, height, 1})));
        glTexStorage2D(GL_TEXTURE_2D, levels, GL_RGBA8, width, height);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    }
    glBindTexture(GL_TEXTURE_2D, mName);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
    glGenerateMipmap(GL_TEXTURE_2D);
    glBindTexture(GL_TEXTURE_2D, 0);
}

} // namespace ductus
