// Quill projects made here, byte by byte, from the description of the format: what readers are tested with.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace ductus {

/// Quill.qbin while it grows.
class QuillData
{
public:
    QuillData() { append<std::uint64_t>(0); }

    template <typename T>
    void append(T value)
    {
        char raw[sizeof(T)];
        std::memcpy(raw, &value, sizeof(T));
        bytes.append(raw, sizeof(T));
    }

    /// A drawing of one stroke from (0, 0, first) along z; the place of its beginning.
    std::uint64_t addDrawing(int brush, int points, float first, int strokes = 1)
    {
        const std::uint64_t place = bytes.size();
        append<std::uint32_t>(std::uint32_t(strokes));
        for (int s = 0; s < strokes; ++s)
            addStroke(brush, points, first, s);
        return place;
    }

    /// An RGB picture; the place of its beginning.
    std::uint64_t addPicture(std::uint32_t width, std::uint32_t height)
    {
        const std::uint64_t place = bytes.size();
        bytes.append("\0\0\0\1\2\6\0\0", 8);
        append(width);
        append(height);
        append<std::uint32_t>(1);
        for (std::uint32_t i = 0; i < width * height * 3; ++i)
            append(std::uint8_t(i * 7));
        return place;
    }

    std::string bytes;

private:
    void addStroke(int brush, int points, float first, int id)
    {
        append<std::uint32_t>(std::uint32_t(id));
        append<std::uint32_t>(0);
        for (int i = 0; i < 6; ++i)
            append(i % 2 == 0 ? 1e20f : -1e20f); // a box of no use, as real files have
        append<std::int16_t>(std::int16_t(brush));
        append<std::uint8_t>(id % 2 == 0 ? 1 : 0);
        append<std::uint8_t>(0);
        append<std::uint32_t>(std::uint32_t(points));
        for (int i = 0; i < points; ++i) {
            const bool isEnd = i == 0 || i == points - 1;
            const float values[14] = {float(id), 0, first + float(i),    0, 1, 0, 0, 0, -1, 0.25f, 0.5f,
                                      0.75f,     1, isEnd ? 0.f : 0.125f};
            for (const float value : values)
                append(value);
        }
    }
};

inline std::string quillHex(std::uint64_t offset)
{
    static const char digits[] = "0123456789abcdef";
    std::string text(16, '0');
    for (int i = 15; i >= 0; --i, offset >>= 4)
        text[std::size_t(i)] = digits[offset & 15];
    return text;
}

/// A layer's text; \a implementation without its braces, \a more further members with a comma before.
inline std::string quillLayerText(const std::string &name, const std::string &type,
                                  const std::string &implementation, const std::string &more = "")
{
    return "{\"Name\":\"" + name + "\",\"Visible\":true,\"Type\":\"" + type + "\"" + more +
           ",\"Implementation\":{" + implementation + "}}";
}

inline std::string quillDrawingsText(const std::vector<std::uint64_t> &offsets, const std::string &frames)
{
    std::string text = "\"Framerate\":12,\"MaxRepeatCount\":0,\"Drawings\":[";
    for (std::size_t i = 0; i < offsets.size(); ++i)
        text +=
            (i ? "," : "") + ("{\"BoundingBox\":[1e20,-1e20,1e20,-1e20,1e20,-1e20],\"DataFileOffset\":\"" +
                              quillHex(offsets[i]) + "\"}");
    return text + "],\"Frames\":[" + frames + "]";
}

/// A whole Quill.json around the layers below the root.
inline std::string quillSceneText(const std::string &children)
{
    return "{\"Version\":1,\"Sequence\":{\"Metadata\":{\"Title\":\"Sample\"},\n"
           "\"BackgroundColor\":[0.5,0.25,1],\"Framerate\":24,\n\"RootLayer\":" +
           quillLayerText("Root", "Group", "\"Children\":[\n" + children + "]") + "}}\n";
}

struct QuillSample
{
    std::string json;
    std::string qbin;
};

/// One of everything: nested groups, a flip, keys, the four brushes, frames out of order with an unused
/// drawing, a picture, a sound.
inline QuillSample quillSample()
{
    QuillData data;
    const std::uint64_t picture = data.addPicture(3, 2);
    const std::uint64_t still = data.addDrawing(2, 5, 0, 2);
    std::vector<std::uint64_t> frames;
    for (int i = 0; i < 4; ++i)
        frames.push_back(data.addDrawing(i + 1, 3, float(10 * i)));
    const std::string moved =
        ",\"Opacity\":0.5,\"Transform\":{\"Rotation\":[0,0.7071067811865476,0,0.7071067811865476],\"Scale\":"
        "2,"
        "\"Flip\":\"X\",\"Translation\":[1,2,3]},\"Animation\":{\"Duration\":\"25200\",\"Timeline\":true,"
        "\"StartOffset\":12600,\"MaxRepeatCount\":\"3\",\"Keys\":{\"Visibility\":[{\"Time\":\"0\",\"Value\":"
        "false,"
        "\"Interpolation\":\"None\"}],\"Opacity\":[{\"Time\":\"6300\",\"Value\":0.5,\"Interpolation\":"
        "\"Linear\"}],"
        "\"Transform\":[{\"Time\":\"12600\",\"Value\":{\"Rotation\":[0,0,0,1],\"Scale\":3,\"Flip\":\"N\","
        "\"Translation\":[0,1,0]},\"Interpolation\":\"Smoothstep\"},{\"Time\":0,\"Value\":{},"
        "\"Interpolation\":\"EaseIn\"}]}}";
    const std::string children =
        quillLayerText("Still", "Paint", quillDrawingsText({still}, "\"0\"")) + ",\n" +
        quillLayerText("Moved", "Group",
                       "\"Children\":[" +
                           quillLayerText("Frames", "Paint", quillDrawingsText(frames, "3,\"0\",0.0,\"2\"")) +
                           "]",
                       moved) +
        ",\n" +
        quillLayerText("Reference", "Picture",
                       "\"Type\":\"2D\",\"DataFileOffset\":\"" + quillHex(picture) + "\"") +
        ",\n" + quillLayerText("Music", "Sound", "\"Gain\":1");
    return {quillSceneText(children), data.bytes};
}

} // namespace ductus
