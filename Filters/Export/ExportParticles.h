#ifndef galaxy_ExportParticles_h
#define galaxy_ExportParticles_h

#include "Filters/Export/ParticleTable.h"

#include <cstdint>
#include <functional>
#include <string>

namespace galaxy
{
enum class ParticleFormat
{
  Gadget1,    ///< Gadget-2 binary, blocks without names
  Gadget2,    ///< Gadget-2 binary, blocks with names
  GadgetHDF5, ///< Gadget's HDF5
  CSV
};

/// By the file's extension, without regard to case: .g1; .gad, .gadget, .g2; .hdf5, .h5; .csv.
/// Throws Error where it is none of these.
ParticleFormat formatOfFile(const std::string& file);

struct ExportOptions
{
  ParticleFormat format = ParticleFormat::Gadget2;
  /// Gets the fraction done and returns whether to go on; may be empty.
  std::function<bool(double)> progress;
  /// Bytes; a binary Gadget snapshot with larger blocks is split into several files.
  std::uint64_t largestBlock = 2147483647;
};

/// Writes particles for other programs, whole or not at all, with a few MiB of memory. False where
/// options.progress asked to stop; then nothing is left behind. Throws Error naming the file where
/// it cannot be written, and the particle (from 0) where a position is not finite or a component
/// is not in the table.
bool exportParticles(
  const ParticleTable& table, const std::string& file, const ExportOptions& options);
} // namespace galaxy

#endif
