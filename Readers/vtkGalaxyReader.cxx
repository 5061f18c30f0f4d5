#include "vtkGalaxyReader.h"

#include "Readers/AlgorithmProgress.h"
#include "Readers/DataObjects.h"
#include "Readers/Processes.h"
#include "Readers/ReportErrors.h"

#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSetCollection.h"

vtkStandardNewMacro(vtkGalaxyReader);

vtkGalaxyReader::vtkGalaxyReader()
{
  this->SetNumberOfInputPorts(0);
}

int vtkGalaxyReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  if (!galaxy::isFirstProcess())
  {
    return 1;
  }
  return galaxy::reportErrors(this, [&] {
    galaxy::toCollection(galaxy::readGalaxy(this->FileName, galaxy::progressOf(this)),
      vtkPartitionedDataSetCollection::GetData(outputVector, 0));
  });
}

void vtkGalaxyReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
}
