// VTK actors from plain arrays.
#pragma once

#include "sketchsurfacer/ui/viewport/shaded_mesh.h"

#include <vtkActor.h>
#include <vtkSmartPointer.h>

namespace ductus {

/// Nothing in it yet, not shown.
vtkSmartPointer<vtkActor> newMeshActor();
/// Lines of \a pixels width in one colour, unlit.
vtkSmartPointer<vtkActor> newLineActor(Rgba colour, double pixels);
/// Dots of their own colours, unlit.
vtkSmartPointer<vtkActor> newDotActor();

/// Replaces what \a actor draws.
void setActorMesh(vtkActor *actor, const ShadedMesh &mesh);
void setActorLines(vtkActor *actor, const std::vector<std::vector<Vec3>> &lines);
/// \a colours: one a point.
void setActorDots(vtkActor *actor, const std::vector<Vec3> &dots, const std::vector<Rgba> &colours);

/// Moves \a actor towards \a eye so that it covers the same pixels but wins against what lies up to \a
/// distance nearer: lines on a surface are seen although half of each is inside it.
void bringForward(vtkActor *actor, const Vec3 &eye, const Vec3 &forward, bool perspective, double share,
                  double distance);

} // namespace ductus
