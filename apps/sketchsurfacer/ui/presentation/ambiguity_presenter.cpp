#include "sketchsurfacer/ui/presentation/ambiguity_presenter.h"

namespace ductus {

namespace {

constexpr std::size_t mostKept = 8;
const QString jobKey = QStringLiteral("ambiguity");

using AmbiguityPointer = std::shared_ptr<const AmbiguityView>;

} // namespace

AmbiguityPresenter::AmbiguityPresenter(SketchDocument &document, JobRunner &runner,
                                       SketchPresenter &presenter, SketchView &view, QObject *parent)
    : QObject(parent), mDocument(document), mRunner(runner), mPresenter(presenter), mView(view)
{
    connect(&presenter, &SketchPresenter::resultShown, this, &AmbiguityPresenter::onResult);
    connect(&document, &Document::changed, this, [this](const ChangeEvent &event) {
        // The surface is going to be another: the processor belongs to it.
        if (event.as<SketchChanged>())
            mRunner.cancelKey(jobKey);
    });
    ColourLegend legend;
    legend.title = tr("What the sketch leaves open");
    legend.low = tr("clear");
    legend.high = tr("open");
    for (int i = 0; i <= 16; ++i)
        legend.colours.push_back(ambiguityColour(i / 16.0));
    view.overlay().setAmbiguityLegend(legend);
}

bool AmbiguityPresenter::canLook() const
{
    const std::shared_ptr<const ResultView> result = mPresenter.resultView();
    return result && !result->isPreview && result->state->hasLabels() && mDocument.isUpToDate();
}

void AmbiguityPresenter::setOn(bool on)
{
    if (on == mIsOn)
        return;
    mIsOn = on;
    if (!on)
        mRunner.cancelKey(jobKey);
    mView.setAmbiguityShown(on);
    onResult();
    emit changed();
}

void AmbiguityPresenter::onResult()
{
    const std::shared_ptr<const ResultView> result = mPresenter.resultView();
    if (mShown && mShown->of != result)
        adopt(nullptr);
    if (!mIsOn || !canLook() || mRunning == result || (mShown && mShown->of == result))
        return;
    for (const AmbiguityPointer &kept : mKept)
        if (kept->of == result) {
            adopt(kept);
            return;
        }
    ReadingPictureOptions pictures;
    pictures.towardsEye = -mView.camera().forward();
    if (!mView.isDark())
        pictures.background = {250, 251, 252, 255};
    auto work = [result, pictures, up = mDocument.strokes().upAxis](const JobControl &control) {
        return makeAmbiguityView(result, up, pictures, control);
    };
    auto finish = [this, result](Result<AmbiguityPointer> view) {
        if (mRunning == result)
            mRunning = nullptr;
        if (view) {
            mKept.push_back(*view);
            if (mKept.size() > mostKept)
                mKept.pop_front();
            if (mPresenter.resultView() == result && mIsOn)
                adopt(*view);
        } else if (!view.error().isCancelled()) {
            emit failed(view.error());
        }
        emit changed();
    };
    mRunning = result;
    mRunner.start<AmbiguityPointer>({jobKey, tr("Looking for other readings")}, this, work, finish);
    emit changed();
}

void AmbiguityPresenter::adopt(AmbiguityPointer view)
{
    mShown = std::move(view);
    mView.setMesh(SceneItem::Ambiguity, mShown ? mShown->mesh : ViewMesh());
    emit changed();
}

std::optional<double> AmbiguityPresenter::valueAt(const RayHit &hit) const
{
    if (!mShown || mView.pickMesh().mesh != mShown->mesh.mesh || hit.triangle < 0 ||
        hit.triangle >= mShown->mesh.mesh->triangleCount())
        return std::nullopt;
    double value = 0.0;
    for (int corner : mShown->mesh.mesh->triangles[std::size_t(hit.triangle)])
        value += mShown->values[std::size_t(corner)] / 3.0;
    return value;
}

void AmbiguityPresenter::choose(int reading)
{
    if (mShown && reading >= 0 && reading < int(mShown->readings.size()) &&
        mShown->of == mPresenter.resultView() && mDocument.isUpToDate())
        mDocument.chooseReading(mShown->readings[std::size_t(reading)].labelled);
}

} // namespace ductus
