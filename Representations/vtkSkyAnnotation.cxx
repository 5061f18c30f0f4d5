#include "vtkSkyAnnotation.h"

#include "Filters/GroupData.h"
#include "Filters/Model/ScaleBar.h"

#include "vtkActor2D.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCoordinate.h"
#include "vtkFieldData.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkWindow.h"

#include <cmath>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkSkyAnnotation);

namespace
{
constexpr double Margin = 0.05;    // from the edges, of the height
constexpr double LongestBar = 0.2; // of the width
constexpr double Arrow = 0.07;     // of the compass, of the height

void prepare(vtkTextActor* text)
{
  text->GetTextProperty()->SetFontSize(16);
  text->GetTextProperty()->SetShadow(true);
  text->GetTextProperty()->SetJustificationToCentered();
}

/// Of the whole picture's height, at the focal point. For one tile of a picture the camera sees as
/// much less as the window says.
double heightInKpc(vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const double half = camera->GetParallelProjection()
    ? camera->GetParallelScale()
    : camera->GetDistance() * std::tan(vtkMath::RadiansFromDegrees(camera->GetViewAngle() / 2));
  return 2 * half * renderer->GetVTKWindow()->GetTileScale()[1];
}
}

struct vtkSkyAnnotation::Group
{
  vtkSmartPointer<vtkFieldData> fields; // that they are from
  galaxy::GroupLabels labels;
  std::vector<vtkSmartPointer<vtkTextActor>> actors;
};

vtkSkyAnnotation::vtkSkyAnnotation()
  : Members(std::make_unique<Group>())
{
  this->Drawing->SetPoints(this->Points);
  this->Drawing->SetLines(this->Lines);
  vtkNew<vtkPolyDataMapper2D> mapper;
  vtkNew<vtkCoordinate> coordinates;
  coordinates->SetCoordinateSystemToNormalizedViewport();
  mapper->SetInputData(this->Drawing);
  mapper->SetTransformCoordinate(coordinates);
  mapper->SetTransformCoordinateUseDouble(true);
  this->LineActor->SetMapper(mapper);
  this->LineActor->GetProperty()->SetLineWidth(2);
  for (const auto& text : this->TextActors)
  {
    text->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
    prepare(text);
    text->GetTextProperty()->SetVerticalJustificationToCentered();
  }
  this->TextActors[0]->GetTextProperty()->SetJustificationToRight(); // of any length
}

vtkSkyAnnotation::~vtkSkyAnnotation() = default;

int vtkSkyAnnotation::RenderOverlay(vtkViewport* viewport)
{
  vtkRenderer* renderer = vtkRenderer::SafeDownCast(viewport);
  if (!renderer || !(this->ScaleBar || this->Compass || this->Labels))
  {
    return 0;
  }
  this->Points->Reset();
  this->Lines->Reset();
  for (const auto& text : this->TextActors)
  {
    text->SetInput("");
    text->GetTextProperty()->SetColor(this->Color);
  }
  const double aspect = renderer->GetTiledAspectRatio();
  if (this->ScaleBar)
  {
    this->AddScaleBar(renderer, aspect);
  }
  if (this->Compass)
  {
    this->AddCompass(renderer, aspect);
  }
  if (this->Labels)
  {
    this->AddLabels(renderer);
  }
  this->Points->Modified();
  this->Lines->Modified();
  this->LineActor->GetProperty()->SetColor(this->Color);
  this->LineActor->RenderOverlay(viewport);
  for (const auto& text : this->TextActors)
  {
    text->RenderOpaqueGeometry(viewport);
    text->RenderOverlay(viewport);
  }
  return 1;
}

void vtkSkyAnnotation::AddScaleBar(vtkRenderer* renderer, double aspect)
{
  const double width = heightInKpc(renderer) * aspect;
  const galaxy::ScaleBar bar = galaxy::scaleBar(LongestBar * width, this->Distance);
  if (bar.length == 0)
  {
    return;
  }
  const double right = 1 - Margin / aspect, left = right - bar.length / width;
  const double tick = 0.3 * Margin;
  this->AddLine(left, Margin, right, Margin);
  for (const double end : { left, right })
  {
    this->AddLine(end, Margin - tick / 2, end, Margin + tick / 2);
  }
  const std::string label =
    bar.label + (this->Members->labels.isToScale ? "" : " (galaxies not to scale)");
  this->AddText(0, label.c_str(), right, 1.8 * Margin);
}

