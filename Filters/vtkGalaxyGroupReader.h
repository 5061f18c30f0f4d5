/**
 * @class   vtkGalaxyGroupReader
 * @brief   several galaxies placed by right ascension, declination and distance
 *
 * Reads a .galaxygroup file, builds the galaxies that it names and places each in its own tangent
 * frame, magnified about its own centre, relative to the first one, whose sky frame (X West, Y
 * North, Z toward the observer) is the group's. Output: particles as vtkGalaxyModel's; components
 * are named GALAXY/COMPONENT.
 */
#ifndef vtkGalaxyGroupReader_h
#define vtkGalaxyGroupReader_h

#include "vtkGalaxyReconstructionModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for the file name

class VTKGALAXYRECONSTRUCTION_EXPORT vtkGalaxyGroupReader : public vtkPolyDataAlgorithm
{
public:
  static vtkGalaxyGroupReader* New();
  vtkTypeMacro(vtkGalaxyGroupReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Path of the .galaxygroup file.
  vtkSetStdStringFromCharMacro(FileName);
  vtkGetCharFromStdStringMacro(FileName);
  ///@}
  ///@{
  /// A factor on every galaxy's size, greater than 0, times the file's own. Default 1.
  vtkSetMacro(Magnification, double);
  vtkGetMacro(Magnification, double);
  ///@}
  ///@{
  /// A factor on the distances from the first galaxy, greater than 0, times the file's own.
  /// Default 1.
  vtkSetMacro(Separation, double);
  vtkGetMacro(Separation, double);
  ///@}
  ///@{
  /// A factor on the number of particles of every component, at least 0. Default 1.
  vtkSetMacro(ParticleScale, double);
  vtkGetMacro(ParticleScale, double);
  ///@}
  ///@{
  /// Another seed, at least 0, gives other particles. Default 1.
  vtkSetMacro(RandomSeed, int);
  vtkGetMacro(RandomSeed, int);
  ///@}

protected:
  vtkGalaxyGroupReader();
  ~vtkGalaxyGroupReader() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkGalaxyGroupReader(const vtkGalaxyGroupReader&) = delete;
  void operator=(const vtkGalaxyGroupReader&) = delete;

  std::string FileName;
  double Magnification = 1;
  double Separation = 1;
  double ParticleScale = 1;
  int RandomSeed = 1;
};

#endif
