#include "vtkSplatImage.h"

#include "Filters/AllParticles.h"
#include "Filters/ParticleData.h"
#include "Filters/PictureData.h"
#include "Filters/Splatting/Panorama.h"
#include "Filters/Splatting/Picture.h"
#include "Filters/Splatting/Render.h"
#include "Filters/Splatting/Tiles.h"
#include "Readers/AlgorithmProgress.h"
#include "Readers/CopyToArray.h"
#include "Readers/Processes.h"
#include "Readers/ReportErrors.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <stdexcept>

vtkStandardNewMacro(vtkSplatImage);

namespace
{
galaxy::Vec3 vector(const double v[3])
{
  return { v[0], v[1], v[2] };
}

void addChannels(vtkImageData* output, const char* name, const std::vector<float>& values)
{
  output->GetPointData()->AddArray(galaxy::copyToArray<vtkFloatArray>(values, name, 3));
}
}

struct vtkSplatImage::Memory : galaxy::RenderMemory
{
};

vtkSplatImage::vtkSplatImage()
  : Settings(vtkSmartPointer<vtkSplatSettings>::New())
  , Splatting(std::make_unique<Memory>())
{
}

vtkSplatImage::~vtkSplatImage() = default;

vtkMTimeType vtkSplatImage::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Settings->GetMTime());
}

int vtkSplatImage::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  return 1;
}

int vtkSplatImage::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  if (this->ImageSize[0] < 1 || this->ImageSize[1] < 1)
  {
    vtkErrorMacro(<< "ImageSize must be at least 1 x 1, not " << this->ImageSize[0] << " x "
                  << this->ImageSize[1]);
    return 0;
  }
  // Here, for VTK would want its pixels ever after of a picture that is refused later. It is drawn
  // and then handed on; what there is of the last one goes. Several processes must agree, and do
  // not look.
  const double held = 1024.0 * this->GetOutputDataObject(0)->GetActualMemorySize();
  const auto requireMemory = [&] {
    galaxy::requireMemoryOfPicture(this->ImageSize[0], this->ImageSize[1], 2, held);
  };
  if (galaxy::numberOfProcesses() == 1 && !galaxy::reportErrors(this, requireMemory))
  {
    return 0;
  }
  // Of several processes the first one has the picture.
  int extent[6] = { 0, this->ImageSize[0] - 1, 0, this->ImageSize[1] - 1, 0, 0 };
  extent[1] = galaxy::isFirstProcess() ? extent[1] : -1;
  outputVector->GetInformationObject(0)->Set(
    vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  return 1;
}

int vtkSplatImage::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector**, vtkInformationVector*)
{
  // The picture's extent says nothing about the particles': the input is always wanted whole.
  return 1;
}

int vtkSplatImage::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return galaxy::reportErrors(this, [&] {
    const galaxy::AllParticles all = galaxy::gatherParticles(
      vtkDataObject::GetData(inputVector[0], 0), galaxy::ParticleUse::Drawn);
    if (galaxy::isFirstProcess())
    {
      this->Draw(all.particles, vtkImageData::GetData(outputVector, 0));
    }
  });
}

void vtkSplatImage::Draw(vtkPolyData* particles, vtkImageData* output)
{
  galaxy::ParticleInput input;
  galaxy::viewParticles(particles, *this->Settings, input);
  const std::string unknown = this->Settings->UnknownNames(input.components);
  if (!unknown.empty())
  {
    vtkWarningMacro(<< "the particles have no component named " << unknown
                    << "; use the names of their component table");
  }
  galaxy::RenderOptions options = galaxy::renderOptions(*this->Settings);
  const double half = this->Settings->GetTolerance() / 2;
  options.allowed = { this->White > 0 ? half * this->White : 0, half };
  options.memory = this->Splatting.get();
  options.progress = galaxy::progressOf(this);
  const galaxy::RenderedImage image = this->Render(input.view, options);
  if (image.aborted)
  {
    return;
  }
  if (image.statistics.invalid > 0)
  {
    vtkWarningMacro(<< image.statistics.invalid
                    << " particles with a NaN, infinite or negative value were left out; correct "
                       "their point arrays");
  }
  if (image.statistics.tooBright > 0)
  {
    vtkWarningMacro(
      << image.statistics.tooBright
      << " values of Radiance are more than 3.4e38, the most that its single precision "
         "holds, and given as that; choose a larger unit of luminosity");
  }
  output->SetExtent(0, image.width - 1, 0, image.height - 1, 0, 0);
  addChannels(output, "Radiance", image.radiance);
  addChannels(output, "Transmittance", image.transmittance);
  output->GetPointData()->SetActiveScalars("Radiance");
  galaxy::setCamera(this->PictureCamera(), output);
  galaxy::passSkyPlace(particles, output);
  this->ActiveEffects = galaxy::activeEffects(image.statistics);
  this->RenderStatistics = galaxy::describe(image.statistics);
}

galaxy::RenderedImage vtkSplatImage::Render(
  const galaxy::ParticleView& view, const galaxy::RenderOptions& options)
{
  const bool isPerspective = this->Projection == CAMERA && !this->CameraParallelProjection;
  if (isPerspective && !(this->CameraViewAngle > 0 && this->CameraViewAngle < 180))
  {
    throw std::invalid_argument("CameraViewAngle must be more than 0 and less than 180 degrees");
  }
  const galaxy::Camera camera = galaxy::Camera::lookAt(vector(this->CameraPosition),
    vector(this->CameraFocalPoint), vector(this->CameraViewUp), this->CameraParallelProjection,
    this->CameraParallelScale, this->CameraViewAngle, this->ImageSize[0], this->ImageSize[1]);
  if (this->Projection == CAMERA)
  {
    return galaxy::render(view, camera, options);
  }
  galaxy::Panorama panorama;
  panorama.kind = this->Projection == DOME ? galaxy::Panorama::Kind::Dome
                                           : galaxy::Panorama::Kind::Equirectangular;
  panorama.ahead = camera;
  panorama.domeAngle = this->DomeAngle;
  panorama.width = this->ImageSize[0];
  panorama.height = this->ImageSize[1];
  return galaxy::renderPanorama(view, panorama, options);
}

galaxy::PictureCamera vtkSplatImage::PictureCamera() const
{
  const char* const names[] = { "Camera", "Equirectangular", "Dome" };
  galaxy::PictureCamera camera;
  camera.projection = names[this->Projection];
  camera.domeAngle = this->DomeAngle;
  camera.position = vector(this->CameraPosition);
  camera.focalPoint = vector(this->CameraFocalPoint);
  camera.viewUp = vector(this->CameraViewUp);
  camera.parallel = this->CameraParallelProjection;
  camera.parallelScale = this->CameraParallelScale;
  camera.viewAngle = this->CameraViewAngle;
  return camera;
}

void vtkSplatImage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ImageSize: " << this->ImageSize[0] << " x " << this->ImageSize[1] << "\n";
  os << indent << "CameraParallelProjection: " << this->CameraParallelProjection << "\n";
  os << indent << "CameraParallelScale: " << this->CameraParallelScale << "\n";
  os << indent << "CameraViewAngle: " << this->CameraViewAngle << "\n";
  os << indent << "Projection: " << this->Projection << "\n";
  os << indent << "DomeAngle: " << this->DomeAngle << "\n";
  os << indent << "White: " << this->White << "\n";
  os << indent << "ActiveEffects: " << this->ActiveEffects << "\n";
  os << indent << "RenderStatistics: " << this->RenderStatistics << "\n";
}
