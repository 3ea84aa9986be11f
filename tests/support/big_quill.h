// Quill projects as large as painters make them, written piece by piece to the disk: tens of thousands of
// strokes and a Quill.qbin of gigabytes, most of it old drawings that nothing refers to any more (Quill only
// ever adds).
#pragma once

#include "support/quill_sample.h"

#include <cmath>
#include <filesystem>
#include <fstream>

namespace ductus {

struct BigQuill
{
    std::uint64_t qbinBytes = 0;
    std::uint64_t jsonBytes = 0;
    int layers = 0;
    std::int64_t points = 0;
};

/// Fields of grass: layers of up to 500 blades with \a pointsPerStroke points each. \a leastBytes of
/// Quill.qbin are made up by orphans between the drawings.
inline BigQuill writeBigQuill(const std::filesystem::path &folder, int strokes, int pointsPerStroke,
                              std::uint64_t leastBytes)
{
    constexpr int strokesPerLayer = 500;
    BigQuill made;
    made.layers = (strokes + strokesPerLayer - 1) / strokesPerLayer;
    made.points = std::int64_t(strokes) * pointsPerStroke;
    std::filesystem::create_directories(folder);
    std::ofstream qbin(folder / "Quill.qbin", std::ios::binary);
    std::uint64_t at = 8;
    qbin.write("\0\0\0\0\0\0\0\0", 8);
    const std::uint64_t live = std::uint64_t(made.points) * 56 + std::uint64_t(strokes) * 40;
    const std::uint64_t orphan = leastBytes > live ? (leastBytes - live) / std::uint64_t(made.layers) + 1 : 0;
    const std::string rubbish(1 << 20, '\x7f');
    std::string children;
    int stroke = 0;
    for (int layer = 0; layer < made.layers; ++layer) {
        for (std::uint64_t left = orphan; left > 0;) {
            const std::uint64_t piece = std::min<std::uint64_t>(left, rubbish.size());
            qbin.write(rubbish.data(), std::streamsize(piece));
            left -= piece;
            at += piece;
        }
        const int count = std::min(strokesPerLayer, strokes - stroke);
        QuillData data; // its own header is cut off
        data.append<std::uint32_t>(std::uint32_t(count));
        for (int s = 0; s < count; ++s, ++stroke) {
            data.append<std::uint32_t>(std::uint32_t(stroke));
            data.append<std::uint32_t>(0);
            for (int i = 0; i < 6; ++i)
                data.append(0.f);
            data.append<std::int16_t>(std::int16_t(1 + stroke % 4));
            data.append<std::uint16_t>(1);
            data.append<std::uint32_t>(std::uint32_t(pointsPerStroke));
            // Blades stand on a spiral, so that they cover a round field evenly.
            const float radius = 0.08f * std::sqrt(float(stroke)), angle = 2.399963f * float(stroke);
            const float x = radius * std::cos(angle), z = radius * std::sin(angle);
            for (int p = 0; p < pointsPerStroke; ++p) {
                const float t = float(p) / float(pointsPerStroke - 1);
                const bool isEnd = p == 0 || p == pointsPerStroke - 1;
                const float values[14] = {x + 0.3f * t * t * std::cos(7 * angle),
                                          0.8f * t,
                                          z + 0.3f * t * t * std::sin(7 * angle),
                                          0,
                                          0,
                                          1,
                                          0,
                                          0,
                                          -1,
                                          0.05f + 0.2f * t,
                                          0.15f + 0.4f * t,
                                          0.05f,
                                          1,
                                          isEnd ? 0.f : 0.03f * (1 - 0.8f * t)};
                for (const float value : values)
                    data.append(value);
            }
        }
        const std::string bytes = data.bytes.substr(8);
        children += (layer > 0 ? ",\n" : "") + quillLayerText("Field " + std::to_string(layer + 1), "Paint",
                                                              quillDrawingsText({at}, "\"0\""));
        qbin.write(bytes.data(), std::streamsize(bytes.size()));
        at += bytes.size();
    }
    qbin.close();
    const std::string json = quillSceneText(children);
    std::ofstream(folder / "Quill.json", std::ios::binary) << json;
    made.qbinBytes = at;
    made.jsonBytes = json.size();
    return made;
}

} // namespace ductus
