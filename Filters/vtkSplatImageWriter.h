/**
 * @class   vtkSplatImageWriter
 * @brief   writes a picture of vtkSplatImage in linear light
 *
 * FITS (.fits, .fit, .fts): extensions RADIANCE and TRANSMITTANCE of three planes of float32, with
 * the camera and, for a picture from Earth, celestial coordinates in their headers. OpenEXR (.exr):
 * channels R, G, B and the layer `transmittance`. A file appears whole or not at all. On several
 * processes the first one writes.
 */
#ifndef vtkSplatImageWriter_h
#define vtkSplatImageWriter_h

#include "vtkGalaxyReconstructionModule.h" // for export macro
#include "vtkWriter.h"

class VTKGALAXYRECONSTRUCTION_EXPORT vtkSplatImageWriter : public vtkWriter
{
public:
  static vtkSplatImageWriter* New();
  vtkTypeMacro(vtkSplatImageWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The file; its extension says the format.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  enum PixelTypes
  {
    FLOAT = 0, ///< 32 bits, as computed
    HALF = 1,  ///< 16 bits
  };
  ///@{
  /// Of OpenEXR; FITS is always FLOAT. Default FLOAT.
  vtkSetClampMacro(PixelType, int, FLOAT, HALF);
  vtkGetMacro(PixelType, int);
  ///@}

protected:
  vtkSplatImageWriter() = default;
  ~vtkSplatImageWriter() override;

  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

private:
  vtkSplatImageWriter(const vtkSplatImageWriter&) = delete;
  void operator=(const vtkSplatImageWriter&) = delete;

  void Export();

  char* FileName = nullptr;
  int PixelType = FLOAT;
};

#endif
