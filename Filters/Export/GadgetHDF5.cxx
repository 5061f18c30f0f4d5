#include "Filters/Export/GadgetHDF5.h"

#include "Filters/Export/AtomicFile.h"
#include "Filters/Export/GadgetFields.h"
#include "Filters/Export/GadgetTypes.h"
#include "Filters/Export/HDF5File.h"

namespace galaxy
{
namespace
{
/// Where a field's values of one type belong in the file.
struct Extent
{
  int type;
  const GadgetField* field;
  std::uint64_t offset;
};

hid_t typeOf(Element element)
{
  switch (element)
  {
    case Element::UInt8:
      return H5T_NATIVE_UINT8;
    case Element::UInt32:
      return H5T_NATIVE_UINT32;
    case Element::UInt64:
      return H5T_NATIVE_UINT64;
    case Element::Float32:
      break;
  }
  return H5T_NATIVE_FLOAT;
}

void writeHeader(const TypeOrder& order, const std::string& madeUp, HDF5File& file)
{
  std::vector<std::uint64_t> counts(order.counts().begin(), order.counts().end());
  std::vector<std::uint32_t> low, high;
  for (const std::uint64_t count : counts)
  {
    low.push_back(static_cast<std::uint32_t>(count));
    high.push_back(static_cast<std::uint32_t>(count >> 32));
  }
  const std::string header = "Header";
  file.makeGroup(header);
  file.setAttribute(header, "NumPart_ThisFile", counts);
  file.setAttribute(header, "NumPart_Total", low);
  file.setAttribute(header, "NumPart_Total_HighWord", high);
  file.setAttribute(header, "MassTable", std::vector<double>(gadgetTypes));
  for (const char* zero : { "Time", "Redshift", "BoxSize", "Omega0", "OmegaLambda" })
  {
    file.setAttribute(header, zero, std::vector<double>{ 0 });
  }
  file.setAttribute(header, "HubbleParam", std::vector<double>{ 1 });
  file.setAttribute(header, "NumFilesPerSnapshot", std::vector<std::int32_t>{ 1 });
  for (const char* flag : { "Flag_Sfr", "Flag_Feedback", "Flag_Cooling", "Flag_StellarAge",
         "Flag_Metals", "Flag_Entropy_ICs", "Flag_DoublePrecision" })
  {
    file.setAttribute(header, flag, std::vector<std::int32_t>{ 0 });
  }
  if (!madeUp.empty())
  {
    file.setAttribute(header, "MadeUp", madeUp);
  }
}

void writeComponents(const std::vector<ComponentInfo>& components, HDF5File& file)
{
  std::vector<std::string> names;
  std::vector<std::uint8_t> absorbs;
  std::vector<double> absorption, size, brightness;
  std::vector<std::int32_t> types;
  for (const ComponentInfo& component : components)
  {
    names.push_back(component.name);
    absorbs.push_back(component.absorbs);
    absorption.insert(absorption.end(), component.absorption.begin(), component.absorption.end());
    size.push_back(component.size);
    brightness.push_back(component.brightness);
    types.push_back(static_cast<std::int32_t>(gadgetTypeOf(component)));
  }
  file.makeGroup("Components");
  file.addDataset("Components/Name", names);
  file.addDataset("Components/Absorbs", absorbs);
  file.addDataset("Components/Absorption", absorption, 3);
  file.addDataset("Components/Size", size);
  file.addDataset("Components/Brightness", brightness);
  file.addDataset("Components/ParticleType", types);
}

std::vector<Extent> makeGroups(
  const TypeOrder& order, const std::vector<GadgetField>& fields, HDF5File& file)
{
  std::vector<Extent> extents;
  for (int type = 0; type < gadgetTypes; ++type)
  {
    if (order.counts()[type] == 0)
    {
      continue;
    }
    const std::string group = "PartType" + std::to_string(type);
    file.makeGroup(group);
    for (const GadgetField& field : fields)
    {
      if (type == 0 || !field.gasOnly)
      {
        const std::string dataset = group + "/" + field.dataset;
        extents.push_back({ type, &field,
          file.addEmptyDataset(
            dataset, typeOf(field.element), order.counts()[type], field.channels) });
        if (!field.unit.empty())
        {
          file.setAttribute(dataset, "Unit", field.unit);
        }
      }
    }
    file.link(group + "/Masses", group + "/Intensity");
  }
  return extents;
}

void writeValues(
  const TypeOrder& order, const Extent& extent, AtomicFile& file, ExportProgress& progress)
{
  const GadgetField& field = *extent.field;
  std::vector<char> values(TypeOrder::chunk * field.bytes());
  std::uint64_t offset = extent.offset;
  order.visit(extent.type, 0, order.counts()[extent.type],
    [&](const std::size_t* particles, std::size_t count) {
      field.gather(particles, count, values.data());
      file.writeAt(offset, values.data(), count * field.bytes());
      offset += count * field.bytes();
      progress.advance(static_cast<double>(count * field.bytes()));
    });
}
} // namespace

void writeGadgetHDF5(
  const ParticleTable& table, const std::string& file, const std::function<bool(double)>& progress)
{
  const TypeOrder order(table);
  const std::vector<GadgetField> fields = gadgetFields(table, true);
  std::uint64_t total = 0;
  for (const GadgetField& field : fields)
  {
    total += (field.gasOnly ? order.counts()[0] : table.size) * field.bytes();
  }

  // HDF5 lays out the file, and the values go into it by our own hand: once one of its own writes
  // has failed, HDF5 1.10 can neither close the file nor leave the process alive. The space that
  // its few tables need, with a mebibyte to spare, is therefore looked for before.
  AtomicFile target(file);
  target.reserve(total + (1 << 20));
  HDF5File layout(target.path(), file);
  writeHeader(order, table.madeUp, layout);
  writeComponents(table.components, layout);
  const std::vector<Extent> extents = makeGroups(order, fields, layout);
  layout.close();

  ExportProgress done(progress, static_cast<double>(total));
  for (const Extent& extent : extents)
  {
    writeValues(order, extent, target, done);
  }
  target.commit();
}
} // namespace galaxy
