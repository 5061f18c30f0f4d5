#ifndef galaxy_HDF5File_h
#define galaxy_HDF5File_h

#include <hdf5.h>

#include <cstdint>
#include <string>
#include <vector>

namespace galaxy
{
/// An identifier of the HDF5 library, closed with the object.
class HDF5Handle
{
public:
  HDF5Handle(hid_t id, herr_t (*closeId)(hid_t))
    : id(id)
    , closeId(closeId)
  {
  }
  ~HDF5Handle() { this->close(); }
  HDF5Handle(const HDF5Handle&) = delete;
  HDF5Handle& operator=(const HDF5Handle&) = delete;

  operator hid_t() const { return this->id; }
  /// Negative where closing failed.
  herr_t close()
  {
    const herr_t status = this->id >= 0 ? this->closeId(this->id) : 0;
    this->id = -1;
    return status;
  }

private:
  hid_t id;
  herr_t (*closeId)(hid_t);
};

/// The HDF5 type in memory and on disk of a C++ type.
template <typename T>
hid_t hdf5Type();

/// A new HDF5 file. Every function throws Error naming the file and what could not be done.
/// Neither its bytes nor its size depend on the time of day.
class HDF5File
{
public:
  /// Creates `path`; errors speak of `name`.
  HDF5File(const std::string& path, const std::string& name);
  ~HDF5File();

  void makeGroup(const std::string& group);

  /// An attribute of a group or dataset: one value where `values` holds one, else an array.
  template <typename T>
  void setAttribute(const std::string& object, const char* name, const std::vector<T>& values)
  {
    this->writeAttribute(object, name, hdf5Type<T>(), values.size(), values.data());
  }
  void setAttribute(const std::string& object, const char* name, const std::string& text);

  /// A small dataset with its values, `channels` numbers in a row.
  template <typename T>
  void addDataset(const std::string& dataset, const std::vector<T>& values, int channels = 1)
  {
    this->writeDataset(dataset, hdf5Type<T>(), values.size() / channels, channels, values.data());
  }
  void addDataset(const std::string& dataset, const std::vector<std::string>& texts);

  /// A dataset whose values are still to be written, one behind the other in the machine's byte
  /// order, from the returned byte of the file on.
  std::uint64_t addEmptyDataset(
    const std::string& dataset, hid_t type, std::uint64_t rows, int channels);

  /// A second name of a dataset.
  void link(const std::string& dataset, const std::string& alias);

  void close();

private:
  void writeAttribute(
    const std::string& object, const char* name, hid_t type, hsize_t count, const void* values);
  void writeDataset(
    const std::string& dataset, hid_t type, hsize_t rows, int channels, const void* values);
  hid_t createDataset(const std::string& dataset, hid_t type, hsize_t rows, int channels);
  void check(std::int64_t status, const std::string& what) const;

  std::string name;
  H5E_auto2_t printer = nullptr;
  void* printerData = nullptr;
  hid_t file = -1;
};
} // namespace galaxy

#endif
