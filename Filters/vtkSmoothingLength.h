/**
 * @class   vtkSmoothingLength
 * @brief   the radius of each particle's footprint, from where the particles are
 *
 * Input: any points, also composite data, whose sets are looked at together, and those of several
 * processes. Output: the same with a point array `SmoothingLength` (float32, in the points' unit,
 * kpc for galaxies), in place of one that it may have; a vtkPolyData without cells gets a vertex a
 * point. Where there is a point array `Component` the particles of each component are looked at on
 * their own.
 */
#ifndef vtkSmoothingLength_h
#define vtkSmoothingLength_h

#include "vtkGalaxyReconstructionModule.h" // for export macro
#include "vtkPassInputTypeAlgorithm.h"

class VTKGALAXYRECONSTRUCTION_EXPORT vtkSmoothingLength : public vtkPassInputTypeAlgorithm
{
public:
  static vtkSmoothingLength* New();
  vtkTypeMacro(vtkSmoothingLength, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Models
  {
    DENSITY = 0,
    NEIGHBOURS = 1,
    CONSTANT = 2,
    BRIGHTNESS = 3,
  };
  ///@{
  /// DENSITY (default): from the local density of particles, counted in cells; NEIGHBOURS: the same
  /// from the nearest neighbours, exact and slow; CONSTANT: one for all; BRIGHTNESS: by the point
  /// array `Intensity`.
  vtkSetClampMacro(Model, int, DENSITY, BRIGHTNESS);
  vtkGetMacro(Model, int);
  ///@}
  ///@{
  /// Radius over the mean distance between particles (DENSITY, NEIGHBOURS). Default 1.5.
  vtkSetMacro(Factor, double);
  vtkGetMacro(Factor, double);
  ///@}
  ///@{
  /// Particles that the density is taken over (DENSITY, NEIGHBOURS). Default 32.
  vtkSetMacro(Neighbours, int);
  vtkGetMacro(Neighbours, int);
  ///@}
  ///@{
  /// The radius (CONSTANT), or its mean weighted by light (BRIGHTNESS), kpc. Default 0.1.
  vtkSetMacro(Length, double);
  vtkGetMacro(Length, double);
  ///@}
  ///@{
  /// The radius goes as this power of a particle's light (BRIGHTNESS). Default 1/3.
  vtkSetMacro(Exponent, double);
  vtkGetMacro(Exponent, double);
  ///@}
  ///@{
  /// No radius is smaller, kpc. Default 0.
  vtkSetMacro(Minimum, double);
  vtkGetMacro(Minimum, double);
  ///@}
  ///@{
  /// No radius is larger, kpc; 0: no limit. Default 0.
  vtkSetMacro(Maximum, double);
  vtkGetMacro(Maximum, double);
  ///@}

protected:
  vtkSmoothingLength() = default;
  ~vtkSmoothingLength() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkSmoothingLength(const vtkSmoothingLength&) = delete;
  void operator=(const vtkSmoothingLength&) = delete;

  int Model = DENSITY;
  double Factor = 1.5;
  int Neighbours = 32;
  double Length = 0.1;
  double Exponent = 1.0 / 3;
  double Minimum = 0;
  double Maximum = 0;
};

#endif
