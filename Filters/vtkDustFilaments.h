/**
 * @class   vtkDustFilaments
 * @brief   filaments of dust from the seeds of a disc
 *
 * From every seed a random walk of absorbing particles along the velocity of its ring or along the
 * disc's rotation (Dykes et al., dust models 1 and 2), held to the plane by an oscillator in
 * thermal equilibrium; or a layer of clouds by fractal noise. Input: seeds from vtkDiskSeeds.
 * Output: particles whose Intensity is an absorption cross-section in kpc^2. With Model
 * FROM_DESCRIPTION the .galaxy file decides and the other parameters are unused.
 */
#ifndef vtkDustFilaments_h
#define vtkDustFilaments_h

#include "vtkGalaxyReconstructionModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class VTKGALAXYRECONSTRUCTION_EXPORT vtkDustFilaments : public vtkPolyDataAlgorithm
{
public:
  static vtkDustFilaments* New();
  vtkTypeMacro(vtkDustFilaments, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Models
  {
    FROM_DESCRIPTION = -1,
    RING_VELOCITY = 0,
    DISK_ROTATION = 1,
    FRACTAL = 2,
  };
  enum Noises
  {
    FBM = 0,
    RIDGED = 1,
  };
  ///@{
  /// The dust model. Default FROM_DESCRIPTION.
  vtkSetClampMacro(Model, int, FROM_DESCRIPTION, FRACTAL);
  vtkGetMacro(Model, int);
  ///@}
  ///@{
  /// Particles of a filament. Default 60.
  vtkSetMacro(Steps, int);
  vtkGetMacro(Steps, int);
  ///@}
  ///@{
  /// Length of a step, kpc. Default 0.03.
  vtkSetMacro(StepLength, double);
  vtkGetMacro(StepLength, double);
  ///@}
  ///@{
  /// sigma_v in the plane, km/s. Default 10.
  vtkSetMacro(VelocityDispersion, double);
  vtkGetMacro(VelocityDispersion, double);
  ///@}
  ///@{
  /// sigma_w across the plane, km/s. Default 6.
  vtkSetMacro(VerticalDispersion, double);
  vtkGetMacro(VerticalDispersion, double);
  ///@}
  ///@{
  /// Root mean square height, kpc. Default 0.1.
  vtkSetMacro(ScaleHeight, double);
  vtkGetMacro(ScaleHeight, double);
  ///@}
  ///@{
  /// Time in which a random velocity is forgotten, Myr. Default 10.
  vtkSetMacro(DampingTime, double);
  vtkGetMacro(DampingTime, double);
  ///@}
  ///@{
  /// Of FRACTAL: the kind of noise, FBM (default) or RIDGED.
  vtkSetClampMacro(Noise, int, FBM, RIDGED);
  vtkGetMacro(Noise, int);
  ///@}
  ///@{
  /// Of FRACTAL: scales that are summed, 1 to 16. Default 5.
  vtkSetMacro(Octaves, int);
  vtkGetMacro(Octaves, int);
  ///@}
  ///@{
  /// Of FRACTAL: how many times smaller each scale is than the one before, 1 to 4. Default 2.
  vtkSetMacro(Lacunarity, double);
  vtkGetMacro(Lacunarity, double);
  ///@}
  ///@{
  /// Of FRACTAL: H, each scale being weaker than the one before by lacunarity^-H. Default 0.33.
  vtkSetMacro(Hurst, double);
  vtkGetMacro(Hurst, double);
  ///@}
  ///@{
  /// Of FRACTAL: s of the density exp(s g), g the noise, 0 to 5. Default 1.
  vtkSetMacro(Contrast, double);
  vtkGetMacro(Contrast, double);
  ///@}
  ///@{
  /// Of FRACTAL: size of the largest structure, kpc. Default 0.5.
  vtkSetMacro(NoiseScale, double);
  vtkGetMacro(NoiseScale, double);
  ///@}
  ///@{
  /// Of FRACTAL: shear of the structure; positive trails the rotation. Default 0.
  vtkSetMacro(Winding, double);
  vtkGetMacro(Winding, double);
  ///@}
  ///@{
  /// Of FRACTAL: particles a seed. Default 8.
  vtkSetMacro(Children, int);
  vtkGetMacro(Children, int);
  ///@}
  ///@{
  /// Of FRACTAL: rms displacement of a seed's particles in the plane, on each axis, kpc. Default
  /// 0.05.
  vtkSetMacro(Spread, double);
  vtkGetMacro(Spread, double);
  ///@}
  ///@{
  /// Another seed gives other filaments and clouds. Default 1.
  vtkSetMacro(RandomSeed, int);
  vtkGetMacro(RandomSeed, int);
  ///@}
  ///@{
  /// Whether particles get a Velocity (km/s). Default false.
  vtkSetMacro(Velocities, bool);
  vtkGetMacro(Velocities, bool);
  vtkBooleanMacro(Velocities, bool);
  ///@}

protected:
  vtkDustFilaments() = default;
  ~vtkDustFilaments() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkDustFilaments(const vtkDustFilaments&) = delete;
  void operator=(const vtkDustFilaments&) = delete;

  int Model = FROM_DESCRIPTION;
  int Steps = 60;
  double StepLength = 0.03;
  double VelocityDispersion = 10;
  double VerticalDispersion = 6;
  double ScaleHeight = 0.1;
  double DampingTime = 10;
  int Noise = FBM;
  int Octaves = 5;
  double Lacunarity = 2;
  double Hurst = 0.33;
  double Contrast = 1;
  double NoiseScale = 0.5;
  double Winding = 0;
  int Children = 8;
  double Spread = 0.05;
  int RandomSeed = 1;
  bool Velocities = false;
};

#endif
