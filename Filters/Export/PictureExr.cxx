#include "Filters/Export/PictureExr.h"

#include "Filters/Export/AtomicFile.h"
#include "Filters/Export/ExportProgress.h"
#include "Readers/Formats/Error.h"

#include <ImfChannelList.h>
#include <ImfDoubleAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <ImfVecAttribute.h>

#include <exception>
#include <vector>

namespace galaxy
{
namespace
{
const char* const channelNames[6] = { "R", "G", "B", "transmittance.R", "transmittance.G",
  "transmittance.B" };

/// What OpenEXR writes into. It keeps the first error, since Imf::OutputFile's destructor, which
/// writes the table of lines, tells nobody.
class ExrStream : public Imf::OStream
{
public:
  explicit ExrStream(AtomicFile& file)
    : Imf::OStream(file.name().c_str())
    , file(file)
  {
  }
  void write(const char bytes[], int count) override
  {
    try
    {
      this->file.writeAt(this->place, bytes, static_cast<std::size_t>(count));
      this->place += static_cast<std::uint64_t>(count);
    }
    catch (...)
    {
      this->problem = std::current_exception();
      throw;
    }
  }
  std::uint64_t tellp() override { return this->place; }
  void seekp(std::uint64_t to) override { this->place = to; }
  void rethrow() const
  {
    if (this->problem)
    {
      std::rethrow_exception(this->problem);
    }
  }

private:
  AtomicFile& file;
  std::uint64_t place = 0;
  std::exception_ptr problem;
};

Imath::V3d toImath(const Vec3& v)
{
  return { v.x, v.y, v.z };
}

void addCamera(const PictureCamera& camera, Imf::Header& header)
{
  const bool isFlat = camera.projection == "Camera";
  header.insert("cameraProjection",
    Imf::StringAttribute(
      isFlat ? camera.parallel ? "Parallel" : "Perspective" : camera.projection));
  header.insert("cameraPosition", Imf::V3dAttribute(toImath(camera.position)));
  header.insert("cameraFocalPoint", Imf::V3dAttribute(toImath(camera.focalPoint)));
  header.insert("cameraViewUp", Imf::V3dAttribute(toImath(camera.viewUp)));
  if (isFlat && camera.parallel)
  {
    header.insert("cameraParallelScale", Imf::DoubleAttribute(camera.parallelScale));
  }
  else if (isFlat)
  {
    header.insert("cameraViewAngle", Imf::DoubleAttribute(camera.viewAngle));
  }
}

Imf::Header headerOf(const LightPicture& picture, ExrPixel pixel)
{
  Imf::Header header(picture.width, picture.height);
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const char* name : channelNames)
  {
    header.channels().insert(name, Imf::Channel(pixel == ExrPixel::Half ? Imf::HALF : Imf::FLOAT));
  }
  header.insert("comments",
    Imf::StringAttribute("Linear light: R, G, B in luminosity per kpc^2; lengths in kpc"));
  if (picture.camera)
  {
    addCamera(*picture.camera, header);
  }
  return header;
}

/// One line of all six channels, as OpenEXR takes it.
class Line
{
public:
  Line(int width, ExrPixel pixel, const std::string& file)
    : width(width)
    , pixel(pixel)
    , file(file)
    , floats(pixel == ExrPixel::Float ? 6 * std::size_t(width) : 0)
    , halves(pixel == ExrPixel::Half ? 6 * std::size_t(width) : 0)
  {
  }
  void fill(const float* radiance, const float* transmittance)
  {
    for (int x = 0; x < 3 * this->width; ++x)
    {
      const std::size_t at = 6 * std::size_t(x / 3) + std::size_t(x % 3);
      this->set(at, radiance[x]);
      this->set(at + 3, transmittance[x]);
    }
  }
  /// Without a step from line to line: every line comes from here.
  Imf::FrameBuffer buffer()
  {
    Imf::FrameBuffer buffer;
    for (std::size_t c = 0; c < 6; ++c)
    {
      buffer.insert(channelNames[c],
        this->pixel == ExrPixel::Half
          ? Imf::Slice(Imf::HALF, reinterpret_cast<char*>(&this->halves[c]), 6 * sizeof(half), 0)
          : Imf::Slice(
              Imf::FLOAT, reinterpret_cast<char*>(&this->floats[c]), 6 * sizeof(float), 0));
    }
    return buffer;
  }

private:
  void set(std::size_t at, float value)
  {
    if (this->pixel == ExrPixel::Float)
    {
      this->floats[at] = value;
      return;
    }
    if (value > HALF_MAX)
    {
      throw Error(this->file, "",
        "light of " + std::to_string(value) +
          " is beyond half precision, which ends at 65504; use PixelType Float");
    }
    this->halves[at] = half(value);
  }

  int width;
  ExrPixel pixel;
  std::string file;
  std::vector<float> floats;
  std::vector<half> halves;
};

void writeLines(const LightPicture& picture, ExrPixel pixel, const std::string& file,
  Imf::OutputFile& to, ExportProgress& progress)
{
  Line line(picture.width, pixel, file);
  to.setFrameBuffer(line.buffer());
  const std::size_t row = 3 * std::size_t(picture.width);
  for (int y = 0; y < picture.height; ++y)
  {
    const std::size_t start = row * std::size_t(picture.height - 1 - y); // the first is the top
    line.fill(picture.radiance + start, picture.transmittance + start);
    to.writePixels(1);
    progress.advance(1);
  }
}
} // namespace

void writePictureExr(const LightPicture& picture, const std::string& file, ExrPixel pixel,
  const std::function<bool(double)>& report)
{
  AtomicFile target(file);
  ExportProgress progress(report, picture.height);
  ExrStream stream(target);
  try
  {
    Imf::OutputFile output(stream, headerOf(picture, pixel));
    writeLines(picture, pixel, file, output, progress);
  }
  catch (const Iex::BaseExc& error)
  {
    stream.rethrow();
    throw NotWritten(file, error.what());
  }
  stream.rethrow();
  target.commit();
}
} // namespace galaxy
