// PanelTexture: a panel's picture on the card. Apart from the widgets because Qt's names of OpenGL and
// libepoxy's do not go together in one file.
#pragma once

#include <cstdint>
#include <utility>

namespace ductus {

/// The context must be the same and current for everything, the destructor too.
class PanelTexture
{
public:
    PanelTexture() = default;
    PanelTexture(PanelTexture &&other) noexcept { *this = std::move(other); }
    PanelTexture &operator=(PanelTexture &&other) noexcept;
    ~PanelTexture();

    /// OpenGL's name, 0 before the first upload.
    std::uint32_t name() const { return mName; }
    /// \a rgba: rows from the top, four bytes a pixel.
    void upload(const unsigned char *rgba, int width, int height);

private:
    std::uint32_t mName = 0;
    int mWidth = 0, mHeight = 0;
};

} // namespace ductus
