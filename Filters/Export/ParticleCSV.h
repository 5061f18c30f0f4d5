#ifndef galaxy_ParticleCSV_h
#define galaxy_ParticleCSV_h

#include "Filters/Export/ExportProgress.h"
#include "Filters/Export/ParticleTable.h"

#include <string>

namespace galaxy
{
/// Writes a table of comma-separated values, a particle a line in their own order, under one line
/// of names with units: x_kpc, y_kpc, z_kpc, vx_km_s, vy_km_s, vz_km_s, smoothing_length_kpc,
/// intensity, red, green, blue (0 to 255), component (its index), absorbs (0 or 1), and where there
/// are such arrays emission and absorption. Each number is the shortest text that reads back as the
/// same float32.
void writeParticleCSV(
  const ParticleTable& table, const std::string& file, const std::function<bool(double)>& progress);
} // namespace galaxy

#endif
