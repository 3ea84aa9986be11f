#include "sketchsurfacer/ui/viewport/mesh_actor.h"

#include <algorithm>
#include <cstring>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

namespace ductus {

namespace {

template <typename Array, typename Value>
vtkSmartPointer<Array> arrayOf(const std::vector<Value> &values, int components)
{
    auto array = vtkSmartPointer<Array>::New();
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(vtkIdType(values.size()) / components);
    if (!values.empty())
        std::memcpy(array->GetVoidPointer(0), values.data(), values.size() * sizeof(Value));
    return array;
}

vtkPolyDataMapper *mapperOf(vtkActor *actor)
{
    return static_cast<vtkPolyDataMapper *>(actor->GetMapper());
}

vtkSmartPointer<vtkActor> newActor()
{
    auto actor = vtkSmartPointer<vtkActor>::New();
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetStatic(1);
    actor->SetMapper(mapper);
    actor->PickableOff();
    actor->VisibilityOff();
    return actor;
}

} // namespace

vtkSmartPointer<vtkActor> newMeshActor()
{
    vtkSmartPointer<vtkActor> actor = newActor();
    vtkProperty *property = actor->GetProperty();
    property->SetInterpolationToPhong();
    property->SetAmbient(0.0);
    property->SetDiffuse(1.0);
    property->SetSpecular(0.06);
    property->SetSpecularPower(18.0);
    return actor;
}

vtkSmartPointer<vtkActor> newLineActor(Rgba colour, double pixels)
{
    vtkSmartPointer<vtkActor> actor = newActor();
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetColor(colour[0] / 255.0, colour[1] / 255.0, colour[2] / 255.0);
    actor->GetProperty()->SetLineWidth(float(pixels));
    mapperOf(actor)->ScalarVisibilityOff();
    return actor;
}

vtkSmartPointer<vtkActor> newDotActor()
{
    vtkSmartPointer<vtkActor> actor = newActor();
    actor->GetProperty()->LightingOff();
    return actor;
}

void setActorMesh(vtkActor *actor, const ShadedMesh &mesh)
{
    static_assert(sizeof(vtkIdType) == sizeof(std::int64_t));
    vtkNew<vtkPolyData> data;
    vtkNew<vtkPoints> points;
    points->SetData(arrayOf<vtkFloatArray>(mesh.positions, 3));
    data->SetPoints(points);
    const auto normals = arrayOf<vtkFloatArray>(mesh.normals, 3);
    normals->SetName("Normals");
    data->GetPointData()->SetNormals(normals);
    data->GetPointData()->SetScalars(arrayOf<vtkUnsignedCharArray>(mesh.colours, 3));
    vtkNew<vtkCellArray> cells;
    cells->SetData(3, arrayOf<vtkIdTypeArray>(mesh.triangles, 1));
    data->SetPolys(cells);
    mapperOf(actor)->SetInputData(data);
}

void setActorLines(vtkActor *actor, const std::vector<std::vector<Vec3>> &lines)
{
    vtkNew<vtkPolyData> data;
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    for (const std::vector<Vec3> &line : lines) {
        cells->InsertNextCell(int(line.size()));
        for (const Vec3 &p : line)
            cells->InsertCellPoint(points->InsertNextPoint(p.data()));
    }
    data->SetPoints(points);
    data->SetLines(cells);
    mapperOf(actor)->SetInputData(data);
}

void setActorDots(vtkActor *actor, const std::vector<Vec3> &dots, const std::vector<Rgba> &colours)
{
    vtkNew<vtkPolyData> data;
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    vtkNew<vtkUnsignedCharArray> scalars;
    scalars->SetNumberOfComponents(3);
    points->SetNumberOfPoints(vtkIdType(dots.size()));
    cells->InsertNextCell(int(dots.size()));
    for (std::size_t i = 0; i < dots.size(); ++i) {
        points->SetPoint(vtkIdType(i), dots[i].data());
        cells->InsertCellPoint(vtkIdType(i));
        scalars->InsertNextTuple3(colours[i][0], colours[i][1], colours[i][2]);
    }
    data->SetPoints(points);
    data->SetVerts(cells);
    data->GetPointData()->SetScalars(scalars);
    mapperOf(actor)->SetInputData(data);
}

void bringForward(vtkActor *actor, const Vec3 &eye, const Vec3 &forward, bool perspective, double share,
                  double distance)
{
    vtkNew<vtkMatrix4x4> matrix;
    // Scaling about the eye leaves every projection as it is and changes depth alone.
    const double scale = perspective ? 1.0 - share : 1.0;
    const Vec3 shift = perspective ? Vec3((1.0 - scale) * eye) : Vec3(-distance * forward);
    for (int i = 0; i < 3; ++i) {
        matrix->SetElement(i, i, scale);
        matrix->SetElement(i, 3, shift[i]);
    }
    actor->SetUserMatrix(matrix);
}

} // namespace ductus
