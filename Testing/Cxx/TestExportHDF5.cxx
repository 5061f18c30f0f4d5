#include "Filters/Export/HDF5File.h"
#include "Testing/Cxx/ExportFixtures.h"

namespace galaxy::testing
{
namespace
{
using TestExportHDF5 = ExportFolder;

template <typename T>
std::vector<T> read(const std::string& file, const std::string& dataset, hid_t type)
{
  HDF5Handle id(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  HDF5Handle data(H5Dopen2(id, dataset.c_str(), H5P_DEFAULT), H5Dclose);
  HDF5Handle space(H5Dget_space(data), H5Sclose);
  std::vector<T> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  EXPECT_GE(H5Dread(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0) << dataset;
  return values;
}
} // namespace

TEST_F(TestExportHDF5, EveryArrayOfEveryType)
{
  const Particles particles = mixedParticles(150000);
  const std::string file = this->path("model.hdf5");
  ASSERT_TRUE(exportTo(file, tableOf(particles), ParticleFormat::GadgetHDF5));
  EXPECT_EQ(this->filesThere(), 1u);
  const std::vector<std::pair<std::string, int>> groups = { { "PartType0/", 1 },
    { "PartType2/", 0 }, { "PartType3/", 3 }, { "PartType5/", 2 } };
  for (const auto& [group, component] : groups)
  {
    std::vector<float> position, velocity, h, intensity;
    std::vector<std::uint8_t> color;
    std::vector<std::uint32_t> ids;
    const std::vector<std::size_t> order = gadgetOrder(particles, { component });
    for (const std::size_t i : order)
    {
      position.insert(position.end(), &particles.position[3 * i], &particles.position[3 * i] + 3);
      velocity.insert(velocity.end(), &particles.velocity[3 * i], &particles.velocity[3 * i] + 3);
      color.insert(color.end(), &particles.color[3 * i], &particles.color[3 * i] + 3);
      h.push_back(particles.smoothingLength[i]);
      intensity.push_back(particles.intensity[i]);
      ids.push_back(static_cast<std::uint32_t>(i + 1));
    }
    EXPECT_EQ(read<float>(file, group + "Coordinates", H5T_NATIVE_FLOAT), position);
    EXPECT_EQ(read<float>(file, group + "Velocities", H5T_NATIVE_FLOAT), velocity);
    EXPECT_EQ(read<float>(file, group + "Masses", H5T_NATIVE_FLOAT), intensity);
    EXPECT_EQ(read<float>(file, group + "Intensity", H5T_NATIVE_FLOAT), intensity);
    EXPECT_EQ(read<float>(file, group + "SmoothingLength", H5T_NATIVE_FLOAT), h);
    EXPECT_EQ(read<std::uint8_t>(file, group + "Color", H5T_NATIVE_UINT8), color);
    EXPECT_EQ(read<std::uint8_t>(file, group + "Component", H5T_NATIVE_UINT8),
      std::vector<std::uint8_t>(order.size(), static_cast<std::uint8_t>(component)));
    EXPECT_EQ(read<std::uint32_t>(file, group + "ParticleIDs", H5T_NATIVE_UINT32), ids);
  }
}

TEST_F(TestExportHDF5, TheComponentTable)
{
  const Particles particles = mixedParticles(10);
  const std::string file = this->path("model.hdf5");
  ASSERT_TRUE(exportTo(file, tableOf(particles), ParticleFormat::GadgetHDF5));
  EXPECT_EQ(read<std::uint8_t>(file, "Components/Absorbs", H5T_NATIVE_UINT8),
    std::vector<std::uint8_t>({ 0, 0, 1, 0 }));
  EXPECT_EQ(read<std::int32_t>(file, "Components/ParticleType", H5T_NATIVE_INT32),
    std::vector<std::int32_t>({ 2, 0, 5, 3 }));
  EXPECT_EQ(read<double>(file, "Components/Absorption", H5T_NATIVE_DOUBLE),
    std::vector<double>({ 1, 1, 1, 1, 1, 1, 0.8, 1.0, 1.3, 1, 1, 1 }));
  EXPECT_EQ(read<double>(file, "Components/Brightness", H5T_NATIVE_DOUBLE),
    std::vector<double>({ 1, 1, 1, 2.5 }));
}

TEST_F(TestExportHDF5, TheSameParticlesGiveTheSameBytes)
{
  const Particles particles = mixedParticles(1000);
  ASSERT_TRUE(exportTo(this->path("a.h5"), tableOf(particles), ParticleFormat::GadgetHDF5));
  ASSERT_TRUE(exportTo(this->path("b.h5"), tableOf(particles), ParticleFormat::GadgetHDF5));
  EXPECT_TRUE(contentOf(this->path("a.h5")) == contentOf(this->path("b.h5")));
}
} // namespace galaxy::testing
