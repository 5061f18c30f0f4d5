/**
 * @class   vtkSplatRepresentation
 * @brief   the representation "Splats": particles as emitting and absorbing kernels
 *
 * Brings the particles of whatever has points (Filters/ParticleSets.h) to the process that draws
 * them and forwards everything else to vtkSplatProp,
 * the accuracy and the components' factors to the prop's vtkSplatSettings. While the prop draws,
 * the representation's own progress is the picture's, and SetAbortExecute aborts it.
 */
#ifndef vtkSplatRepresentation_h
#define vtkSplatRepresentation_h

#include "vtkAssembly.h"                   // for inline forwarding
#include "vtkGalaxyReconstructionModule.h" // for export macro
#include "vtkPVDataRepresentation.h"
#include "vtkSkyAnnotation.h" // for inline forwarding
#include "vtkSmartPointer.h"  // for the prop
#include "vtkSplatProp.h"     // for inline forwarding
#include "vtkSplatSettings.h" // for the forwarding macro

#include <string> // for the component names

class VTKGALAXYRECONSTRUCTION_EXPORT vtkSplatRepresentation : public vtkPVDataRepresentation
{
public:
  static vtkSplatRepresentation* New();
  vtkTypeMacro(vtkSplatRepresentation, vtkPVDataRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;
  void SetVisibility(bool visible) override;

  ///@{
  /// Forwarded to vtkSplatProp.
  void SetExposure(double exposure) { this->Prop->SetExposure(exposure); }
  void SetStretch(double stretch) { this->Prop->SetStretch(stretch); }
  void SetGamma(double gamma) { this->Prop->SetGamma(gamma); }
  void SetBlackPoint(double red, double green, double blue)
  {
    this->Prop->SetBlackPoint(red, green, blue);
  }
  void SetWhitePoint(double red, double green, double blue)
  {
    this->Prop->SetWhitePoint(red, green, blue);
  }
  const char* GetActiveEffects() { return this->Prop->GetActiveEffects(); }
  const char* GetRenderStatistics() { return this->Prop->GetRenderStatistics(); }
  vtkForwardSplatSettingsMacro;
  ///@}
  ///@{
  /// Where the particles are shown, as of any actor; Scale must be the same along all axes.
  void SetPosition(double x, double y, double z) { this->Place->SetPosition(x, y, z); }
  void SetScale(double x, double y, double z) { this->Place->SetScale(x, y, z); }
  void SetOrientation(double x, double y, double z) { this->Place->SetOrientation(x, y, z); }
  void SetOrigin(double x, double y, double z) { this->Place->SetOrigin(x, y, z); }
  void SetUserTransform(const double matrix[16]);
  ///@}
  /// The names of the particles' components as last read, a line each.
  const char* GetComponentNames() { return this->ComponentNames.c_str(); }

  ///@{
  /// Forwarded to vtkSkyAnnotation, which gets the distance from the particles' field array
  /// `SkyDistance` (kpc) and the group from Filters/GroupData.h's.
  void SetScaleBar(bool shown) { this->Annotation->SetScaleBar(shown); }
  void SetCompass(bool shown) { this->Annotation->SetCompass(shown); }
  void SetLabels(bool shown) { this->Annotation->SetLabels(shown); }
  void SetAnnotationColor(double red, double green, double blue)
  {
    this->Annotation->SetColor(red, green, blue);
  }
  ///@}

protected:
  vtkSplatRepresentation();
  ~vtkSplatRepresentation() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

private:
  vtkSplatRepresentation(const vtkSplatRepresentation&) = delete;
  void operator=(const vtkSplatRepresentation&) = delete;

  void AnswerView(vtkInformationRequestKey* request, vtkInformation* inInfo);
  /// The delivered particles where they are to be shown; null where they cannot be.
  vtkPolyData* PlacedParticles(vtkPolyData* delivered);
  void OnProgress(vtkObject* prop, unsigned long event, void* fraction);

  vtkSmartPointer<vtkSplatProp> Prop;
  vtkSmartPointer<vtkSkyAnnotation> Annotation;
  vtkSplatSettings* Settings;
  vtkSmartPointer<vtkPolyData> Particles; ///< of all processes, on the first one
  vtkSmartPointer<vtkAssembly> Place;     ///< for its matrix
  vtkSmartPointer<vtkPolyData> Placed;
  vtkPolyData* Delivered = nullptr; ///< what Placed was made of
  vtkTimeStamp PlacedTime;
  unsigned long Laying = 0, Ending = 0; ///< observers of the renderer and its window
  std::string ComponentNames;
};

#endif