void vtkSkyAnnotation::AddCompass(vtkRenderer* renderer, double aspect)
{
  const vtkMatrix4x4* view = renderer->GetActiveCamera()->GetModelViewTransformMatrix();
  const double size = 1.5 * (Arrow + Margin);
  const double x = 1 - size / aspect, y = 1 - size;
  const struct
  {
    const char* name;
    int axis;
    double sign;
  } directions[] = { { "N", 1, 1 }, { "E", 0, -1 } };
  int which = 1;
  for (const auto& direction : directions)
  {
    // How far an arrow of this direction goes to the right and up.
    const double right = direction.sign * view->GetElement(0, direction.axis);
    const double up = direction.sign * view->GetElement(1, direction.axis);
    const auto along = [&](double length, double* to) {
      to[0] = x + length * right / aspect;
      to[1] = y + length * up;
    };
    double tip[2], name[2];
    along(Arrow, tip);
    along(Arrow + 0.5 * Margin, name);
    this->AddLine(x, y, tip[0], tip[1]);
    // Where it points at the eye or away, there is no place for its name.
    this->AddText(which++, std::hypot(right, up) > 0.3 ? direction.name : "", name[0], name[1]);
  }
}

void vtkSkyAnnotation::SetGroup(vtkFieldData* fields)
{
  if (fields == this->Members->fields)
  {
    return;
  }
  this->Members->fields = fields;
  this->Members->labels = fields ? galaxy::groupLabels(fields) : galaxy::GroupLabels();
  this->Members->actors.clear();
  for (const galaxy::GroupLabels::Label& label : this->Members->labels.members)
  {
    vtkNew<vtkTextActor> text;
    prepare(text);
    text->SetInput(("\n" + label.text).c_str());
    text->GetTextProperty()->SetVerticalJustificationToTop();
    text->GetPositionCoordinate()->SetCoordinateSystemToWorld();
    text->GetPositionCoordinate()->SetValue(
      label.position[0], label.position[1], label.position[2]);
    this->Members->actors.push_back(text);
  }
}

void vtkSkyAnnotation::AddLabels(vtkRenderer* renderer)
{
  const vtkMatrix4x4* view = renderer->GetActiveCamera()->GetModelViewTransformMatrix();
  for (std::size_t k = 0; k < this->Members->actors.size(); ++k)
  {
    const double* p = this->Members->labels.members[k].position;
    double depth = -view->GetElement(2, 3);
    for (int c = 0; c < 3; ++c)
    {
      depth -= view->GetElement(2, c) * p[c];
    }
    if (depth > 0)
    {
      vtkTextActor* text = this->Members->actors[k];
      text->GetTextProperty()->SetColor(this->Color);
      text->RenderOpaqueGeometry(renderer);
      text->RenderOverlay(renderer);
    }
  }
}

void vtkSkyAnnotation::AddLine(double x0, double y0, double x1, double y1)
{
  const vtkIdType ends[2] = { this->Points->InsertNextPoint(x0, y0, 0),
    this->Points->InsertNextPoint(x1, y1, 0) };
  this->Lines->InsertNextCell(2, ends);
}

void vtkSkyAnnotation::AddText(int which, const char* text, double x, double y)
{
  this->TextActors[which]->SetInput(text);
  this->TextActors[which]->GetPositionCoordinate()->SetValue(x, y);
}

void vtkSkyAnnotation::ReleaseGraphicsResources(vtkWindow* window)
{
  this->LineActor->ReleaseGraphicsResources(window);
  for (const auto& text : this->TextActors)
  {
    text->ReleaseGraphicsResources(window);
  }
  for (const auto& text : this->Members->actors)
  {
    text->ReleaseGraphicsResources(window);
  }
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkSkyAnnotation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ScaleBar: " << this->ScaleBar << "\n";
  os << indent << "Compass: " << this->Compass << "\n";
  os << indent << "Labels: " << this->Labels << "\n";
  os << indent << "Distance: " << this->Distance << "\n";
  os << indent << "Color: " << this->Color[0] << " " << this->Color[1] << " " << this->Color[2]
     << "\n";
}
