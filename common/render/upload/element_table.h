// What the graphics card knows of every element: where it stands, whose it is, when it is drawn.
#pragma once

#include "base/result.h"
#include "painting/scene/ids.h"
#include "painting/scene/placement.h"
#include "render/gl/gl_object.h"

#include <cstdint>
#include <vector>

namespace ductus {

struct ElementRow
{
    float sceneFromElement[3][4];
    std::int32_t element = 0;
    std::uint32_t order = 0; // place in its layer
    std::int32_t stack = 0;
    float scale = 1;

    static ElementRow of(const Placement &sceneFromElement, ElementId element, std::uint32_t order,
                         StackId stack);
    bool operator==(const ElementRow &other) const;
};
static_assert(sizeof(ElementRow) == 64); // elements.glsl

class ElementTable
{
public:
    std::uint32_t add();
    void remove(std::uint32_t row);
    /// True if the row has changed.
    bool set(std::uint32_t row, const ElementRow &content);
    const ElementRow &at(std::uint32_t row) const { return mRows[row]; }

    /// Sends changed rows.
    Result<void> upload();
    void bind() const;
    std::uint64_t bytesWritten() const { return mBytesWritten; }

private:
    std::vector<ElementRow> mRows;
    std::vector<std::uint32_t> mFree;
    std::vector<std::uint32_t> mChanged;
    GlBuffer mBuffer;
    std::size_t mCapacity = 0;
    std::uint64_t mBytesWritten = 0;
};

} // namespace ductus
