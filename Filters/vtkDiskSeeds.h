/**
 * @class   vtkDiskSeeds
 * @brief   seeds of one disc component of a galaxy
 *
 * Draws points on the warped disc, in proportion to the light of the component's images or evenly
 * over the surface (Dykes et al., section on building the 3D model), and lights them from the
 * images. Input: a galaxy from vtkGalaxyReader. Output: points in kpc with `Radius` (kpc),
 * `Azimuth` (radians from the receding major axis), `Intensity` (0 to the layers' weights), `Light`
 * (kpc^2: the seed's part of its pixel's flux), `Color`, `Draw`.
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
  enum Samplings
  {
    FROM_DESCRIPTION = -1,
    IMAGE_DRIVEN = 0,
    SURFACE_UNIFORM = 1,
  };
  ///@{
  /// Where seeds are drawn. Default FROM_DESCRIPTION: as the .galaxy file says.
  vtkSetClampMacro(Sampling, int, FROM_DESCRIPTION, SURFACE_UNIFORM);
  vtkGetMacro(Sampling, int);
  ///@}
  ///@{
  /// A factor on the number of seeds, at least 0, which leaves their summed light. Default 1.
  vtkSetMacro(ParticleScale, double);
  vtkGetMacro(ParticleScale, double);
  ///@}
  ///@{
  /// Another seed, at least 0, gives other points. Default 1.
  vtkSetMacro(RandomSeed, int);
  vtkGetMacro(RandomSeed, int);
  ///@}
  ///@{
  /// Side of the pixels that the model will be seen with, kpc: a component of particles = "Auto"
  /// gets no more seeds than those can show. 0 (default): as fine as its images.
  vtkSetMacro(ViewPixel, double);
  vtkGetMacro(ViewPixel, double);
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
  int Sampling = FROM_DESCRIPTION;
  double ParticleScale = 1;
  int RandomSeed = 1;
  double ViewPixel = 0;
};

#endif
