#include "layerpainter/document/surface_update.h"

#include <QFile>

namespace ductus {

LinkQuestion linkQuestion(const PaintingDocument &document)
{
    return {document.sharedPainting(), document.project(), enginePath(document.filePath())};
}

std::vector<SurfaceLink> answered(const LinkQuestion &question)
{
    LinkSources sources(question.project, question.file, {});
    return surfaceLinks(*question.painting, sources);
}

QStringList linkedFiles(const PaintingDocument &document)
{
    const LinkSources sources(document.project(), enginePath(document.filePath()), {});
    QStringList files;
    for (const Layer *layer : document.painting().layers())
        for (const Drawing &drawing : layer->drawings)
            for (const Element &element : drawing.elements) {
                const auto *mesh = std::get_if<MeshShape>(element.shape.get());
                if (!mesh || !mesh->link || mesh->link->file.empty())
                    continue;
                const QString file =
                    QFile::decodeName(QByteArray::fromStdString(sources.fileOf(*mesh->link).string()));
                if (!files.contains(file))
                    files << file;
            }
    return files;
}

int updateSurfaces(PaintingDocument &document, const std::vector<SurfaceLink> &links)
{
    act::ReplaceShape update;
    int count = 0;
    for (const SurfaceLink &link : links) {
        update.elements.insert(update.elements.end(), link.outdated.begin(), link.outdated.end());
        update.strokes.insert(update.strokes.end(), link.updates.begin(), link.updates.end());
        count += link.isOutdated() ? 1 : 0;
    }
    if (count == 0 || !document.perform(update))
        return 0;
    return count;
}

QString offerOf(const std::vector<SurfaceLink> &links)
{
    QString offer;
    for (const SurfaceLink &link : links)
        for (const std::shared_ptr<const ElementShape> &shape : link.updates)
            offer += QString::fromStdString(std::get<MeshShape>(*shape).link->digest);
    return offer;
}

} // namespace ductus
