// Props: paintings of LayerPainter that stand in a filmed scene, each on a canvas. The canvas says where it
// is, how it is turned and how large it is in every frame, what hides it and when it is shown.
#pragma once

#include "painting/storage/painting_content.h"
#include "project/links/document_link.h"

#include <memory>
#include <string>

namespace ductus {

struct Prop
{
    std::shared_ptr<const PaintingContent> painting; // not null; a copy, the film needs no other file
    DocumentLink link;                               // the painting it is a copy of
    std::string look;                                // by name; empty or not there: as its layers are
    /// Canvas from painting, canvas units: x right, y down, z away from who looks at the sheet's front.
    /// Not mirrored.
    Placement placement;
    double framesPerSecond = 0.0; // its motion begins with the film; 0: it stands still
};

/// The \a painting upright and facing the same way as a sheet of \a canvasSize, in its middle, standing on
/// its lower edge, as large as fits.
Placement standingOnSheet(const Painting &painting, const Eigen::Vector2d &canvasSize);

/// The look of \a painting that is called \a name; none if there is no such look.
std::optional<LookId> lookNamed(const Painting &painting, const std::string &name);

/// Whether anything in \a painting moves.
bool hasMotion(const Painting &painting);

/// What a reader would refuse, in words; empty: nothing.
std::string propProblem(const Prop &prop);

} // namespace ductus
