#include "support/clip_thing.h"

namespace ductus {

Shot madeShot(const ThingShot &thing)
{
    Shot shot;
    shot.width = shot.clipWidth = thing.width;
    shot.height = shot.clipHeight = thing.height;
    shot.cameras.assign(std::size_t(thing.frames), ShotCamera{});
    for (int t = 0; t < thing.frames; ++t) {
        Image image(thing.width, thing.height);
        for (int y = 0; y < thing.height; ++y)
            for (int x = 0; x < thing.width; ++x)
                image.set(x, y, thing.colour(t, x, y));
        shot.pictures.push_back(smallPictureOf(image));
        if (t + 1 == thing.frames)
            break;
        FlowField ahead{thing.width / 4, thing.height / 4, 4.0, {}, {}}, back = ahead;
        const float told = thing.toldSpeed(t), sure = thing.confidence ? thing.confidence(t) : 1.0f;
        const auto add = [](FlowField &flow, bool isThing, float motion, float confidence) {
            flow.motions.emplace_back(isThing ? motion : 0.0f, 0.0f);
            flow.confidences.push_back(isThing ? confidence : 1.0f);
        };
        for (int i = 0; i < ahead.width * ahead.height; ++i) {
            const double x = 4.0 * (i % ahead.width) + 2.0, y = 4.0 * (i / ahead.width) + 2.0;
            add(ahead, thing.isThing(t, x, y), told, sure);
            add(back, thing.isThing(t + 1, x, y), -told, sure);
        }
        shot.forward.push_back(ahead);
        shot.backward.push_back(back);
    }
    return shot;
}

} // namespace ductus
