#include "layerpainter/ui/point/point_colours.h"

namespace ductus {

void PointColours::ask(std::shared_ptr<const Painting> painting, double timeSeconds, const Vec3 &eye,
                       const Vec3 &ray, std::function<void(Result<std::optional<ColouredPoint>>)> found)
{
    Ready ready;
    if (mReady.painting == painting && mReady.timeSeconds == timeSeconds)
        ready = mReady;
    const auto work = [painting, timeSeconds, eye, ray, ready](const JobControl &control) -> Result<Answer> {
        Answer answer{ready, {}};
        if (!ready.solid) {
            Result<PaintingSolid> solid = PaintingSolid::make(*painting, {timeSeconds, {}}, control);
            if (!solid)
                return solid.error();
            answer.ready = {painting, timeSeconds, std::make_shared<const PaintingSolid>(std::move(*solid))};
        }
        const PaintingSolid &solid = *answer.ready.solid;
        std::vector<SubstratePoint> points;
        solid.surfaces(eye, ray, 0, points);
        if (points.empty())
            return answer;
        const BlendSpace space = painting->blendSpace;
        answer.point = ColouredPoint{points.front(),
                                     fromBlendSpace(space, solid.colour(points.front(), &ray)).cast<float>(),
                                     solid.coloursAt(points.front(), &ray), space};
        return answer;
    };
    mJobs.start<Answer>({QStringLiteral("point-colours"), tr("Looking which layers colour this"), true}, this,
                        work, [this, found](Result<Answer> answer) {
                            if (!answer) {
                                found(answer.error());
                                return;
                            }
                            mReady = answer->ready;
                            found(std::move(answer->point));
                        });
}

} // namespace ductus
