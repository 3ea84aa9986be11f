// AmbiguityPresenter: while it is on, every new surface is asked in the background what it leaves open; the
// answer colours the view of the regions and offers other readings.
#pragma once

#include "sketchsurfacer/ui/presentation/ambiguity_view.h"
#include "sketchsurfacer/ui/presentation/sketch_presenter.h"

namespace ductus {

class AmbiguityPresenter : public QObject
{
    Q_OBJECT
public:
    /// All must outlive this.
    AmbiguityPresenter(SketchDocument &document, JobRunner &runner, SketchPresenter &presenter,
                       SketchView &view, QObject *parent = nullptr);

    void setOn(bool on);
    bool isOn() const { return mIsOn; }
    bool isRunning() const { return mRunning != nullptr; }
    /// Whether there is a surface that can be asked; not one from a file, of which only the mesh is known.
    bool canLook() const;
    /// Of the surface that is seen; null until it is known.
    std::shared_ptr<const AmbiguityView> shown() const { return mShown; }
    /// 0..1 at a place of the picked mesh; nothing where nothing is known.
    std::optional<double> valueAt(const RayHit &hit) const;
    /// Takes one of shown()->readings: an edit.
    void choose(int reading);

signals:
    void changed();
    void failed(const ductus::Error &error);

private:
    void onResult();
    void adopt(std::shared_ptr<const AmbiguityView> view);

    SketchDocument &mDocument;
    JobRunner &mRunner;
    SketchPresenter &mPresenter;
    SketchView &mView;
    std::deque<std::shared_ptr<const AmbiguityView>> mKept; // oldest first
    std::shared_ptr<const AmbiguityView> mShown;
    std::shared_ptr<const ResultView> mRunning; // being asked
    bool mIsOn = false;
};

} // namespace ductus
