/**
 * @class   vtkParticleWriter
 * @brief   writes particles for other programs
 *
 * Gadget-2 snapshots (binary, without or with names of the blocks, and HDF5) and tables of
 * comma-separated values, whole or not at all. Every point array that this plugin knows is written;
 * without Velocity, SmoothingLength, Intensity, Color or Component those are 0, 0, 1, white and 0,
 * which the report and the header of a snapshot in HDF5 say, and where it is more than velocities a
 * warning. Input: any points, also
 * composite data (Filters/ParticleSets.h).
 *
 * Component by component a particle's Gadget type is Boundary (5) where it absorbs; where it emits
 * Gas (0), Halo (1), Bulge (3) or Stars (4) by words of the component's name, else Disk (2).
 *
 * Of several processes the first one writes what all of them hold.
 */
#ifndef vtkParticleWriter_h
#define vtkParticleWriter_h

#include "vtkGalaxyReconstructionModule.h" // for export macro
#include "vtkWriter.h"

#include <string> // for the report

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

  /// How many particles the last file has, and what of them was made up.
  const char* GetReport() { return this->Report.c_str(); }

protected:
  vtkParticleWriter() = default;
  ~vtkParticleWriter() override;

  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

private:
  vtkParticleWriter(const vtkParticleWriter&) = delete;
  void operator=(const vtkParticleWriter&) = delete;

  void Export(vtkPolyData* particles, const std::string& madeUp);

  char* FileName = nullptr;
  int Format = FROM_EXTENSION;
  std::string Report;
};

#endif
