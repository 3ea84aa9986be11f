#include "render/upload/element_table.h"

#include "render/gl/gl_error.h"

#include <algorithm>
#include <cstring>

namespace ductus {

ElementRow ElementRow::of(const Placement &placement, ElementId element, std::uint32_t order, StackId stack)
{
    ElementRow row;
    const Eigen::Matrix4d matrix = placement.matrix().matrix();
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 4; ++j)
            row.sceneFromElement[i][j] = float(matrix(i, j));
    row.element = element.value;
    row.order = order;
    row.stack = stack.value;
    row.scale = float(placement.scale);
    return row;
}

bool ElementRow::operator==(const ElementRow &other) const
{
    return std::memcmp(this, &other, sizeof(ElementRow)) == 0;
}

std::uint32_t ElementTable::add()
{
    if (!mFree.empty()) {
        const std::uint32_t row = mFree.back();
        mFree.pop_back();
        return row;
    }
    mRows.emplace_back();
    return std::uint32_t(mRows.size() - 1);
}

void ElementTable::remove(std::uint32_t row)
{
    mRows[row] = ElementRow();
    mFree.push_back(row);
}

bool ElementTable::set(std::uint32_t row, const ElementRow &content)
{
    if (mRows[row] == content)
        return false;
    mRows[row] = content;
    mChanged.push_back(row);
    return true;
}

Result<void> ElementTable::upload()
{
    constexpr std::uint32_t nearby = 16; // rows it is cheaper to send along than to begin anew
    if (!mBuffer)
        mBuffer = GlBuffer::create();
    glBindBuffer(GL_COPY_WRITE_BUFFER, mBuffer.name());
    if (mRows.size() > mCapacity || mCapacity == 0) {
        mCapacity = std::max<std::size_t>({mRows.size(), mCapacity * 3 / 2, 256});
        glBufferData(GL_COPY_WRITE_BUFFER, GLsizeiptr(mCapacity * sizeof(ElementRow)), nullptr,
                     GL_DYNAMIC_DRAW);
        if (!mRows.empty())
            glBufferSubData(GL_COPY_WRITE_BUFFER, 0, GLsizeiptr(mRows.size() * sizeof(ElementRow)),
                            mRows.data());
        mBytesWritten += mRows.size() * sizeof(ElementRow);
        mChanged.clear();
        return checkGl("Uploading the painting");
    }
    std::sort(mChanged.begin(), mChanged.end());
    for (std::size_t i = 0; i < mChanged.size();) {
        const std::uint32_t first = mChanged[i];
        std::uint32_t last = first;
        while (i < mChanged.size() && mChanged[i] <= last + nearby)
            last = mChanged[i++];
        const std::size_t bytes = (last - first + 1) * sizeof(ElementRow);
        glBufferSubData(GL_COPY_WRITE_BUFFER, GLintptr(first * sizeof(ElementRow)), GLsizeiptr(bytes),
                        &mRows[first]);
        mBytesWritten += bytes;
    }
    mChanged.clear();
    return {};
}

void ElementTable::bind() const
{
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, mBuffer.name());
}

} // namespace ductus
