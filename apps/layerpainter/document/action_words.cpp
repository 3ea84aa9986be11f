// What actions are called in the history, and what they may change.
#include "layerpainter/document/painting_document.h"

namespace ductus {

namespace {

QString strokes(const QString &one, const QString &many, std::size_t count)
{
    return count == 1 ? one : many.arg(count);
}

struct Words
{
    QString operator()(const act::AddStack &) const { return PaintingDocument::tr("Add stack"); }
    QString operator()(const act::RemoveStack &) const { return PaintingDocument::tr("Delete stack"); }
    QString operator()(const act::MoveStack &) const { return PaintingDocument::tr("Move stack"); }
    QString operator()(const act::RenameStack &) const { return PaintingDocument::tr("Rename stack"); }
    QString operator()(const act::AddLayer &) const { return PaintingDocument::tr("Add layer"); }
    QString operator()(const act::RemoveLayer &) const { return PaintingDocument::tr("Delete layer"); }
    QString operator()(const act::MoveLayer &) const { return PaintingDocument::tr("Move layer"); }
    QString operator()(const act::DuplicateLayer &) const { return PaintingDocument::tr("Duplicate layer"); }
    QString operator()(const act::RenameLayer &) const { return PaintingDocument::tr("Rename layer"); }
    QString operator()(const act::LockLayer &a) const
    {
        return a.locked ? PaintingDocument::tr("Lock layer") : PaintingDocument::tr("Unlock layer");
    }
    QString operator()(const act::SetProperties &a) const
    {
        if (a.visible)
            return *a.visible ? PaintingDocument::tr("Show layer") : PaintingDocument::tr("Hide layer");
        if (a.opacity)
            return PaintingDocument::tr("Change opacity");
        if (a.blend)
            return PaintingDocument::tr("Change blend mode");
        if (a.masks)
            return PaintingDocument::tr("Change masks");
        return PaintingDocument::tr("Change layer colour");
    }
    QString operator()(const act::SetTolerance &) const { return PaintingDocument::tr("Change tolerance"); }
    QString operator()(const act::SetLayerMotion &) const
    {
        return PaintingDocument::tr("Move layer in time");
    }
    QString operator()(const act::Draw &) const { return PaintingDocument::tr("Paint"); }
    QString operator()(const act::Erase &a) const
    {
        return strokes(PaintingDocument::tr("Delete stroke"), PaintingDocument::tr("Delete %1 strokes"),
                       a.elements.size());
    }
    QString operator()(const act::Cut &) const { return PaintingDocument::tr("Erase"); }
    QString operator()(const act::MoveElements &a) const
    {
        return strokes(PaintingDocument::tr("Move stroke to layer"),
                       PaintingDocument::tr("Move %1 strokes to layer"), a.elements.size());
    }
    QString operator()(const act::Duplicate &a) const
    {
        return strokes(PaintingDocument::tr("Duplicate stroke"), PaintingDocument::tr("Duplicate %1 strokes"),
                       a.elements.size());
    }
    QString operator()(const act::Transform &a) const
    {
        return strokes(PaintingDocument::tr("Move stroke"), PaintingDocument::tr("Move %1 strokes"),
                       a.elements.size());
    }
    QString operator()(const act::Recolour &a) const
    {
        return strokes(PaintingDocument::tr("Recolour stroke"), PaintingDocument::tr("Recolour %1 strokes"),
                       a.elements.size());
    }
    QString operator()(const act::ReplaceShape &) const { return PaintingDocument::tr("Update surface"); }
    QString operator()(const act::AddLook &) const { return PaintingDocument::tr("Add look"); }
    QString operator()(const act::UpdateLook &) const { return PaintingDocument::tr("Update look"); }
    QString operator()(const act::ApplyLook &) const { return PaintingDocument::tr("Switch look"); }
    QString operator()(const act::RenameLook &) const { return PaintingDocument::tr("Rename look"); }
    QString operator()(const act::RemoveLook &) const { return PaintingDocument::tr("Delete look"); }
    QString operator()(const act::SetScene &) const { return PaintingDocument::tr("Change scene"); }
    QString operator()(const act::SetCamera &) const { return PaintingDocument::tr("Change camera path"); }
    QString operator()(const act::AddGroup &) const { return PaintingDocument::tr("Add motion group"); }
    QString operator()(const act::SetGroupMotion &) const { return PaintingDocument::tr("Change motion"); }
    QString operator()(const act::RemoveGroup &) const { return PaintingDocument::tr("Delete motion group"); }
};

} // namespace

QString actionText(const PaintingAction &action)
{
    return std::visit(Words(), action);
}

PaintingChanged changeOf(const PaintingAction &action)
{
    PaintingChanged change;
    const auto is = [&]<typename... Kinds>() { return (std::holds_alternative<Kinds>(action) || ...); };
    change.layers = is.operator()<act::AddStack, act::RemoveStack, act::MoveStack, act::RenameStack,
                                  act::AddLayer, act::RemoveLayer, act::MoveLayer, act::DuplicateLayer,
                                  act::RenameLayer, act::LockLayer>();
    change.elements = is.operator()<act::RemoveStack, act::RemoveLayer, act::MoveLayer, act::DuplicateLayer,
                                    act::Draw, act::Erase, act::Cut, act::MoveElements, act::Duplicate,
                                    act::Transform, act::Recolour, act::ReplaceShape>();
    change.properties = is.operator()<act::SetProperties, act::SetTolerance, act::ApplyLook>();
    change.looks =
        is.operator()<act::AddLook, act::UpdateLook, act::ApplyLook, act::RenameLook, act::RemoveLook>();
    change.scene = is.operator()<act::SetScene, act::SetCamera, act::SetLayerMotion, act::AddGroup,
                                 act::SetGroupMotion, act::RemoveGroup>();
    return change;
}

} // namespace ductus
