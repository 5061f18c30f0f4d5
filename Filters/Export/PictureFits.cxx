#include "Filters/Export/PictureFits.h"

#include "Filters/Export/AtomicFile.h"
#include "Filters/Export/ExportProgress.h"
#include "Filters/Export/PictureCoordinates.h"
#include "Readers/Formats/Error.h"

#include <fitsio.h>

#include <cstdlib>
#include <vector>

namespace galaxy
{
namespace
{
/// A FITS file that CFITSIO makes in memory.
class FitsInMemory
{
public:
  explicit FitsInMemory(const std::string& file)
    : file(file)
  {
    fits_create_memfile(
      &this->handle, &this->memory, &this->size, 1 << 20, std::realloc, &this->status);
    this->check();
  }
  ~FitsInMemory()
  {
    int ignored = 0;
    if (this->handle)
    {
      fits_close_file(this->handle, &ignored);
    }
    std::free(this->memory);
  }
  FitsInMemory(const FitsInMemory&) = delete;
  FitsInMemory& operator=(const FitsInMemory&) = delete;

  void key(const char* name, const std::string& value, const char* comment)
  {
    fits_write_key_str(this->handle, name, value.c_str(), comment, &this->status);
  }
  void key(const char* name, double value, const char* comment)
  {
    fits_write_key_dbl(this->handle, name, value, -15, comment, &this->status);
  }
  void key(const char* name, int value, const char* comment)
  {
    fits_write_key_lng(this->handle, name, value, comment, &this->status);
  }
  /// The next HDU: a cube of three planes, or without pixels.
  void image(int width, int height)
  {
    long axes[3] = { width, height, 3 };
    fits_create_img(
      this->handle, width > 0 ? FLOAT_IMG : BYTE_IMG, width > 0 ? 3 : 0, axes, &this->status);
    this->check();
  }
  void plane(int channel, std::vector<float>& values)
  {
    const auto count = static_cast<LONGLONG>(values.size());
    fits_write_img(this->handle, TFLOAT, channel * count + 1, count, values.data(), &this->status);
    this->check();
  }
  void save(AtomicFile& to)
  {
    LONGLONG end = 0;
    fits_flush_file(this->handle, &this->status);
    fits_get_hduaddrll(this->handle, nullptr, nullptr, &end, &this->status);
    this->check();
    to.write(this->memory, static_cast<std::size_t>(end));
  }

private:
  void check() const
  {
    if (this->status != 0)
    {
      char text[FLEN_STATUS];
      fits_get_errstatus(this->status, text);
      throw NotWritten(this->file, text);
    }
  }

  std::string file;
  fitsfile* handle = nullptr;
  void* memory = nullptr;
  std::size_t size = 0;
  int status = 0;
};

void writeVector(FitsInMemory& fits, const std::string& name, const Vec3& v, const char* comment)
{
  fits.key((name + "X").c_str(), v.x, comment);
  fits.key((name + "Y").c_str(), v.y, comment);
  fits.key((name + "Z").c_str(), v.z, comment);
}

/// X to the West, Y to the North, Z toward the observer.
void writeCamera(FitsInMemory& fits, const PictureCamera& camera)
{
  const bool isFlat = camera.projection == "Camera";
  fits.key("CAMPROJ", isFlat ? camera.parallel ? "Parallel" : "Perspective" : camera.projection,
    "projection of the camera");
  writeVector(fits, "CAMPOS", camera.position, "[kpc] the eye; X West, Y North, Z to Earth");
  writeVector(fits, "CAMFOC", camera.focalPoint, "[kpc] what the eye looks at");
  writeVector(fits, "CAMUP", camera.viewUp, "direction that is up");
  if (isFlat && camera.parallel)
  {
    fits.key("CAMSCALE", camera.parallelScale, "[kpc] half the height of the picture");
  }
  else if (isFlat)
  {
    fits.key("CAMANGLE", camera.viewAngle, "[deg] vertical field");
  }
  else if (camera.projection == "Dome")
  {
    fits.key("CAMANGLE", camera.domeAngle, "[deg] field across the picture");
  }
}

void writeCelestial(FitsInMemory& fits, const PictureCoordinates& c)
{
  fits.key("WCSAXES", 3, "");
  fits.key("RADESYS", "ICRS", "");
  fits.key("CTYPE1", "RA---TAN", "right ascension, gnomonic");
  fits.key("CTYPE2", "DEC--TAN", "declination, gnomonic");
  fits.key("CTYPE3", "CHANNEL", "1 red, 2 green, 3 blue");
  fits.key("CUNIT1", "deg", "");
  fits.key("CUNIT2", "deg", "");
  fits.key("CRVAL1", c.reference.ra, "[deg]");
  fits.key("CRVAL2", c.reference.dec, "[deg]");
  fits.key("CRVAL3", 1.0, "");
  fits.key("CRPIX1", c.pixel.x, "");
  fits.key("CRPIX2", c.pixel.y, "");
  fits.key("CRPIX3", 1.0, "");
  fits.key("CD1_1", c.cd[0][0], "");
  fits.key("CD1_2", c.cd[0][1], "");
  fits.key("CD2_1", c.cd[1][0], "");
  fits.key("CD2_2", c.cd[1][1], "");
  fits.key("CD3_3", 1.0, "");
}

void writeOrigin(FitsInMemory& fits, const LightPicture& picture)
{
  if (picture.sky && !picture.sky->name.empty())
  {
    fits.key("OBJECT", picture.sky->name, "");
  }
  if (picture.sky)
  {
    fits.key("DISTANCE", picture.sky->distance, "[kpc] of the galaxy");
  }
  if (picture.camera)
  {
    writeCamera(fits, *picture.camera);
  }
}

void writeChannels(
  FitsInMemory& fits, const float* values, std::size_t pixels, ExportProgress& progress)
{
  std::vector<float> plane(pixels);
  for (int c = 0; c < 3; ++c)
  {
    for (std::size_t i = 0; i < pixels; ++i)
    {
      plane[i] = values[3 * i + c];
    }
    fits.plane(c, plane);
    progress.advance(1);
  }
}
} // namespace

void writePictureFits(
  const LightPicture& picture, const std::string& file, const std::function<bool(double)>& report)
{
  AtomicFile target(file);
  ExportProgress progress(report, 6);
  FitsInMemory fits(file);
  const auto celestial = coordinatesOf(picture);
  fits.image(0, 0);
  writeOrigin(fits, picture);
  const auto extension = [&](const char* name, const char* unit, const char* meaning,
                           const float* values) {
    fits.image(picture.width, picture.height);
    fits.key("EXTNAME", name, meaning);
    fits.key("BUNIT", unit, *unit ? "luminosity, as particles have it, over area" : "");
    writeOrigin(fits, picture);
    if (celestial)
    {
      writeCelestial(fits, *celestial);
    }
    writeChannels(fits, values, picture.pixels(), progress);
  };
  extension("RADIANCE", "kpc-2", "linear light over black; planes: R, G, B", picture.radiance);
  extension("TRANSMITTANCE", "", "share of a light behind; planes: R, G, B", picture.transmittance);
  fits.save(target);
  target.commit();
}
} // namespace galaxy
