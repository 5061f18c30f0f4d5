#include "Filters/Export/GadgetBinary.h"
#include "Filters/Export/GadgetFields.h"
#include "Filters/Export/GadgetTypes.h"
#include "Testing/Cxx/ExportFixtures.h"

#include <map>

namespace galaxy::testing
{
namespace
{
using TestExportGadget = ExportFolder;

template <typename T>
void append(std::string& bytes, const std::vector<T>& values)
{
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

/// A record of format 2 with its name's record before it, or of format 1.
template <typename T>
void appendRecord(std::string& file, const std::string& name, const std::vector<T>& values)
{
  const auto bytes = static_cast<std::int32_t>(values.size() * sizeof(T));
  if (!name.empty())
  {
    append<std::int32_t>(file, { 8 });
    file += name;
    append<std::int32_t>(file, { bytes + 8, 8 });
  }
  append<std::int32_t>(file, { bytes });
  append(file, values);
  append<std::int32_t>(file, { bytes });
}

/// The header as the user's guide tabulates it.
std::string header(const std::vector<std::int32_t>& npart)
{
  std::string bytes;
  append(bytes, npart);
  append<double>(bytes, { 0, 0, 0, 0, 0, 0, /* time, redshift */ 0, 0 });
  append<std::int32_t>(bytes, { /* SFR, feedback */ 0, 0 });
  append(bytes, npart);
  append<std::int32_t>(bytes, { /* cooling */ 0, /* files */ 1 });
  append<double>(bytes, { /* box */ 0, /* Omega0, OmegaLambda */ 0, 0, /* h */ 1 });
  append<std::int32_t>(bytes, { /* age, metals */ 0, 0, /* high words */ 0, 0, 0, 0, 0, 0 });
  append<std::int32_t>(bytes, { /* entropy */ 0 });
  bytes.resize(256, '\0');
  return bytes;
}

/// One gas particle, given second, and one of the stars.
ParticleTable twoParticles()
{
  static const float position[6] = { 1, 2, 3, -4, 5, 0.1f };
  static const float h[2] = { 0.5f, 2 };
  static const float intensity[2] = { 7, 8 };
  static const std::uint8_t color[6] = { 1, 2, 3, 250, 251, 255 };
  static const std::uint8_t component[2] = { 0, 1 };
  ParticleTable table;
  table.size = 2;
  table.position = position;
  table.smoothingLength = h;
  table.intensity = intensity;
  table.color = color;
  table.component = component;
  table.components.resize(2);
  table.components[0].name = "stars";
  table.components[1].name = "HI gas";
  return table;
}

std::string expected(bool named)
{
  const auto name = [named](const char* block) { return std::string(named ? block : ""); };
  std::string file;
  const std::string head = header({ 1, 0, 1, 0, 0, 0 });
  appendRecord(file, name("HEAD"), std::vector<char>(head.begin(), head.end()));
  appendRecord<float>(file, name("POS "), { -4, 5, 0.1f, 1, 2, 3 });
  appendRecord<float>(file, name("VEL "), { 0, 0, 0, 0, 0, 0 });
  appendRecord<std::uint32_t>(file, name("ID  "), { 2, 1 });
  appendRecord<float>(file, name("MASS"), { 8, 7 });
  appendRecord<float>(file, name("U   "), { 0 });
  // 8 in a sphere of radius 2.
  appendRecord<float>(file, name("RHO "), { 8 / (4 * 3.14159265358979f / 3 * 8) });
  appendRecord<float>(file, name("HSML"), { 2, 0.5f });
  appendRecord<float>(file, name("COMP"), { 1, 0 });
  appendRecord<float>(file, name("COL "), { 250, 251, 255, 1, 2, 3 });
  return file;
}

using Blocks = std::map<std::string, std::string>;

/// The blocks of a file of format 2 by their names.
Blocks readBlocks(const std::string& file)
{
  const std::string bytes = contentOf(file);
  Blocks blocks;
  std::size_t at = 0;
  while (at + 16 <= bytes.size())
  {
    const std::string name = bytes.substr(at + 4, 4);
    std::uint32_t length = 0;
    std::memcpy(&length, bytes.data() + at + 16, 4);
    blocks[name] = bytes.substr(at + 20, length);
    at += 24 + length;
  }
  EXPECT_EQ(at, bytes.size());
  return blocks;
}
} // namespace

TEST_F(TestExportGadget, TwoParticlesByteForByte)
{
  ASSERT_TRUE(exportTo(this->path("one"), twoParticles(), ParticleFormat::Gadget1));
  EXPECT_EQ(contentOf(this->path("one")), expected(false));
  ASSERT_TRUE(exportTo(this->path("two"), twoParticles(), ParticleFormat::Gadget2));
  EXPECT_EQ(contentOf(this->path("two")), expected(true));
  EXPECT_EQ(this->filesThere(), 2u);
}

TEST_F(TestExportGadget, WhatIsMissingHasItsDefault)
{
  ParticleTable table;
  const float position[3] = { 1, 2, 3 };
  table.size = 1;
  table.position = position;
  ASSERT_TRUE(exportTo(this->path("bare"), table, ParticleFormat::Gadget2));
  const Blocks blocks = readBlocks(this->path("bare"));
  std::string one, zero, white;
  append<float>(one, { 1 });
  append<float>(zero, { 0 });
  append<float>(white, { 255, 255, 255 });
  EXPECT_EQ(blocks.at("MASS"), one);
  EXPECT_EQ(blocks.at("HSML"), zero);
  EXPECT_EQ(blocks.at("COMP"), zero);
  EXPECT_EQ(blocks.at("COL "), white);
  EXPECT_EQ(blocks.count("U   "), 0u); // of gas alone, and there is none
  EXPECT_EQ(blocks.count("EMIS"), 0u);
}

TEST_F(TestExportGadget, EmissionAndAbsorptionComeAlong)
{
  ParticleTable table = twoParticles();
  const float emission[6] = { 1, 2, 3, 4, 5, 6 };
  const float absorption[2] = { 7, 8 };
  table.emission = emission;
  table.absorption = absorption;
  table.absorptionChannels = 1;
  ASSERT_TRUE(exportTo(this->path("both"), table, ParticleFormat::Gadget2));
  const Blocks blocks = readBlocks(this->path("both"));
  std::string emits, absorbs;
  append<float>(emits, { 4, 5, 6, 1, 2, 3 });
  append<float>(absorbs, { 8, 7 });
  EXPECT_EQ(blocks.at("EMIS"), emits);
  EXPECT_EQ(blocks.at("ABSO"), absorbs);
}

TEST_F(TestExportGadget, ManyMixedParticlesKeepTheirOrderWithinAType)
{
  const Particles particles = mixedParticles(200000);
  ASSERT_TRUE(exportTo(this->path("many"), tableOf(particles), ParticleFormat::Gadget2));
  const Blocks blocks = readBlocks(this->path("many"));
  std::string ids, masses, velocities;
  for (const std::size_t i : gadgetOrder(particles, { 1, 0, 3, 2 }))
  {
    append<std::uint32_t>(ids, { static_cast<std::uint32_t>(i + 1) });
    append<float>(masses, { particles.intensity[i] });
    const float* v = &particles.velocity[3 * i];
    append<float>(velocities, { v[0], v[1], v[2] });
  }
  EXPECT_TRUE(blocks.at("ID  ") == ids);
  EXPECT_TRUE(blocks.at("MASS") == masses);
  EXPECT_TRUE(blocks.at("VEL ") == velocities);
}

TEST_F(TestExportGadget, LargeBlocksAreSplitOverFiles)
{
  const Particles particles = mixedParticles(1000);
  const std::uint64_t largest = 3600;
  ASSERT_TRUE(exportTo(this->path("whole"), tableOf(particles), ParticleFormat::Gadget2));
  ASSERT_TRUE(exportTo(this->path("part"), tableOf(particles), ParticleFormat::Gadget2, largest));
  ASSERT_EQ(this->filesThere(), 5u); // 1000 / (300 - 6) = 3.4
  std::string parts[gadgetTypes];    // the numbers of each type's particles
  GadgetHeader whole;
  const Blocks wholeBlocks = readBlocks(this->path("whole"));
  std::memcpy(&whole, wholeBlocks.at("HEAD").data(), 256);
  for (int k = 0; k < 4; ++k)
  {
    const Blocks blocks = readBlocks(this->path("part." + std::to_string(k)));
    GadgetHeader head;
    std::memcpy(&head, blocks.at("HEAD").data(), 256);
    EXPECT_EQ(head.numFiles, 4);
    std::size_t at = 0;
    for (int type = 0; type < gadgetTypes; ++type)
    {
      EXPECT_EQ(head.npartTotal[type], whole.npart[type]);
      parts[type] += blocks.at("ID  ").substr(at, 4 * head.npart[type]);
      at += 4 * head.npart[type];
    }
    for (const auto& [name, values] : blocks)
    {
      EXPECT_LE(values.size(), largest) << name;
    }
  }
  std::string ids;
  for (const std::string& part : parts)
  {
    ids += part;
  }
  EXPECT_EQ(ids, wholeBlocks.at("ID  "));
}

TEST(TestGadgetTypes, AbsorbersAndEmittersNeverShareAType)
{
  const auto type = [](const char* name, bool absorbs = false) {
    ComponentInfo component;
    component.name = name;
    component.absorbs = absorbs;
    return gadgetTypeOf(component);
  };
  EXPECT_EQ(type("stars"), GadgetType::Disk);
  EXPECT_EQ(type(""), GadgetType::Disk);
  EXPECT_EQ(type("young stars"), GadgetType::Stars);
  EXPECT_EQ(type("gas"), GadgetType::Gas);
  EXPECT_EQ(type("NGC 5236: H I"), GadgetType::Gas);
  EXPECT_EQ(type("Hydra"), GadgetType::Disk); // no word of it is "h"
  EXPECT_EQ(type("Stellar Halo"), GadgetType::Halo);
  EXPECT_EQ(type("bulge"), GadgetType::Bulge);
  for (const char* name : { "dust", "gas", "halo", "" })
  {
    EXPECT_EQ(type(name, true), GadgetType::Boundary);
  }
}

TEST(TestGadgetFields, ParticleNumbersGrowWithTheirCount)
{
  EXPECT_EQ(elementOfIds(4294967295u), Element::UInt32);
  EXPECT_EQ(elementOfIds(4294967296u), Element::UInt64);
}
} // namespace galaxy::testing
