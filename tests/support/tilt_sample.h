// data.sketch of a .tilt, made here from the description of the format.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>

namespace ductus {

struct TiltStroke
{
    std::int32_t brush = 0;
    float red = 1;
    float size = 2;
    std::uint32_t strokeMask = 0;
    std::string extras; // what the bits of strokeMask announce
    std::uint32_t pointMask = 3;
    std::int32_t points = 3;
};

template <typename T>
std::string tiltBytes(T value)
{
    std::string raw(sizeof(T), '\0');
    std::memcpy(raw.data(), &value, sizeof(T));
    return raw;
}

inline std::string tiltHeader(std::int32_t strokes)
{
    return tiltBytes(0xC576A5CDu) + tiltBytes(5) + tiltBytes(0) + tiltBytes(4) + "more" + tiltBytes(strokes);
}

/// Points (i, 2, 3), no turn, pressure 0.5, time 1000 i.
inline std::string tiltStroke(const TiltStroke &stroke)
{
    std::string bytes = tiltBytes(stroke.brush);
    for (const float channel : {stroke.red, 0.5f, 0.f, 1.f})
        bytes += tiltBytes(channel);
    bytes += tiltBytes(stroke.size) + tiltBytes(stroke.strokeMask) + tiltBytes(stroke.pointMask) +
             stroke.extras + tiltBytes(stroke.points);
    for (std::int32_t i = 0; i < stroke.points; ++i) {
        for (const float value : {float(i), 2.f, 3.f, 0.f, 0.f, 0.f, 1.f})
            bytes += tiltBytes(value);
        for (std::uint32_t bit = 1; bit != 0; bit <<= 1)
            if (stroke.pointMask & bit)
                bytes += bit == 1 ? tiltBytes(0.5f) : tiltBytes(std::uint32_t(1000 * i));
    }
    return bytes;
}

/// Two strokes in two layers, the second with every known extra and one unknown of each kind.
inline std::string tiltSketch()
{
    TiltStroke full;
    full.brush = 1;
    full.strokeMask = 1 | 2 | 4 | 8 | 16 | 32 | 1 << 20;
    full.extras = tiltBytes(9u) + tiltBytes(3.f) + tiltBytes(7u) + tiltBytes(5u) + tiltBytes(1u) +
                  tiltBytes(4u) + tiltBytes(3u) + "abc";
    full.pointMask = 3 | 1 << 9;
    return tiltHeader(2) + tiltStroke({}) + tiltStroke(full);
}

inline std::string tiltMetadata()
{
    return "{\"BrushIndex\":[\"aaaa\",\"bbbb\"],\"Layers\":[{\"Name\":\"Ground\"},"
           "{\"Name\":\"Sky\",\"Visible\":false}]}";
}

} // namespace ductus
