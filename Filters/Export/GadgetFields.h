#ifndef galaxy_GadgetFields_h
#define galaxy_GadgetFields_h

#include "Filters/Export/ParticleTable.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace galaxy
{
enum class Element
{
  UInt8,
  UInt32,
  UInt64,
  Float32
};
std::size_t bytesOf(Element element);

/// One quantity of the particles as the Gadget formats store it.
struct GadgetField
{
  std::string block;   ///< four letters: its name in a binary file of format 2
  std::string dataset; ///< its name in an HDF5 file
  std::string unit;
  Element element;
  int channels;
  bool gasOnly; ///< of Gadget's type 0 alone
  /// Puts the values of `count` particles one after the other into `to`.
  std::function<void(const std::size_t* particles, std::size_t count, char* to)> gather;

  std::size_t bytes() const { return this->channels * bytesOf(this->element); }
};

/// The fields in Gadget's order, then ours: those of one channel first, because splash ends at the
/// first block that it does not know to be a vector. Particle numbers are the indices + 1.
///
/// Gas has an internal energy of 0 and the density of a sphere of radius h that holds the
/// particle's intensity, so that line integrals of the density are those of the intensity.
///
/// With `smallIntegers` Color and Component are bytes, else float32 of the same value, the one type
/// that readers of the binary formats know. `table` must outlive the fields.
std::vector<GadgetField> gadgetFields(const ParticleTable& table, bool smallIntegers);

/// 64-bit particle numbers where 32 bits do not suffice.
Element elementOfIds(std::size_t particles);
} // namespace galaxy

#endif
