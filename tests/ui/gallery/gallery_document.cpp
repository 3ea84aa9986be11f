#include "ui/gallery/gallery_document.h"

#include "document/commands/change_value.h"

namespace ductus {

namespace {

struct ChangeTightness : ChangeValue<GalleryDocument *, double>
{
    using ChangeValue::ChangeValue;
    double get(GalleryDocument *const &document) const override { return document->tightness(); }
    void set(GalleryDocument *const &document, const double &value) override
    {
        document->applyTightness(value);
    }
};

} // namespace

void GalleryDocument::changeTightness(double value, quint64 drag)
{
    undoStack()->push(new ChangeTightness(tr("Change tightness"), 1, this, value, drag));
}

void GalleryDocument::applyTightness(double value)
{
    mTightness = value;
    TightnessChanged event;
    event.value = value;
    emit changed(event);
}

Result<void> GalleryDocument::readFrom(const Project &)
{
    return {};
}

void GalleryDocument::writeTo(Project &) const {}

void GalleryDocument::clear()
{
    mTightness = 0.4;
}

} // namespace ductus
