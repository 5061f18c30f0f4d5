#include "DataObjects.h"

#include "Readers/CopyToArray.h"
#include "Readers/Formats/AvailableMemory.h"
#include "Readers/Formats/Error.h"
#include "Readers/Formats/RingPlane.h"
#include "Readers/PlaceOnSky.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataAssembly.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace galaxy
{
namespace
{
constexpr int pointsPerRing = 181;
constexpr std::size_t cardLength = 80;

/// The columns of a ring table as cell arrays; `length` marks those that `unit` scales.
struct RingArray
{
  const char* name;
  double Ring::*member;
  bool length;
};
const RingArray ringArrays[] = {
  { "Radius", &Ring::radius, true },
  { "RotationVelocity", &Ring::rotationVelocity, false },
  { "ScaleHeight", &Ring::scaleHeight, true },
  { "Inclination", &Ring::inclination, false },
  { "PositionAngle", &Ring::positionAngle, false },
  { "SurfaceBrightness", &Ring::surfaceBrightness, false },
  { "ExpansionVelocity", &Ring::expansionVelocity, false },
  { "SystemicVelocity", &Ring::systemicVelocity, false },
};

/// A further column of the table as an array, unless the rings have one of this name already.
void addColumn(const RingColumn& column, vtkCellData* cells)
{
  if (!cells->HasArray(column.name.c_str()))
  {
    vtkNew<vtkDoubleArray> values;
    values->SetName(column.name.c_str());
    if (!column.unit.empty())
    {
      values->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), column.unit.c_str());
    }
    values->SetNumberOfValues(static_cast<vtkIdType>(column.values.size()));
    std::copy(column.values.begin(), column.values.end(), values->GetPointer(0));
    cells->AddArray(values);
  }
}

void setFieldInteger(vtkDataObject* object, const char* name, int value)
{
  vtkNew<vtkIntArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  object->GetFieldData()->AddArray(array);
}

int fieldInteger(vtkDataObject* object, const char* name, int fallback)
{
  vtkDataArray* array = object->GetFieldData()->GetArray(name);
  return array && array->GetNumberOfTuples() > 0 ? static_cast<int>(array->GetTuple1(0)) : fallback;
}

/// A description with all that it was read from, so that no file is looked at again.
void setDescription(vtkDataObject* object, const GalaxyDescription& description)
{
  setFieldString(object, "GalaxyFile", description.file);
  setFieldString(object, "GalaxyDescription", description.text);
  vtkNew<vtkStringArray> tables;
  tables->SetName("GalaxyTables");
  tables->SetNumberOfComponents(2);
  for (const auto& [path, text] : description.tables)
  {
    tables->InsertNextValue(path);
    tables->InsertNextValue(text);
  }
  object->GetFieldData()->AddArray(tables);
}

GalaxyDescription descriptionOf(vtkDataObject* object, const std::string& what)
{
  NamedTexts texts;
  auto tables =
    vtkStringArray::SafeDownCast(object->GetFieldData()->GetAbstractArray("GalaxyTables"));
  for (vtkIdType i = 0; tables && i + 1 < tables->GetNumberOfValues(); i += 2)
  {
    texts[tables->GetValue(i)] = tables->GetValue(i + 1);
  }
  const std::string file = fieldString(object, "GalaxyFile", what);
  return parseGalaxyDescription(fieldString(object, "GalaxyDescription", file), file, texts);
}

void requireMemoryOfCopy(const std::string& file, std::size_t pixels)
{
  requireMemory(double(sizeof(double)) * double(pixels), file, "",
    "a copy of the image of " + std::to_string(pixels) + " pixels",
    "cut out or bin the image first");
}

std::string blockName(vtkPartitionedDataSetCollection* collection, unsigned int index)
{
  const char* name = collection->HasMetaData(index)
    ? collection->GetMetaData(index)->Get(vtkCompositeDataSet::NAME())
    : nullptr;
  return name ? name : "";
}
}

void setFieldString(vtkDataObject* object, const char* name, const std::string& value)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  object->GetFieldData()->AddArray(array);
}

void setFieldNumbers(vtkFieldData* fields, const char* name, std::initializer_list<double> values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(values.size()));
  array->InsertNextTuple(values.begin());
  fields->AddArray(array);
}

std::string fieldString(vtkDataObject* object, const char* name, const std::string& what)
{
  auto array = vtkStringArray::SafeDownCast(object->GetFieldData()->GetAbstractArray(name));
  if (!array || array->GetNumberOfValues() == 0)
  {
    throw Error(what, name, "no such field array; connect GalaxyReader itself");
  }
  return array->GetValue(0);
}

