// Where memory is not to be had nothing is read, built or written, and nothing else happens.
#include "Filters/Model/GroupBuilder.h"
#include "Filters/Model/SmoothingLength.h"
#include "Readers/Formats/BadPixels.h"
#include "Readers/Formats/Brightness.h"
#include "Testing/Cxx/ExportFixtures.h"
#include "Testing/Cxx/FailingMemory.h"
#include "Testing/Cxx/FitsFixtures.h"

#include <omp.h>

namespace galaxy::testing
{
namespace
{
constexpr long tries = 40;

const char* const head = R"(
[galaxy]
name = 'NAME'
ra = 204.25
dec = -29.87
distance = 4.9
rings = 'model.rings'
[image.sharp]
file = 'sharp.fits'
beam = 30
background = 'Auto'
mask_stars_above = 3
regions = 'bad.reg'
unit = 'MJy/sr'
[image.wide]
file = 'wide.fits'
beam = 60
unit = 'MJy/sr'
[image.all]
combine = ['sharp', 'wide']
)";

const char* const stars = R"(
[[component]]
name = 'stars'
particles = 300
layers = [{ image = 'all', clip = [0, 1] }]
deredden = 'dust'
velocity_dispersion = 10
[component.thickness]
model = 'Tapered'
children = 3
[[component]]
name = 'bulge'
type = 'Spheroid'
particles = 100
[component.spheroid]
profile = 'Plummer'
light_from = 'stars'
light_fraction = 0.1
[[component]]
name = 'dust'
role = 'Absorbs'
particles = 50
layers = [{ image = 'wide' }]
calibration = 'PAH8um'
[component.dust]
model = 'DiskRotation'
steps = 5
)";

const char* const gas = R"(
[[component]]
name = 'gas'
particles = 'Auto'
noise = 0.5
layers = [{ image = 'wide', clip_percentile = [1, 99] }]
[component.thickness]
model = 'Flared'
profile_table = 'widths.txt'
[component.smoothing]
model = 'Neighbours'
[[component]]
name = 'young'
particles = 200
sampling = 'SurfaceUniform'
normalize_at = 'Seed'
layers = [{ image = 'wide' }]
[component.thickness]
model = 'Hydrostatic'
[component.smoothing]
model = 'Brightness'
length = 0.1
[[component]]
name = 'old'
particles = 200
profile = 'Exponential'
scale_length = 2
[[component]]
name = 'clouds'
role = 'Absorbs'
particles = 60
layers = [{ image = 'wide' }]
[component.dust]
model = 'Fractal'
[[component]]
name = 'clusters'
type = 'Spheroid'
particles = 100
[component.spheroid]
profile = 'Sersic'
clusters = 7
)";

/// A folder of a galaxy, its images and its tables.
class TestMemoryOfModels : public FitsFolder
{
protected:
  void SetUp() override
  {
    FitsFolder::SetUp();
    omp_set_num_threads(3);
    this->picture("sharp.fits", 24, 5);
    this->picture("wide.fits", 12, 10);
    this->text("model.rings", "# radius vrot incl pa z0\n0 100 20 10 10\n90 150 30 20 10\n");
    this->text("widths.txt", "0 0.2\n1 0.3\n");
    this->text("bad.reg", "fk5\ncircle(204.25,-29.87,4\")\n");
    this->text("stars.galaxy", this->named("stars") + stars);
    this->text("gas.galaxy", this->named("gas") + gas);
  }

  std::string text(const std::string& name, const std::string& text) const
  {
    std::ofstream(this->path(name)) << text;
    return this->path(name);
  }

private:
  static std::string named(const std::string& name)
  {
    std::string text = head;
    return text.replace(text.find("NAME"), 4, name);
  }

