/**
 * @class   vtkTiltedRingReader
 * @brief   a tilted-ring model as one closed polyline a ring
 *
 * Reads a plain table (r, vrot, Z0, i, PA), GIPSY ROTCUR output or a TiRiFiC .def file. Points lie
 * in the galaxy's frame: X to the West, Y to the North, Z toward the observer; lengths are kpc at
 * the given distance, or arcsec where the distance is 0. Cell arrays: `Radius`, `ScaleHeight` (in
 * the points' unit), `RotationVelocity`, `ExpansionVelocity`, `SystemicVelocity` (km/s),
 * `Inclination`, `PositionAngle` (degrees), `SurfaceBrightness` (the model's own unit).
 */
#ifndef vtkTiltedRingReader_h
#define vtkTiltedRingReader_h

#include "vtkGalaxyReconstructionModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for the file name

class VTKGALAXYRECONSTRUCTION_EXPORT vtkTiltedRingReader : public vtkPolyDataAlgorithm
{
public:
  static vtkTiltedRingReader* New();
  vtkTypeMacro(vtkTiltedRingReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Path of the file.
  vtkSetStdStringFromCharMacro(FileName);
  vtkGetCharFromStdStringMacro(FileName);
  ///@}
  ///@{
  /// Distance in Mpc; 0 (default) leaves lengths in arcsec.
  vtkSetMacro(Distance, double);
  vtkGetMacro(Distance, double);
  ///@}

  enum SpinSenses
  {
    FROM_CODE = 0,
    CLOCKWISE = 1,
    COUNTER_CLOCKWISE = 2,
  };
  ///@{
  /// The sense of rotation on the sky, which decides the near side and which no kinematic fit
  /// knows: FromCode (default: what the file's program means), Clockwise or CounterClockwise.
  vtkSetClampMacro(SpinSense, int, FROM_CODE, COUNTER_CLOCKWISE);
  vtkGetMacro(SpinSense, int);
  ///@}

protected:
  vtkTiltedRingReader();
  ~vtkTiltedRingReader() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkTiltedRingReader(const vtkTiltedRingReader&) = delete;
  void operator=(const vtkTiltedRingReader&) = delete;

  std::string FileName;
  double Distance = 0;
  int SpinSense = FROM_CODE;
};

#endif
