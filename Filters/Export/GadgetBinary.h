#ifndef galaxy_GadgetBinary_h
#define galaxy_GadgetBinary_h

#include "Filters/Export/ExportProgress.h"
#include "Filters/Export/GadgetTypes.h"

#include <array>
#include <cstdint>
#include <string>

namespace galaxy
{
/// The header of a Gadget-2 snapshot (V. Springel, The cosmological simulation code GADGET-2,
/// users' guide, table 4), byte for byte. Particle masses stand in their own block: mass is 0. A
/// model has no time and lies in no box and no expanding universe.
struct GadgetHeader
{
  std::uint32_t npart[gadgetTypes] = {}; ///< in this file
  double mass[gadgetTypes] = {};
  double time = 0;
  double redshift = 0;
  std::int32_t flagSfr = 0;
  std::int32_t flagFeedback = 0;
  std::uint32_t npartTotal[gadgetTypes] = {}; ///< in all files, low 32 bits
  std::int32_t flagCooling = 0;
  std::int32_t numFiles = 1;
  double boxSize = 0;
  double omega0 = 0;
  double omegaLambda = 0;
  double hubbleParam = 1;
  std::int32_t flagStellarAge = 0;
  std::int32_t flagMetals = 0;
  std::uint32_t npartTotalHighWord[gadgetTypes] = {};
  std::int32_t flagEntropyInsteadU = 0;
  std::uint8_t unused[60] = {};
};
static_assert(sizeof(GadgetHeader) == 256);

/// A record's length is a signed 32-bit number to the Fortran programs that read it.
constexpr std::uint64_t largestGadgetBlock = 2147483647;

/// Writes a snapshot of format 2, whose blocks have names, or 1, whose blocks have not: POS, VEL,
/// ID, MASS, of gas U and RHO, HSML, COMP (component), COL (RGB_s, 0 to 255) and, where there are
/// such arrays, EMIS and ABSO; numbers in the machine's own byte order. Where a block were larger
/// than `largestBlock` bytes the snapshot is split, as Gadget does, into file.0, file.1 and so on,
/// each with its share of every type. All files appear or none does, and those go that an earlier
/// snapshot of this name, split otherwise, has left.
void writeGadgetBinary(const ParticleTable& table, const std::string& file, int format,
  std::uint64_t largestBlock, const std::function<bool(double)>& progress);
} // namespace galaxy

#endif
