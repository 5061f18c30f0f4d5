/**
 * @class   vtkFITSImageReader
 * @brief   one plane of a FITS image as vtkImageData
 *
 * Point array `Intensity` (float64; NaN where the image is blank). A point lies at its FITS pixel
 * coordinates: the first pixel's centre is (1, 1). The header's cards are the string array
 * `FITSHeader` of the field data, the unit the string array `Unit`.
 */
#ifndef vtkFITSImageReader_h
#define vtkFITSImageReader_h

#include "vtkGalaxyReconstructionModule.h" // for export macro
#include "vtkImageAlgorithm.h"

#include <memory> // for the image read
#include <string> // for file and extension names

namespace galaxy
{
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
  /// Zero-based plane of a cube, counted over all axes beyond the second. Default 0.
  vtkSetMacro(Plane, int);
  vtkGetMacro(Plane, int);
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

  std::string FileName;
  std::string Extension;
  int HDU = -1;
  int Plane = 0;
  std::unique_ptr<galaxy::Image> Image;
  vtkTimeStamp ImageTime;
};

#endif
