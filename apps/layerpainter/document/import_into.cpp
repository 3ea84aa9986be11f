#include "layerpainter/document/import_into.h"

#include "painting/scene/element_placement.h"

namespace ductus {

AddedImport addImported(PaintingDocument &document, const ImportedFile &file)
{
    AddedImport added;
    const ElementPlacements placements(file.painting, 0);
    document.undoStack()->beginMacro(PaintingDocument::tr("Add %1").arg(QString::fromStdString(file.name)));
    for (const Stack &stack : file.painting.stacks) {
        const Layer &substrate = *stack.substrate;
        const auto made = document.perform(act::AddStack{stack.name});
        if (!made)
            break;
        ++added.stacks;
        // Strokes of one layer mostly stand at one place: an action for each row of those that do.
        act::Draw draw;
        draw.layer = LayerId{made->at(1)};
        const auto flush = [&] {
            if (!draw.strokes.empty() && document.perform(draw))
                added.strokes += int(draw.strokes.size());
            draw.strokes.clear();
        };
        for (const Element &element : substrate.drawingAt(placements.timeSeconds()).elements) {
            const Placement place = placements.sceneFromElement(substrate, element);
            if (!(place == draw.placement))
                flush();
            draw.placement = place;
            draw.strokes.push_back(element.shape);
        }
        flush();
        LayerProperties properties = substrate.properties;
        if (!properties.visible || properties.opacity < 1) {
            act::SetProperties edit;
            edit.layer = draw.layer;
            edit.visible = properties.visible;
            edit.opacity = properties.opacity;
            (void)document.perform(edit);
        }
        added.leftFramesOut = added.leftFramesOut || substrate.drawings.size() > 1;
    }
    document.undoStack()->endMacro();
    return added;
}

} // namespace ductus
