#include "ductus/project_kind.h"

#include <algorithm>

namespace ductus {

namespace {

struct AppKind
{
    LinkedApp app;
    std::string_view generator; // as the app writes it, before its version
    std::string_view kind;
};

constexpr AppKind appKinds[] = {{LinkedApp::SketchSurfacer, "SketchSurfacer", "sketch-surface"},
                                {LinkedApp::LayerPainter, "LayerPainter", "painting"},
                                {LinkedApp::DoodleStudio, "DoodleStudio", "doodle"}};

} // namespace

std::optional<LinkedApp> appOf(const Project &project)
{
    std::optional<LinkedApp> last;
    for (const ProjectDocument &document : project.documents)
        for (const AppKind &candidate : appKinds) {
            if (candidate.kind != document.kind)
                continue;
            if (std::string_view(project.generator).starts_with(candidate.generator))
                return candidate.app;
            last = candidate.app;
        }
    return last;
}

} // namespace ductus