void toImageData(const Image& image, vtkImageData* output)
{
  output->SetExtent(0, image.width - 1, 0, image.height - 1, 0, 0);
  output->SetOrigin(1, 1, 0);
  output->SetSpacing(1, 1, 1);
  requireMemoryOfCopy(image.file, image.values.size());
  output->GetPointData()->SetScalars(copyToArray<vtkDoubleArray>(image.values, "Intensity", 1));
  if (!image.bad.empty())
  {
    output->GetPointData()->AddArray(copyToArray<vtkUnsignedCharArray>(image.bad, "Bad", 1));
  }

  vtkNew<vtkStringArray> cards;
  cards->SetName("FITSHeader");
  for (std::size_t start = 0; start < image.cards.size(); start += cardLength)
  {
    cards->InsertNextValue(image.cards.substr(start, cardLength));
  }
  output->GetFieldData()->AddArray(cards);
  setFieldInteger(output, "AxisX", image.axes[0]);
  setFieldInteger(output, "AxisY", image.axes[1]);
  setFieldString(output, "Unit", image.unit);
  if (!image.note.empty())
  {
    setFieldString(output, "Note", image.note);
  }
  setFieldString(output, "File", image.file);
}

Image toImage(vtkImageData* input)
{
  Image image;
  image.file = fieldString(input, "File", "image");
  image.unit = fieldString(input, "Unit", image.file);
  if (input->GetFieldData()->GetAbstractArray("Note"))
  {
    image.note = fieldString(input, "Note", image.file);
  }
  image.axes = { fieldInteger(input, "AxisX", 1), fieldInteger(input, "AxisY", 2) };
  int size[3];
  input->GetDimensions(size);
  image.width = size[0];
  image.height = size[1];
  vtkDataArray* intensity = input->GetPointData()->GetArray("Intensity");
  if (!intensity || size[2] != 1)
  {
    throw Error(
      image.file, "Intensity", "no such point array on a flat image; connect GalaxyReader itself");
  }
  const auto pixels = static_cast<std::size_t>(intensity->GetNumberOfTuples());
  requireMemoryOfCopy(image.file, pixels);
  image.values.resize(pixels);
  for (std::size_t i = 0; i < image.values.size(); ++i)
  {
    image.values[i] = intensity->GetTuple1(static_cast<vtkIdType>(i));
  }
  if (auto bad = vtkUnsignedCharArray::SafeDownCast(input->GetPointData()->GetArray("Bad")))
  {
    image.bad.assign(bad->GetPointer(0), bad->GetPointer(0) + bad->GetNumberOfValues());
  }
  if (auto cards =
        vtkStringArray::SafeDownCast(input->GetFieldData()->GetAbstractArray("FITSHeader")))
  {
    for (vtkIdType i = 0; i < cards->GetNumberOfValues(); ++i)
    {
      std::string card = cards->GetValue(i);
      card.resize(cardLength, ' ');
      image.cards += card;
    }
  }
  return image;
}

void toPolyData(const RingTable& table, double unit, double spin, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  for (const Ring& ring : table.rings)
  {
    const double degree = M_PI / 180;
    const RingPlane plane = ringPlane(ring.inclination * degree, ring.positionAngle * degree, spin);
    lines->InsertNextCell(pointsPerRing);
    const vtkIdType first = points->GetNumberOfPoints();
    for (int k = 0; k < pointsPerRing - 1; ++k)
    {
      const double theta = 2 * M_PI * k / (pointsPerRing - 1);
      const Vec3 p = (ring.radius * unit) * (std::cos(theta) * plane.a + std::sin(theta) * plane.b);
      lines->InsertCellPoint(points->InsertNextPoint(p.x, p.y, p.z));
    }
    lines->InsertCellPoint(first);
  }
  output->SetPoints(points);
  output->SetLines(lines);
  for (const RingArray& column : ringArrays)
  {
    vtkNew<vtkDoubleArray> values;
    values->SetName(column.name);
    for (const Ring& ring : table.rings)
    {
      values->InsertNextValue(ring.*column.member * (column.length ? unit : 1));
    }
    output->GetCellData()->AddArray(values);
  }
  for (const RingColumn& column : table.columns)
  {
    addColumn(column, output->GetCellData());
  }
  output->GetCellData()->SetActiveScalars("RotationVelocity");
  setFieldInteger(output, "RingCode", static_cast<int>(table.code));
  setFieldInteger(output, "LayerLaw", static_cast<int>(table.layerLaw));
  setFieldString(output, "File", table.file);
}

RingTable toRingTable(vtkPolyData* input, double unit)
{
  RingTable table;
  table.file = fieldString(input, "File", "rings");
  table.code = static_cast<RingCode>(fieldInteger(input, "RingCode", 0));
  table.layerLaw =
    static_cast<LayerLaw>(fieldInteger(input, "LayerLaw", static_cast<int>(LayerLaw::Sech2)));
  table.rings.resize(static_cast<std::size_t>(input->GetNumberOfCells()));
  for (const RingArray& column : ringArrays)
  {
    vtkDataArray* values = input->GetCellData()->GetArray(column.name);
    if (!values)
    {
      throw Error(
        table.file, column.name, "no such cell array on the rings; connect GalaxyReader itself");
    }
    for (std::size_t i = 0; i < table.rings.size(); ++i)
    {
      table.rings[i].*column.member =
        values->GetTuple1(static_cast<vtkIdType>(i)) / (column.length ? unit : 1);
    }
  }
  return table;
}

