/**
 * @class   vtkParticleWriter
 * @brief   writes particles for other programs
 *
 * Gadget-2 snapshots (binary, without or with names of the blocks, and HDF5) and tables of
 * comma-separated values, whole or not at all. Every point array that this plugin knows is written;
 * of a polydata without Velocity, SmoothingLength, Intensity, Color or Component those are 0, 0, 1,
 * white and 0. Arrays of other types are converted, a Color of floats as 0 to 1.
 *
 * Component by component a particle's Gadget type is Boundary (5) where it absorbs; where it emits
 * Gas (0), Halo (1), Bulge (3) or Stars (4) by words of the component's name, else Disk (2).
 *
 * On several processes the first one writes what it holds, and warns where others hold others.
 */
#ifndef vtkParticleWriter_h
#define vtkParticleWriter_h

#include "vtkGalaxyReconstructionModule.h" // for export macro
#include "vtkWriter.h"

class vtkPolyData;

class VTKGALAXYRECONSTRUCTION_EXPORT vtkParticleWriter : public vtkWriter
{
public:
  static vtkParticleWriter* New();
  vtkTypeMacro(vtkParticleWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The file. A snapshot too large for one Gadget file becomes FileName.0, FileName.1 and so on.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  enum Formats
  {
    FROM_EXTENSION = 0, ///< .g1; .gad, .gadget, .g2; .hdf5, .h5; .csv
    GADGET1,            ///< binary, blocks without names
    GADGET2,            ///< binary, blocks with names
    GADGET_HDF5,
    CSV
  };
  ///@{
  /// Default FROM_EXTENSION.
  vtkSetClampMacro(Format, int, FROM_EXTENSION, CSV);
  vtkGetMacro(Format, int);
  ///@}

protected:
  vtkParticleWriter() = default;
  ~vtkParticleWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

private:
  vtkParticleWriter(const vtkParticleWriter&) = delete;
  void operator=(const vtkParticleWriter&) = delete;

  bool IsFirstProcess(vtkPolyData* particles);
  void Export(vtkPolyData* particles);

  char* FileName = nullptr;
  int Format = FROM_EXTENSION;
};

#endif
