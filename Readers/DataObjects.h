#ifndef galaxy_DataObjects_h
#define galaxy_DataObjects_h

#include "Readers/Formats/Galaxy.h"

#include <initializer_list>
#include <string>

class vtkDataObject;
class vtkFieldData;
class vtkImageData;
class vtkPartitionedDataSetCollection;
class vtkPolyData;

/// Between the plain structs of Readers/Formats and VTK's data objects, both ways.
namespace galaxy
{
/// Point array `Intensity`, field arrays `FITSHeader` (a card a value), `Unit` and, where reading
/// did more than the standard's scaling, `Note`; points lie at FITS pixel coordinates.
void toImageData(const Image& image, vtkImageData* output);
/// The inverse. Throws Error where an array is missing.
Image toImage(vtkImageData* input);

/// One closed polyline a ring, cell arrays as vtkTiltedRingReader documents. `unit` is the length
/// of one arcsec in the output; `spin` +1 counter-clockwise, -1 clockwise.
void toPolyData(const RingTable& table, double unit, double spin, vtkPolyData* output);
/// The inverse. Throws Error where an array is missing.
RingTable toRingTable(vtkPolyData* input, double unit);

/// A collection of the rings ("rings") and each image by its name, in its place on the sky; the
/// description travels in the field data as the string arrays `GalaxyFile`, `GalaxyDescription` and
/// `GalaxyTables` (the paths and texts of the tables it names).
void toCollection(Galaxy galaxy, vtkPartitionedDataSetCollection* output);
/// The inverse: the description comes from the field data, rings and images from the blocks, so
/// that what a filter did to them counts. Throws Error where something is missing.
Galaxy toGalaxy(vtkPartitionedDataSetCollection* input);

/// The part of a galaxy that its particles depend on once they are lit, rings and description, as
/// field arrays; and back, without images.
void toFieldData(const Galaxy& galaxy, vtkDataObject* object);
Galaxy galaxyOfFieldData(vtkDataObject* object);

/// One string as a field array.
void setFieldString(vtkDataObject* object, const char* name, const std::string& value);
/// One tuple of numbers as a field array.
void setFieldNumbers(vtkFieldData* fields, const char* name, std::initializer_list<double> values);
/// The string, or an Error naming `what` lacks the array.
std::string fieldString(vtkDataObject* object, const char* name, const std::string& what);
}

#endif
