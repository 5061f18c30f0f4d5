/**
 * @class   vtkDiskSeeds
 * @brief   seeds of one disc component of a galaxy
 *
 * Draws points uniformly over the warped disc and lights them from the component's images (Dykes et
 * al., section on building the 3D model). Input: a galaxy from vtkGalaxyReader. Output: points in
 * kpc with `Radius` (kpc), `Azimuth` (radians from the receding major axis), `Intensity` (0 to the
 * layers' weights), `Light` (kpc^2: intensity times the seed's share of sky), `Color`, `Draw`.
 */
#ifndef vtkDiskSeeds_h
#define vtkDiskSeeds_h

#include "vtkGalaxyReconstructionModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for the component

class VTKGALAXYRECONSTRUCTION_EXPORT vtkDiskSeeds : public vtkPolyDataAlgorithm
{
public:
  static vtkDiskSeeds* New();
  vtkTypeMacro(vtkDiskSeeds, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Name of the component; empty (default): the first disc.
  vtkSetStdStringFromCharMacro(Component);
  vtkGetCharFromStdStringMacro(Component);
  ///@}
  ///@{
  /// A factor on the number of seeds, which leaves their summed light. Default 1.
  vtkSetMacro(ParticleScale, double);
  vtkGetMacro(ParticleScale, double);
  ///@}
  ///@{
  /// Another seed gives other points. Default 1.
  vtkSetMacro(RandomSeed, int);
  vtkGetMacro(RandomSeed, int);
  ///@}

protected:
  vtkDiskSeeds() = default;
  ~vtkDiskSeeds() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkDiskSeeds(const vtkDiskSeeds&) = delete;
  void operator=(const vtkDiskSeeds&) = delete;

  std::string Component;
  double ParticleScale = 1;
  int RandomSeed = 1;
};

#endif
