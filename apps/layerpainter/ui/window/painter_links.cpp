// Surfaces that are linked to sketches: what is newer there is offered, never taken unasked.
#include "layerpainter/ui/window/painter_window.h"
#include "widgets/shell/message_bar.h"

#include <QFileInfo>
#include <algorithm>

namespace ductus {

namespace {

const QString linkKey = QStringLiteral("links");

QString nameOf(const SurfaceLink &link)
{
    const QString name = QString::fromStdString(link.link.name);
    return name.isEmpty() ? PainterWindow::tr("The surface") : name;
}

} // namespace

void PainterWindow::lookForNewerSurfaces(bool isAsked)
{
    jobs().start<std::vector<SurfaceLink>>(
        {QStringLiteral("links"), tr("Looking for changes of the sketches")}, this,
        [question = linkQuestion(mPainting)](const JobControl &) -> Result<std::vector<SurfaceLink>> {
            return answered(question);
        },
        [this, isAsked, looked = mPainting.sharedPainting()](Result<std::vector<SurfaceLink>> links) {
            if (!links)
                messages()->show(links.error());
            else if (looked == mPainting.sharedPainting())
                offerNewerSurfaces(*links, isAsked);
            else // painted on meanwhile: what was found belongs to shapes that may be gone
                lookForNewerSurfaces(isAsked);
        });
}

void PainterWindow::offerNewerSurfaces(const std::vector<SurfaceLink> &links, bool isAsked)
{
    const auto outdated = std::ranges::find_if(links, &SurfaceLink::isOutdated);
    if (outdated == links.end()) {
        messages()->withdraw(linkKey);
        mOffered.clear();
        const auto problem = std::ranges::find_if(links, [](const SurfaceLink &l) { return !!l.problem; });
        if (isAsked && links.empty())
            messages()->info(tr("No surface of this painting comes from a sketch."));
        else if (isAsked && problem != links.end())
            messages()->show(*problem->problem);
        else if (isAsked)
            messages()->success(tr("All surfaces are as their sketches are."));
        return;
    }
    const QString offer = offerOf(links);
    if (offer == mOffered && !isAsked)
        return;
    mOffered = offer;
    const auto count = std::ranges::count_if(links, &SurfaceLink::isOutdated);
    Message message;
    message.kind = MessageKind::Info;
    message.what = count == 1 ? tr("The surface of \"%1\" changed in SketchSurfacer.").arg(nameOf(*outdated))
                              : tr("%n surfaces changed in SketchSurfacer.", nullptr, int(count));
    message.remedy = tr("Update? Your layers, strokes and masks stay.");
    message.action = tr("Update");
    message.decline = tr("Not now");
    message.run = [this, links] { updateFromSketches(links); };
    message.key = linkKey;
    messages()->show(message);
}

void PainterWindow::updateFromSketches(const std::vector<SurfaceLink> &links)
{
    // What was deleted since the offer needs no update.
    std::vector<SurfaceLink> present = links;
    for (SurfaceLink &link : present)
        for (std::size_t i = link.outdated.size(); i-- > 0;) {
            const auto isThere = [&](const Layer *layer) {
                return std::ranges::any_of(layer->drawings, [&](const Drawing &drawing) {
                    return std::ranges::find(drawing.elements, link.outdated[i], &Element::id) !=
                           drawing.elements.end();
                });
            };
            if (std::ranges::any_of(mPainting.painting().layers(), isThere))
                continue;
            link.outdated.erase(link.outdated.begin() + std::ptrdiff_t(i));
            link.updates.erase(link.updates.begin() + std::ptrdiff_t(i));
        }
    if (const int count = updateSurfaces(mPainting, present); count > 0)
        messages()->success(tr("%n surfaces are as in their sketches now.", nullptr, count));
}

void PainterWindow::paintOnSurfacesOf(const QString &path)
{
    jobs().start<ImportedFile>(
        {QStringLiteral("open"), tr("Reading %1").arg(QFileInfo(path).fileName())}, this,
        [path](const JobControl &control) { return importFile(enginePath(path), {}, control); },
        [this, path](Result<ImportedFile> file) {
            if (!file) {
                showError(file.error());
                return;
            }
            adopt(std::move(*file), path);
            messages()->info(tr("%1 is open in another program: this painting is saved in a file of its own "
                                "and stays linked to the surface.")
                                 .arg(QFileInfo(path).fileName()));
        });
}

} // namespace ductus
