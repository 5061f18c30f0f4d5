#include "vtkSplatRepresentation.h"

#include "Filters/ParticleData.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkPVServerInformation.h"
#include "vtkPVSession.h"
#include "vtkPolyData.h"
#include "vtkProcessModule.h"
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

/// How many processes have the data, also where a client asks.
int processes()
{
  auto session =
    vtkPVSession::SafeDownCast(vtkProcessModule::GetProcessModule()->GetActiveSession());
  vtkPVServerInformation* server = session ? session->GetServerInformation() : nullptr;
  return server ? server->GetNumberOfProcesses() : 1;
}

/// Whether a process has the particles that the first one has, as where each has read the same
/// file, and not a part of all. To be asked by all of them.
bool isCopy(vtkPolyData* particles)
{
  vtkMultiProcessController* all = vtkMultiProcessController::GetGlobalController();
  if (!all || all->GetNumberOfProcesses() == 1)
  {
    return false;
  }
  constexpr int size = 7;
  double mine[size], first[size];
  mine[0] = static_cast<double>(particles->GetNumberOfPoints());
  particles->GetBounds(mine + 1);
  std::copy_n(mine, size, first);
  all->Broadcast(first, size, 0);
  return all->GetLocalProcessId() > 0 && std::equal(mine, mine + size, first);
}
}

vtkSplatRepresentation::vtkSplatRepresentation()
  : Prop(vtkSmartPointer<vtkSplatProp>::New())
  , Annotation(vtkSmartPointer<vtkSkyAnnotation>::New())
  , Settings(this->Prop->GetSettings())
  , Particles(vtkSmartPointer<vtkPolyData>::New())
  , Piece(Particles)
{
  this->Prop->AddObserver(vtkCommand::ProgressEvent, this, &vtkSplatRepresentation::OnProgress);
}

vtkSplatRepresentation::~vtkSplatRepresentation() = default;

int vtkSplatRepresentation::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkSplatRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Particles = vtkSmartPointer<vtkPolyData>::New();
  if (inputVector[0]->GetNumberOfInformationObjects() == 1)
  {
    if (vtkPolyData* input = vtkPolyData::GetData(inputVector[0], 0))
    {
      this->Particles->ShallowCopy(input);
    }
  }
  this->Piece = isCopy(this->Particles) ? vtkSmartPointer<vtkPolyData>::New() : this->Particles;
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
  if (!this->Superclass::ProcessViewRequest(request, inInfo, outInfo))
  {
    return 0;
  }
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    vtkPVView::SetPiece(inInfo, this, this->Piece);
    if (processes() > 1)
    {
      vtkPVRenderView::SetDeliverToAllProcesses(inInfo, this, true);
    }
    vtkPVRenderView::SetStreamable(inInfo, this, true);
    double bounds[6];
    galaxy::boundsOfKernels(this->Particles, *this->Settings, bounds);
    vtkPVRenderView::SetGeometryBounds(inInfo, this, bounds);
  }
  else if (request == vtkPVView::REQUEST_RENDER())
  {
    this->SetAbortExecute(0);
    // ParaView asks for less detail while the view of large data moves.
    this->Prop->SetInteractive(inInfo->Has(vtkPVRenderView::USE_LOD()) == 1);
    auto particles = vtkPolyData::SafeDownCast(vtkPVView::GetDeliveredPiece(inInfo, this));
    this->Prop->SetParticles(particles);
    this->Prop->SetComposited(processes() > 1 &&
      vtkPVRenderView::SafeDownCast(inInfo->Get(vtkPVView::VIEW()))
        ->GetUseDistributedRenderingForRender());
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
  return 1;
}

bool vtkSplatRepresentation::AddToView(vtkView* view)
{
  vtkPVRenderView* renderView = vtkPVRenderView::SafeDownCast(view);
  if (!renderView)
  {
    return false;
  }
  renderView->GetRenderer()->AddViewProp(this->Prop);
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
