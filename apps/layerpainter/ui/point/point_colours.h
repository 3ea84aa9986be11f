// PointColours: asks which layers colour what is seen at a place of the canvas; in the background, as large
// paintings take seconds to be made ready.
#pragma once

#include "document/jobs/job_runner.h"
#include "painting/reference/painting_solid.h"

#include <functional>

namespace ductus {

struct ColouredPoint
{
    SubstratePoint point;
    Eigen::Vector3f colour = Eigen::Vector3f::Zero(); // of the opaque surface with all layers, linear RGB
    std::vector<LayerColouring> layers;               // top to bottom
    BlendSpace blendSpace = BlendSpace::Encoded;      // of their colours
};

class PointColours : public QObject
{
    Q_OBJECT
public:
    explicit PointColours(JobRunner &jobs, QObject *parent = nullptr) : QObject(parent), mJobs(jobs) {}

    /// \a found gets nothing for a ray that meets nothing. A further question drops the one before.
    void ask(std::shared_ptr<const Painting> painting, double timeSeconds, const Vec3 &eye, const Vec3 &ray,
             std::function<void(Result<std::optional<ColouredPoint>>)> found);

private:
    struct Ready
    {
        std::shared_ptr<const Painting> painting;
        double timeSeconds = 0;
        std::shared_ptr<const PaintingSolid> solid;
    };
    struct Answer
    {
        Ready ready;
        std::optional<ColouredPoint> point;
    };

    JobRunner &mJobs;
    Ready mReady; // kept until the painting is another
};

} // namespace ductus
