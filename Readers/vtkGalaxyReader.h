/**
 * @class   vtkGalaxyReader
 * @brief   a .galaxy file: a galaxy's rings, images and the description of its components
 *
 * Output: a collection whose block `rings` holds the tilted rings (as vtkTiltedRingReader, in
 * kpc) and whose other blocks hold each image (as vtkFITSImageReader, but laid into the plane of
 * the sky at the galaxy, kpc) by the name that the file gives it. The description itself travels in
 * the field data, for the filters that build particles. The keys of a .galaxy file are listed in
 * Examples/README.md.
 */
#ifndef vtkGalaxyReader_h
#define vtkGalaxyReader_h

#include "vtkGalaxyReconstructionModule.h" // for export macro
#include "vtkPartitionedDataSetCollectionAlgorithm.h"

#include <string> // for the file name

class VTKGALAXYRECONSTRUCTION_EXPORT vtkGalaxyReader
  : public vtkPartitionedDataSetCollectionAlgorithm
{
public:
  static vtkGalaxyReader* New();
  vtkTypeMacro(vtkGalaxyReader, vtkPartitionedDataSetCollectionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Path of the .galaxy file.
  vtkSetStdStringFromCharMacro(FileName);
  vtkGetCharFromStdStringMacro(FileName);
  ///@}

protected:
  vtkGalaxyReader();
  ~vtkGalaxyReader() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkGalaxyReader(const vtkGalaxyReader&) = delete;
  void operator=(const vtkGalaxyReader&) = delete;

  std::string FileName;
};

#endif
