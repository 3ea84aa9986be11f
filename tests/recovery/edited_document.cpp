#include "recovery/edited_document.h"

#include "document/document_files.h"
#include "project/project_reader.h"

namespace ductus {

namespace {

constexpr int pointCount = 12, grid = 1024; // a power of two: fractions are exact

} // namespace

bool EditedDocument::edit()
{
    const int number = editCount() + 1;
    if (number <= 0 || !addLine(number))
        return false;
    if (number % 7 == 0) {
        document().undoStack()->undo();
        document().undoStack()->redo();
    }
    return editCount() == number;
}

QStringList editedKinds()
{
    return {QStringLiteral("sketchsurfacer"), QStringLiteral("layerpainter"), QStringLiteral("doodlestudio")};
}

std::unique_ptr<EditedDocument> editedDocument(const QString &kind)
{
    if (kind == QLatin1String("sketchsurfacer"))
        return editedSketch();
    if (kind == QLatin1String("layerpainter"))
        return editedPainting();
    if (kind == QLatin1String("doodlestudio"))
        return editedDoodle();
    return nullptr;
}

Result<int> editsIn(const QString &kind, const QString &path)
{
    Result<Project> project = openProject(enginePath(path), knownDocuments());
    if (!project)
        return project.error();
    const std::unique_ptr<EditedDocument> edited = editedDocument(kind);
    if (const Result<void> loaded = edited->document().load(std::move(project).value(), {}); !loaded)
        return loaded.error();
    return edited->editCount();
}

std::vector<Eigen::Vector3d> lineOf(int number)
{
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < pointCount; ++i)
        points.emplace_back(double((number * 37 + i * 5) % grid) / grid,
                            double((number * 101 + i * 11) % grid) / grid, 0.0);
    return points;
}

bool isLine(const std::vector<Eigen::Vector3d> &points, int number)
{
    return points == lineOf(number);
}

} // namespace ductus
