#ifndef galaxy_GadgetHDF5_h
#define galaxy_GadgetHDF5_h

#include "Filters/Export/ExportProgress.h"
#include "Filters/Export/ParticleTable.h"

#include <string>

namespace galaxy
{
/// Writes a snapshot in Gadget's HDF5 form: the group Header with Gadget's attributes, a group
/// PartTypeN for each type that occurs (see gadgetTypeOf) with the datasets Coordinates,
/// Velocities, ParticleIDs, Masses (also named Intensity), SmoothingLength, Component, Color, where
/// there are such arrays Emission and Absorption, of gas InternalEnergy and Density; and the group
/// Components, one row a component: Name, Absorbs, Absorption (RGB_A), Size, Brightness,
/// ParticleType.
void writeGadgetHDF5(
  const ParticleTable& table, const std::string& file, const std::function<bool(double)>& progress);
} // namespace galaxy

#endif