void toFieldData(const Galaxy& galaxy, vtkDataObject* object)
{
  setDescription(object, galaxy.description);
  setFieldString(object, "RingFile", galaxy.rings.file);
  setFieldInteger(object, "RingCode", static_cast<int>(galaxy.rings.code));
  setFieldInteger(object, "LayerLaw", static_cast<int>(galaxy.rings.layerLaw));
  vtkNew<vtkDoubleArray> rings;
  rings->SetName("TiltedRings");
  rings->SetNumberOfComponents(static_cast<int>(std::size(ringArrays)));
  for (const Ring& ring : galaxy.rings.rings)
  {
    for (const RingArray& column : ringArrays)
    {
      rings->InsertNextValue(ring.*column.member);
    }
  }
  object->GetFieldData()->AddArray(rings);
}

Galaxy galaxyOfFieldData(vtkDataObject* object)
{
  Galaxy galaxy;
  galaxy.description = descriptionOf(object, "seeds");
  const std::string& file = galaxy.description.file;
  galaxy.description.images.clear();
  galaxy.rings.file = fieldString(object, "RingFile", file);
  galaxy.rings.code = static_cast<RingCode>(fieldInteger(object, "RingCode", 0));
  galaxy.rings.layerLaw =
    static_cast<LayerLaw>(fieldInteger(object, "LayerLaw", static_cast<int>(LayerLaw::Sech2)));
  vtkDataArray* rings = object->GetFieldData()->GetArray("TiltedRings");
  if (!rings || rings->GetNumberOfComponents() != static_cast<int>(std::size(ringArrays)))
  {
    throw Error(file, "TiltedRings", "no such field array; the input must come from DiskSeeds");
  }
  for (vtkIdType i = 0; i < rings->GetNumberOfTuples(); ++i)
  {
    Ring ring;
    int channel = 0;
    for (const RingArray& column : ringArrays)
    {
      ring.*column.member = rings->GetComponent(i, channel++);
    }
    galaxy.rings.rings.push_back(ring);
  }
  return galaxy;
}

void toCollection(Galaxy galaxy, vtkPartitionedDataSetCollection* output)
{
  const GalaxyDescription& description = galaxy.description;
  setDescription(output, description);

  const auto addBlock = [output](vtkDataObject* block, const std::string& name) {
    const unsigned int index = output->GetNumberOfPartitionedDataSets();
    output->SetPartition(index, 0, block);
    output->GetMetaData(index)->Set(vtkCompositeDataSet::NAME(), name.c_str());
  };
  vtkNew<vtkPolyData> rings;
  toPolyData(galaxy.rings, kpcPerArcsec(description.distance),
    spinOf(galaxy.rings.code, description.spin), rings);
  addBlock(rings, "rings");
  const SkyFrame frame(description.centre, description.distance);
  for (std::size_t i = 0; i < galaxy.images.size(); ++i)
  {
    if (!description.images[i].combine.empty())
    {
      continue;
    }
    vtkNew<vtkImageData> image;
    toImageData(galaxy.images[i], image);
    placeOnSky(galaxy.images[i], description.images[i], frame, image);
    addBlock(image, description.images[i].name);
    galaxy.images[i] = {}; // lest all be there twice
  }
}

Galaxy toGalaxy(vtkPartitionedDataSetCollection* input)
{
  Galaxy galaxy;
  galaxy.description = descriptionOf(input, "galaxy");
  const std::string& file = galaxy.description.file;

  const auto block = [&](const std::string& name) -> vtkDataObject* {
    for (unsigned int i = 0; i < input->GetNumberOfPartitionedDataSets(); ++i)
    {
      if (name == blockName(input, i))
      {
        return input->GetPartition(i, 0);
      }
    }
    throw Error(file, name, "no such block in the galaxy; connect GalaxyReader itself");
  };
  auto rings = vtkPolyData::SafeDownCast(block("rings"));
  if (!rings)
  {
    throw Error(file, "rings", "must be polygonal data");
  }
  galaxy.rings = toRingTable(rings, kpcPerArcsec(galaxy.description.distance));
  for (const ImageDescription& description : galaxy.description.images)
  {
    if (!description.combine.empty())
    {
      galaxy.images.emplace_back();
      continue;
    }
    auto image = vtkImageData::SafeDownCast(block(description.name));
    if (!image)
    {
      throw Error(file, description.name, "must be an image");
    }
    galaxy.images.push_back(toImage(image));
  }
  return galaxy;
}
}
