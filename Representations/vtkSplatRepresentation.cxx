#include "vtkSplatRepresentation.h"

#include "Filters/AllParticles.h"
#include "Filters/ParticleData.h"
#include "PlacedParticles.h"
#include "Readers/ReportErrors.h"

#include "vtkAlgorithm.h"
#include "vtkAssembly.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkStringArray.h"

#include <algorithm>

vtkStandardNewMacro(vtkSplatRepresentation);

namespace
{
std::string linesOf(vtkStringArray* names)
{
  std::string lines;
  for (vtkIdType k = 0; names && k < names->GetNumberOfValues(); ++k)
  {
    lines += names->GetValue(k) + "\n";
  }
  return lines;
}
}

vtkSplatRepresentation::vtkSplatRepresentation()
  : Prop(vtkSmartPointer<vtkSplatProp>::New())
  , Annotation(vtkSmartPointer<vtkSkyAnnotation>::New())
  , Settings(this->Prop->GetSettings())
  , Particles(vtkSmartPointer<vtkPolyData>::New())
  , Place(vtkSmartPointer<vtkAssembly>::New())
{
  this->Prop->AddObserver(vtkCommand::ProgressEvent, this, &vtkSplatRepresentation::OnProgress);
}

vtkSplatRepresentation::~vtkSplatRepresentation() = default;

int vtkSplatRepresentation::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkSplatRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Particles = vtkSmartPointer<vtkPolyData>::New();
  if (inputVector[0]->GetNumberOfInformationObjects() == 1)
  {
    galaxy::reportErrors(this, [&] {
      const galaxy::AllParticles all = galaxy::gatherParticles(
        vtkDataObject::GetData(inputVector[0], 0), galaxy::ParticleUse::Drawn);
      this->Particles->ShallowCopy(all.particles);
    });
  }
  this->ComponentNames = linesOf(vtkStringArray::SafeDownCast(
    this->Particles->GetFieldData()->GetAbstractArray("ComponentName")));
  return this->Superclass::RequestData(request, inputVector, outputVector);
}

void vtkSplatRepresentation::OnProgress(vtkObject*, unsigned long, void* fraction)
{
  this->UpdateProgress(*static_cast<double*>(fraction));
  if (this->GetAbortExecute())
  {
    this->Prop->AbortPicture();
  }
}

int vtkSplatRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  return this->Superclass::ProcessViewRequest(request, inInfo, outInfo) &&
    galaxy::reportErrors(this, [&] { this->AnswerView(request, inInfo); });
}

void vtkSplatRepresentation::AnswerView(vtkInformationRequestKey* request, vtkInformation* inInfo)
{
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    vtkPVView::SetPiece(inInfo, this, this->Particles);
    vtkPVRenderView::SetStreamable(inInfo, this, true);
    double bounds[6];
    galaxy::boundsOfKernels(this->Particles, *this->Settings, bounds);
    galaxy::placeBounds(this->Place->GetMatrix(), bounds);
    vtkPVRenderView::SetGeometryBounds(inInfo, this, bounds);
  }
  else if (request == vtkPVView::REQUEST_RENDER())
  {
    this->SetAbortExecute(0);
    // ParaView asks for less detail while the view of large data moves.
    this->Prop->SetInteractive(inInfo->Has(vtkPVRenderView::USE_LOD()) == 1);
    auto view = vtkPVRenderView::SafeDownCast(inInfo->Get(vtkPVView::VIEW()));
    this->Prop->SetIsLaidLast(inInfo->Has(vtkPVRenderView::USE_LOD())
        ? view->GetUseDistributedRenderingForLODRender()
        : view->GetUseDistributedRenderingForRender());
    vtkPolyData* particles =
      this->PlacedParticles(vtkPolyData::SafeDownCast(vtkPVView::GetDeliveredPiece(inInfo, this)));
    this->Prop->SetParticles(particles);
    this->Annotation->SetGroup(particles ? particles->GetFieldData() : nullptr);
    vtkDataArray* distance =
      particles ? particles->GetFieldData()->GetArray("SkyDistance") : nullptr;
    this->Annotation->SetDistance(
      distance && distance->GetNumberOfTuples() > 0 ? distance->GetComponent(0, 0) : 0);
  }
  else if (request == vtkPVRenderView::REQUEST_STREAMING_UPDATE())
  {
    // Who asks once will ask again; scripts do not.
    this->Prop->SetRefining(true);
    if (this->Prop->Refine())
    {
      // Whatever was streamed, the view is rendered again, and asks once more.
      vtkPVRenderView::SetNextStreamedPiece(inInfo, this, this->Particles);
    }
  }
}

vtkPolyData* vtkSplatRepresentation::PlacedParticles(vtkPolyData* delivered)
{
  const vtkMTimeType time =
    std::max(delivered ? delivered->GetMTime() : 0, this->Place->GetMatrix()->GetMTime());
  if (delivered != this->Delivered || time > this->PlacedTime.GetMTime())
  {
    this->Placed = nullptr;
    galaxy::reportErrors(
      this, [&] { this->Placed = galaxy::placed(delivered, this->Place->GetMatrix()); });
    this->Delivered = delivered;
    this->PlacedTime.Modified();
  }
  return this->Placed;
}

void vtkSplatRepresentation::SetUserTransform(const double matrix[16])
{
  vtkNew<vtkMatrix4x4> user;
  user->DeepCopy(matrix);
  this->Place->SetUserMatrix(user);
}

bool vtkSplatRepresentation::AddToView(vtkView* view)
{
  vtkPVRenderView* renderView = vtkPVRenderView::SafeDownCast(view);
  if (!renderView)
  {
    return false;
  }
  vtkRenderer* renderer = renderView->GetRenderer();
  renderer->AddViewProp(this->Prop);
  // After what puts together, smooths and sends what several processes have drawn.
  this->Laying =
    renderer->AddObserver(vtkCommand::EndEvent, this->Prop.Get(), &vtkSplatProp::LayLast, -1.0F);
  this->Ending = renderer->GetRenderWindow()->AddObserver(
    vtkCommand::EndEvent, this->Prop.Get(), &vtkSplatProp::EndWindow);
  renderView->GetNonCompositedRenderer()->AddViewProp(this->Annotation);
  // A window asks its views for better pictures while they rest only where they are to be streamed.
  vtkPVView::SetEnableStreaming(true);
  return this->Superclass::AddToView(view);
}

bool vtkSplatRepresentation::RemoveFromView(vtkView* view)
{
  vtkPVRenderView* renderView = vtkPVRenderView::SafeDownCast(view);
  if (!renderView)
  {
    return false;
  }
  renderView->GetRenderer()->RemoveObserver(this->Laying);
  renderView->GetRenderWindow()->RemoveObserver(this->Ending);
  renderView->GetRenderer()->RemoveViewProp(this->Prop);
  renderView->GetNonCompositedRenderer()->RemoveViewProp(this->Annotation);
  return this->Superclass::RemoveFromView(view);
}

void vtkSplatRepresentation::SetVisibility(bool visible)
{
  this->Superclass::SetVisibility(visible);
  this->Prop->SetVisibility(visible);
  this->Annotation->SetVisibility(visible);
}

void vtkSplatRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->Prop->PrintSelf(os, indent.GetNextIndent());
  this->Annotation->PrintSelf(os, indent.GetNextIndent());
}
