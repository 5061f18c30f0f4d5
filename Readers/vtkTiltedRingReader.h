/**
 * @class   vtkTiltedRingReader
 * @brief   a tilted-ring model as one closed polyline a ring
 *
 * Reads a TiRiFiC or FAT .def file, GIPSY ROTCUR, 3DBarolo or DiskFit output, a table with named
 * columns (CSV, ECSV, IPAC, VizieR, CDS, LaTeX, text under a heading), NEMO's rotcur or a plain one
 * (r, vrot, Z0, i, PA). Points lie in the
 * galaxy's frame: X to the West, Y to the North, Z toward the observer; lengths are kpc at the
 * given distance, or arcsec where the distance is 0. Cell arrays: `Radius`, `ScaleHeight` (in the
 * points' unit), `RotationVelocity`, `ExpansionVelocity`, `SystemicVelocity` (km/s), `Inclination`,
 * `PositionAngle` (degrees, unwrapped), `SurfaceBrightness` (the model's own unit), and the file's
 * further columns (dispersions, centres, errors) by their names there, in their units.
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
  /// Distance in Mpc, at most 1e6; 0 (default) says that it is not known: lengths stay arcsec, and
  /// files in pc or kpc are refused.
  vtkSetMacro(Distance, double);
  vtkGetMacro(Distance, double);
  ///@}

  ///@{
  /// Arcsec that a pixel spans, at most 648000, for files with radii in pixels; 0 (default) is what
  /// the file says.
  vtkSetMacro(PixelScale, double);
  vtkGetMacro(PixelScale, double);
  ///@}
  ///@{
  /// The galaxy whose rows of a table with a column Name or Galaxy are read; empty (default) where
  /// the table has but one. Capitals and blanks do not count.
  vtkSetStdStringFromCharMacro(GalaxyName);
  vtkGetCharFromStdStringMacro(GalaxyName);
  ///@}
  ///@{
  /// The disk of a TiRiFiC file with several, from 1 (default).
  vtkSetMacro(Disk, int);
  vtkGetMacro(Disk, int);
  ///@}

  enum SidesOfDisk
  {
    FIRST = 0,
    SECOND = 1,
    MEAN = 2,
  };
  ///@{
  /// Where the disk is one of two halves, receding and approaching: its own values (First,
  /// default), those of the other half (Second), or the mean of both.
  vtkSetClampMacro(Sides, int, FIRST, MEAN);
  vtkGetMacro(Sides, int);
  ///@}

  enum LayerLaws
  {
    FROM_FILE = 0,
    GAUSSIAN = 1,
    SECH2 = 2,
    EXPONENTIAL = 3,
    LORENTZIAN = 4,
    BOX = 5,
  };
  ///@{
  /// The vertical law that the scale heights belong to; FromFile (default): what the file says, or
  /// its program's usual one.
  vtkSetClampMacro(LayerLaw, int, FROM_FILE, BOX);
  vtkGetMacro(LayerLaw, int);
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
  std::string GalaxyName;
  double Distance = 0;
  double PixelScale = 0;
  int Disk = 1;
  int Sides = FIRST;
  int LayerLaw = FROM_FILE;
  int SpinSense = FROM_CODE;
};

#endif
