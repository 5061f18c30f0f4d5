#include "vtkGalaxyReader.h"

#include "Readers/DataObjects.h"
#include "Readers/Formats/Error.h"

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
  try
  {
    galaxy::toCollection(galaxy::readGalaxy(this->FileName),
      vtkPartitionedDataSetCollection::GetData(outputVector, 0));
  }
  catch (const galaxy::Error& error)
  {
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}

void vtkGalaxyReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
}
