#include "formats/paintings/object_stream.h"

#include <algorithm>
#include <istream>
#include <streambuf>

namespace ductus {

using Json = nlohmann::json;

namespace {

constexpr std::size_t deepest = 600; // three levels a group

/// What the parser reads characters from.
class SourceBuffer : public std::streambuf
{
public:
    explicit SourceBuffer(ByteSource &source) : mSource(source) {}

    const std::optional<Error> &failure() const { return mFailure; }
    double fraction() const { return mSource.size() ? double(mOffset) / double(mSource.size()) : 1.0; }

protected:
    int_type underflow() override
    {
        const auto count = std::size_t(std::min<std::uint64_t>(sizeof(mBytes), mSource.size() - mOffset));
        if (count == 0 || mFailure)
            return traits_type::eof();
        const Result<void> done = mSource.read(mOffset, std::as_writable_bytes(std::span(mBytes, count)));
        if (!done) {
            mFailure = done.error();
            return traits_type::eof();
        }
        mOffset += count;
        setg(mBytes, mBytes, mBytes + count);
        return traits_type::to_int_type(mBytes[0]);
    }

private:
    ByteSource &mSource;
    std::uint64_t mOffset = 0;
    std::optional<Error> mFailure;
    char mBytes[1 << 16];
};

/// Builds the value; the functions are the events of nlohmann's parser, false stops it.
class Builder
{
public:
    // Names the parser's interface demands.
    using number_integer_t = Json::number_integer_t;
    using number_unsigned_t = Json::number_unsigned_t;
    using number_float_t = Json::number_float_t;
    using string_t = Json::string_t;
    using binary_t = Json::binary_t;

    Builder(const ObjectStreamHooks &hooks, const SourceBuffer &buffer, std::string attempted,
            const JobControl &control)
        : mHooks(hooks), mBuffer(buffer), mAttempted(std::move(attempted)), mControl(control)
    {
    }

    bool null() { return put(nullptr); }
    bool boolean(bool value) { return put(value); }
    bool number_integer(number_integer_t value) { return put(value); }
    bool number_unsigned(number_unsigned_t value) { return put(value); }
    bool number_float(number_float_t value, const string_t &) { return put(value); }
    bool string(string_t &value) { return put(std::move(value)); }
    bool binary(binary_t &value) { return put(std::move(value)); }
    bool start_object(std::size_t) { return open(Json::object()); }
    bool start_array(std::size_t) { return open(Json::array()); }
    bool end_array() { return close(); }

    bool key(string_t &name)
    {
        mSlot = &(*mOpen.back())[name];
        return true;
    }

    bool end_object()
    {
        if (mHooks.objectComplete && (error = mHooks.objectComplete(*mOpen.back())))
            return false;
        return close();
    }

    bool parse_error(std::size_t position, const std::string &, const nlohmann::detail::exception &exception)
    {
        syntaxErrorAt = position;
        isNumberTooLarge = exception.id == 406;
        return false;
    }

    Json root;
    std::optional<Error> error;
    std::optional<std::size_t> syntaxErrorAt;
    bool isNumberTooLarge = false;
    bool isTooDeep = false;

private:
    Json *put(Json &&value, int)
    {
        if (mOpen.empty())
            return &(root = std::move(value));
        if (mOpen.back()->is_array()) {
            mOpen.back()->push_back(std::move(value));
            return &mOpen.back()->back();
        }
        return &(*mSlot = std::move(value));
    }

    bool put(Json value)
    {
        put(std::move(value), 0);
        return tick();
    }

    bool open(Json value)
    {
        if (mOpen.size() >= deepest) {
            isTooDeep = true;
            return false;
        }
        mOpen.push_back(put(std::move(value), 0));
        return tick();
    }

    bool close()
    {
        mOpen.pop_back();
        return true;
    }

    bool tick()
    {
        if (++mEvents % 65536 != 0)
            return true;
        mControl.progress(mBuffer.fraction(), mAttempted);
        if (mControl.isCancelled())
            error = cancelledError(mAttempted);
        return !error;
    }

    const ObjectStreamHooks &mHooks;
    const SourceBuffer &mBuffer;
    std::string mAttempted;
    const JobControl &mControl;
    std::vector<Json *> mOpen; // an element of an open array does not move before the array is closed
    Json *mSlot = nullptr;
    std::uint64_t mEvents = 0;
};

std::string lineAt(ByteSource &text, std::size_t position)
{
    std::uint64_t line = 1;
    std::vector<char> piece(1 << 16);
    const std::uint64_t end = std::min<std::uint64_t>(position > 0 ? position - 1 : 0, text.size());
    for (std::uint64_t offset = 0; offset < end; offset += piece.size()) {
        const auto count = std::size_t(std::min<std::uint64_t>(piece.size(), end - offset));
        if (!text.read(offset, std::as_writable_bytes(std::span(piece).first(count))))
            return text.place(position);
        line += std::uint64_t(std::count(piece.begin(), piece.begin() + std::ptrdiff_t(count), '\n'));
    }
    return text.name() + ":" + std::to_string(line);
}

} // namespace

Json takenOut(std::uint64_t number)
{
    return Json::binary({}, number);
}

std::optional<std::uint64_t> takenOutNumber(const Json &value)
{
    if (!value.is_binary())
        return std::nullopt;
    return value.get_binary().subtype();
}

Result<Json> readObjectStream(ByteSource &text, const ObjectStreamHooks &hooks, const std::string &attempted,
                              const JobControl &control)
{
    SourceBuffer buffer(text);
    std::istream stream(&buffer);
    Builder builder(hooks, buffer, attempted, control);
    const bool ok = Json::sax_parse(stream, &builder);
    if (buffer.failure())
        return *buffer.failure();
    if (builder.error)
        return *builder.error;
    if (builder.isTooDeep)
        return Error{ErrorCode::Malformed, attempted, "its groups are nested too deeply",
                     "Take some groups out of their groups and export it again", text.name()};
    if (builder.isNumberTooLarge)
        return Error{ErrorCode::Malformed, attempted, "a number there is beyond all bounds",
                     "Replace it by a usual one in a text editor", lineAt(text, *builder.syntaxErrorAt)};
    if (!ok)
        return Error{
            ErrorCode::Malformed, attempted,
            "this is not valid JSON (early programs wrote inf or nan for numbers; files can also be cut "
            "off)",
            "Export it again, or mend that line in a text editor",
            lineAt(text, builder.syntaxErrorAt.value_or(0))};
    return std::move(builder.root);
}

} // namespace ductus
