// A document without a file kind of its own: three numbers under undo.
#pragma once

#include "document/document.h"

namespace ductus {

class GalleryDocument : public Document
{
    Q_OBJECT
public:
    using Document::Document;

    double tightness() const { return mTightness; }
    /// As an undo step; those of one \a drag merge.
    void changeTightness(double value, quint64 drag);
    void applyTightness(double value);

protected:
    Result<void> readFrom(const Project &project) override;
    void writeTo(Project &project) const override;
    void clear() override;

private:
    double mTightness = 0.4;
};

struct TightnessChanged : ChangeEvent
{
    double value = 0.0;
};

} // namespace ductus
