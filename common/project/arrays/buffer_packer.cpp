#include "project/arrays/buffer_packer.h"

#include "base/sha256.h"

namespace ductus {

namespace {

constexpr std::size_t fullBuffer = 1 << 20; // a change of one stroke rewrites about this much
constexpr std::size_t alignment = 8;

} // namespace

BufferPacker::Handle BufferPacker::addBytes(ArrayReference reference, std::span<const std::byte> bytes)
{
    if (!mOpen.empty() && mOpen.size() + bytes.size() > fullBuffer)
        startBuffer();
    mOpen.resize((mOpen.size() + alignment - 1) / alignment * alignment);
    reference.offset = mOpen.size();
    mOpen.insert(mOpen.end(), bytes.begin(), bytes.end());
    mReferences.push_back(std::move(reference));
    return mReferences.size() - 1;
}

void BufferPacker::startBuffer()
{
    if (mFirstOpen == mReferences.size())
        return;
    const std::string hash = sha256Hex(mOpen);
    for (; mFirstOpen < mReferences.size(); ++mFirstOpen)
        mReferences[mFirstOpen].buffer = hash;
    mBuffers.emplace(hash, std::move(mOpen));
    mOpen.clear();
}

} // namespace ductus