  void picture(const std::string& name, int size, double pixel) const
  {
    std::vector<double> values;
    for (int k = 0; k < size * size; ++k)
    {
      const double r = std::hypot(k % size - size / 2.0, k / size - size / 2.0);
      values.push_back(std::exp(-r / size) + (k == 70 ? 20 : 0));
    }
    this->write(name, [&](fitsfile* file, int* status) {
      addImage(file, FLOAT_IMG, values, status, { size, size });
      const auto number = [&](const char* key, double value) {
        fits_write_key_dbl(file, key, value, 12, nullptr, status);
      };
      number("CRPIX1", size / 2.0);
      number("CRPIX2", size / 2.0);
      number("CRVAL1", 204.25);
      number("CRVAL2", -29.87);
      number("CDELT1", -pixel / 3600);
      number("CDELT2", pixel / 3600);
      fits_write_key_str(file, "CTYPE1", "RA---TAN", nullptr, status);
      fits_write_key_str(file, "CTYPE2", "DEC--TAN", nullptr, status);
    });
  }
};

bool isPositive(double value)
{
  return value > 0;
}

std::vector<float> allOf(const Particles& particles)
{
  std::vector<float> all;
  for (const Buffer<float>* values :
    { &particles.position, &particles.smoothingLength, &particles.intensity, &particles.velocity })
  {
    all.insert(all.end(), values->begin(), values->end());
  }
  return all;
}

/// But for the .galaxy file, in which toml++ ends the program (see KeyTable.cxx).
TEST_F(TestMemoryOfModels, Reading)
{
  for (const char* name : { "stars.galaxy", "gas.galaxy" })
  {
    SCOPED_TRACE(name);
    const std::string file = this->path(name);
    const GalaxyDescription description = readGalaxyDescription(file);
    expectToSurvive([&] { return readRings(description).rings.size(); }, tries);
    for (const ImageDescription* image : { &description.images[0], &description.images[1] })
    {
      expectToSurvive(
        [&] {
          Image read = readFitsImage(besideFile(file, image->file), image->selection);
          markBadPixels(*image, file, read);
          convertBrightness(*image, read);
          return std::count_if(read.values.begin(), read.values.end(), isPositive);
        },
        tries);
    }
  }
}

TEST_F(TestMemoryOfModels, Building)
{
  BuildOptions options;
  options.velocities = true;
  for (const char* name : { "stars.galaxy", "gas.galaxy" })
  {
    SCOPED_TRACE(name);
    const Galaxy galaxy = readGalaxy(this->path(name));
    expectToSurvive([&] { return allOf(buildGalaxy(galaxy, options)); }, tries);
  }
}

TEST_F(TestMemoryOfModels, Merging)
{
  std::vector<Particles> galaxies;
  galaxies.push_back(mixedParticles(500));
  galaxies.push_back(mixedParticles(700, false));
  expectToSurvive([&] { return allOf(mergeParticles(galaxies, { "a", "b" })); }, tries);
}

TEST_F(TestMemoryOfModels, SmoothingOfManyParticles)
{
  const Particles particles = mixedParticles(3000);
  Buffer<float> h(particles.size());
  for (const SmoothingModel model : { SmoothingModel::Density, SmoothingModel::Neighbours })
  {
    SmoothingDescription smoothing;
    smoothing.model = model;
    expectToSurvive(
      [&] {
        smoothingLengths(particles.position.data(), particles.intensity.data(), particles.size(),
          smoothing, h.data(), {});
        return std::vector<float>(h.begin(), h.end());
      },
      tries);
  }
}

class TestMemoryOfParticleFiles : public ExportFolder
{
};

TEST_F(TestMemoryOfParticleFiles, EveryFormat)
{
  omp_set_num_threads(3);
  const Particles particles = mixedParticles(3000);
  for (const ParticleFormat format : { ParticleFormat::Gadget1, ParticleFormat::Gadget2,
         ParticleFormat::GadgetHDF5, ParticleFormat::CSV })
  {
    SCOPED_TRACE(static_cast<int>(format));
    const std::string file = this->path("particles");
    expectToSurvive([&] { return exportTo(file, tableOf(particles), format); }, tries);
    EXPECT_EQ(this->filesThere(), 1u);
    std::filesystem::remove(file);
  }
}
} // namespace
} // namespace galaxy::testing
