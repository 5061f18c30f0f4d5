/**
 * @class   vtkFITSImageReader
 * @brief   one plane of a FITS image, or a sum of planes, as vtkImageData
 *
 * The planes of a cube are spanned by its celestial axes, wherever they stand; see
 * galaxy::FitsSelection. A long reading tells its progress and ends where AbortExecute is set.
 *
 * Point array `Intensity` (float64; NaN where the image is blank). A point lies at its FITS pixel
 * coordinates: the first pixel's centre is (1, 1). The header's cards are the string array
 * `FITSHeader` of the field data, the unit the string array `Unit`; `Note`
 * says what was done or left out beyond the standard (asinh magnitudes, distortion tables).
 */
#ifndef vtkFITSImageReader_h
#define vtkFITSImageReader_h

#include "vtkGalaxyReconstructionModule.h" // for export macro
#include "vtkImageAlgorithm.h"

#include <memory> // for the image read
#include <string> // for file and extension names
#include <vector> // for the values that are masked

namespace galaxy
{
struct FitsSelection;
struct Image;
}

class VTKGALAXYRECONSTRUCTION_EXPORT vtkFITSImageReader : public vtkImageAlgorithm
{
public:
  static vtkFITSImageReader* New();
  vtkTypeMacro(vtkFITSImageReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Path of the file: .fits, .fit, .fts, also compressed as .gz or .fz.
  vtkSetStdStringFromCharMacro(FileName);
  vtkGetCharFromStdStringMacro(FileName);
  ///@}
  ///@{
  /// The HDU to read, 0 the primary one; -1 (default) the first that holds an image.
  vtkSetMacro(HDU, int);
  vtkGetMacro(HDU, int);
  ///@}
  ///@{
  /// EXTNAME of the HDU to read; wins over HDU where not empty.
  vtkSetStdStringFromCharMacro(Extension);
  vtkGetCharFromStdStringMacro(Extension);
  ///@}
  ///@{
  /// Zero-based plane of a cube, counted over all axes but the image's, the lowest-numbered
  /// fastest. Default 0.
  vtkSetMacro(Plane, int);
  vtkGetMacro(Plane, int);
  ///@}
  ///@{
  /// The first and last of the planes whose mean is read; (-1, -1), the default: Plane alone.
  vtkSetVector2Macro(Planes, int);
  vtkGetVector2Macro(Planes, int);
  ///@}
  ///@{
  /// Velocities, km/s, over whose channels the cube is integrated (moment 0); both 0, the default:
  /// Plane alone.
  vtkSetVector2Macro(VelocityRange, double);
  vtkGetVector2Macro(VelocityRange, double);
  ///@}
  ///@{
  /// Values that stand for blank pixels; none by default.
  void AddMaskValue(double value);
  void RemoveAllMaskValues();
  ///@}

protected:
  vtkFITSImageReader();
  ~vtkFITSImageReader() override;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkFITSImageReader(const vtkFITSImageReader&) = delete;
  void operator=(const vtkFITSImageReader&) = delete;

  bool ReadIfModified();
  galaxy::FitsSelection Selection() const;

  std::string FileName;
  std::string Extension;
  int HDU = -1;
  int Plane = 0;
  int Planes[2] = { -1, -1 };
  double VelocityRange[2] = { 0, 0 };
  std::vector<double> MaskValues;
  std::unique_ptr<galaxy::Image> Image;
  vtkTimeStamp ImageTime;
};

#endif
