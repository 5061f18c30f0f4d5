#include "Filters/Export/HDF5File.h"

#include "Filters/Export/AtomicFile.h"

#include <algorithm>

namespace galaxy
{
template <>
hid_t hdf5Type<std::uint8_t>()
{
  return H5T_NATIVE_UINT8;
}
template <>
hid_t hdf5Type<std::int32_t>()
{
  return H5T_NATIVE_INT32;
}
template <>
hid_t hdf5Type<std::uint32_t>()
{
  return H5T_NATIVE_UINT32;
}
template <>
hid_t hdf5Type<std::uint64_t>()
{
  return H5T_NATIVE_UINT64;
}
template <>
hid_t hdf5Type<double>()
{
  return H5T_NATIVE_DOUBLE;
}

namespace
{
/// UTF-8 of a fixed length, padded with zeros; HDF5 has no type of length 0.
hid_t textType(std::size_t length)
{
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, std::max<std::size_t>(length, 1));
  H5Tset_cset(type, H5T_CSET_UTF8);
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  return type;
}

/// Objects without the time of their making.
hid_t untimed(hid_t list)
{
  H5Pset_obj_track_times(list, false);
  return list;
}
} // namespace

HDF5File::HDF5File(const std::string& path, const std::string& name)
  : name(name)
{
  // Errors are thrown here; the library's own report on stderr is given back by the destructor.
  H5Eget_auto2(H5E_DEFAULT, &this->printer, &this->printerData);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  HDF5Handle list(untimed(H5Pcreate(H5P_FILE_CREATE)), H5Pclose);
  // By C streams: HDF5's own descriptors resolve links first, and what a file without a name is
  // reached by is one. What is being written has a lock already.
  HDF5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_fapl_stdio(access);
#if H5_VERSION_GE(1, 10, 7) && !(H5_VERS_MINOR == 12 && H5_VERS_RELEASE == 0)
  H5Pset_file_locking(access, false, true);
#endif
  this->file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, list, access);
  if (this->file < 0)
  {
    H5Eset_auto2(H5E_DEFAULT, this->printer, this->printerData);
    throw NotWritten(name, "HDF5 cannot create it");
  }
}

HDF5File::~HDF5File()
{
  if (this->file >= 0)
  {
    H5Fclose(this->file);
  }
  H5Eset_auto2(H5E_DEFAULT, this->printer, this->printerData);
}

void HDF5File::makeGroup(const std::string& group)
{
  HDF5Handle list(untimed(H5Pcreate(H5P_GROUP_CREATE)), H5Pclose);
  HDF5Handle made(H5Gcreate2(this->file, group.c_str(), H5P_DEFAULT, list, H5P_DEFAULT), H5Gclose);
  this->check(made, "group " + group);
}

void HDF5File::setAttribute(const std::string& object, const char* name, const std::string& text)
{
  HDF5Handle type(textType(text.size()), H5Tclose);
  this->writeAttribute(object, name, type, 1, text.c_str());
}

void HDF5File::addDataset(const std::string& dataset, const std::vector<std::string>& texts)
{
  std::size_t length = 1;
  for (const std::string& text : texts)
  {
    length = std::max(length, text.size());
  }
  std::string padded;
  for (const std::string& text : texts)
  {
    padded += text + std::string(length - text.size(), '\0');
  }
  HDF5Handle type(textType(length), H5Tclose);
  this->writeDataset(dataset, type, texts.size(), 1, padded.data());
}

std::uint64_t HDF5File::addEmptyDataset(
  const std::string& dataset, hid_t type, std::uint64_t rows, int channels)
{
  HDF5Handle made(this->createDataset(dataset, type, rows, channels), H5Dclose);
  const haddr_t offset = H5Dget_offset(made);
  this->check(offset == HADDR_UNDEF ? -1 : 0, "space for " + dataset);
  return offset;
}

void HDF5File::link(const std::string& dataset, const std::string& alias)
{
  this->check(H5Lcreate_hard(
                this->file, dataset.c_str(), this->file, alias.c_str(), H5P_DEFAULT, H5P_DEFAULT),
    "link " + alias);
}

void HDF5File::close()
{
  const herr_t status = H5Fclose(this->file);
  this->file = -1;
  this->check(status, "its end");
}

void HDF5File::writeAttribute(
  const std::string& object, const char* name, hid_t type, hsize_t count, const void* values)
{
  HDF5Handle space(
    count == 1 ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &count, nullptr), H5Sclose);
  HDF5Handle attribute(H5Acreate_by_name(this->file, object.c_str(), name, type, space, H5P_DEFAULT,
                         H5P_DEFAULT, H5P_DEFAULT),
    H5Aclose);
  this->check(attribute, std::string("attribute ") + name);
  this->check(H5Awrite(attribute, type, values), std::string("attribute ") + name);
}

void HDF5File::writeDataset(
  const std::string& dataset, hid_t type, hsize_t rows, int channels, const void* values)
{
  HDF5Handle made(this->createDataset(dataset, type, rows, channels), H5Dclose);
  this->check(H5Dwrite(made, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), dataset);
}

hid_t HDF5File::createDataset(const std::string& dataset, hid_t type, hsize_t rows, int channels)
{
  const hsize_t shape[2] = { rows, static_cast<hsize_t>(channels) };
  HDF5Handle space(H5Screate_simple(channels == 1 ? 1 : 2, shape, nullptr), H5Sclose);
  HDF5Handle list(untimed(H5Pcreate(H5P_DATASET_CREATE)), H5Pclose);
  H5Pset_alloc_time(list, H5D_ALLOC_TIME_EARLY);
  H5Pset_fill_time(list, H5D_FILL_TIME_NEVER);
  const hid_t made =
    H5Dcreate2(this->file, dataset.c_str(), type, space, H5P_DEFAULT, list, H5P_DEFAULT);
  this->check(made, dataset);
  return made;
}

void HDF5File::check(std::int64_t status, const std::string& what) const
{
  if (status < 0)
  {
    throw NotWritten(this->name, "HDF5 cannot write " + what);
  }
}
} // namespace galaxy
