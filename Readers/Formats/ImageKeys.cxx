#include "Readers/Formats/GalaxyKeys.h"
#include "Readers/Formats/SkyKeys.h"

#include <algorithm>
#include <climits>
#include <cmath>

namespace galaxy
{
namespace
{
void readBackground(const KeyValue& value, ImageDescription& out)
{
  out.automaticBackground = value.isAuto();
  if (!out.automaticBackground)
  {
    out.background = value.number(Range::any());
  }
}

void readPlanes(const KeyValue& value, ImageDescription& out)
{
  const std::vector<double> planes = value.numbers(2, Range::from(0, INT_MAX));
  out.selection.planes = { static_cast<int>(planes[0]), static_cast<int>(planes[1]) };
  if (planes[0] > planes[1] || planes[0] != out.selection.planes->front() ||
    planes[1] != out.selection.planes->back())
  {
    value.fail("must be two whole numbers, the first not greater than the last");
  }
}

void readVelocityRange(const KeyValue& value, ImageDescription& out)
{
  const std::vector<double> range = value.numbers(2, Range::any());
  out.selection.velocityRange = { range[0], range[1] };
}

void readMaskValues(const KeyValue& value, ImageDescription& out)
{
  const toml::array* list = value.node.as_array();
  if (!list || list->empty())
  {
    value.fail("must be a list of numbers");
  }
  out.selection.maskValues = value.numbers(list->size(), Range::any());
}

void readReferencePixel(const KeyValue& value, ImageDescription& out)
{
  const std::vector<double> pixel = value.numbers(2, Range::any());
  out.coordinates.pixel = { pixel[0], pixel[1] };
}

void readPixelScale(const KeyValue& value, ImageDescription& out)
{
  out.suppliesCoordinates = true;
  out.coordinates.pixelScale = value.number(Range::positive());
}

/// A beam's width, or its axes and position angle; of an ellipse, the circle of the same area.
void readBeam(const KeyValue& value, ImageDescription& out)
{
  if (!value.node.is_array())
  {
    out.beam = value.number(Range::positive());
    return;
  }
  const std::vector<double> beam = value.numbers(3, Range::any());
  if (!(beam[0] > 0 && beam[1] > 0))
  {
    value.fail("the beam's axes must be greater than 0");
  }
  out.beam = std::sqrt(beam[0] * beam[1]);
}

void readCombine(const KeyValue& value, ImageDescription& out)
{
  const toml::array* names = value.node.as_array();
  if (names == nullptr || names->size() < 2)
  {
    value.fail("must be a list of 2 or more images' names, the sharpest first");
  }
  for (const toml::node& name : *names)
  {
    out.combine.push_back(KeyValue(value.file, value.key, name).text());
  }
}

void readSignal(const KeyValue& value, ImageDescription& out)
{
  if (!value.isAuto())
  {
    out.signalAbove = value.number(Range::notNegative());
  }
}

/// An image is read from a file or combined of others, which then say all about its pixels.
void checkSource(const std::string& file, const std::string& section, const toml::table& table)
{
  const bool combines = table.contains("combine");
  if (!combines && !table.contains("file"))
  {
    failAtMissingKey(file, section, table, "file", "FITS file");
  }
  for (const auto& [key, node] : inTextOrder(table))
  {
    const bool belongs = key == "combine" || key == "signal_above";
    if (combines && !belongs)
    {
      KeyValue(file, key, *node)
        .fail("has no place beside combine; give it to the images combined");
    }
    if (!combines && key == "signal_above")
    {
      KeyValue(file, key, *node).needs("combine");
    }
  }
}

/// What an image combines must be images with files.
void checkCombined(const KeyValue& value, const GalaxyDescription& galaxy)
{
  std::vector<std::string> withFiles;
  for (const ImageDescription& image : galaxy.images)
  {
    if (image.combine.empty())
    {
      withFiles.push_back(image.name);
    }
  }
  for (const ImageDescription& image : galaxy.images)
  {
    for (const std::string& name : image.combine)
    {
      if (std::find(withFiles.begin(), withFiles.end(), name) == withFiles.end())
      {
        KeyValue(value.file, "combine", *value.table()[image.name].as_table()->get("combine"))
          .fail("there is no [image." + name + "] with a file" + suggestion(name, withFiles));
      }
    }
  }
}

void checkPlanes(const std::string& file, const toml::table& table)
{
  for (const std::string other : { "plane", "velocity_range" })
  {
    if (table.contains("planes") && table.contains(other))
    {
      KeyValue(file, "planes", *table.get("planes")).contradicts(other);
    }
  }
}

/// Coordinates are supplied as a whole or not at all.
void checkCoordinates(const std::string& file, const std::string& section, const toml::table& table)
{
  const bool supplied = table.contains("pixel_scale");
  for (const char* key : { "ra", "dec", "position_angle", "mirrored", "reference_pixel" })
  {
    if (!supplied && table.contains(key))
    {
      KeyValue(file, key, *table.get(key)).needs("pixel_scale");
    }
  }
  for (const char* key : { "ra", "dec" })
  {
    if (supplied && !table.contains(key))
    {
      failAtMissingKey(file, section, table, key, "number, degrees");
    }
  }
}
}

void readImages(const KeyValue& value, GalaxyDescription& out)
{
  for (const auto& [name, node] : inTextOrder(value.table()))
  {
    const std::string section = "[image." + name + "]";
    const toml::table& table = KeyValue(value.file, "image." + name, *node).table();
    ImageDescription& image = out.images.emplace_back();
    image.name = name;
    readTable(value.file, section, table, imageKeys(), image);
    checkSource(value.file, section, table);
    checkCoordinates(value.file, section, table);
    checkPlanes(value.file, table);
  }
  checkCombined(value, out);
}

const Keys<ImageDescription>& imageKeys()
{
  using I = ImageDescription;
  static const Keys<I> keys = {
    withDefault(textKey<I>("file", &I::file, "FITS file, relative to this one."),
      "required, but for `combine`"),
    withDefault(integerKey<I>(
                  "hdu", [](I& i) -> int& { return i.selection.hdu; }, 0, INT_MAX - 1,
                  "Header and data unit; 0 is the primary."),
      "the first with an image"),
    withDefault(textKey<I>(
                  "extension", [](I& i) -> std::string& { return i.selection.extension; },
                  "EXTNAME of the header and data unit, in place of `hdu`."),
      "none"),
    integerKey<I>(
      "plane", [](I& i) -> int& { return i.selection.plane; }, 0, INT_MAX,
      "Plane of a cube, from 0."),
    { "planes", "2 whole numbers", "none",
      "The mean of these planes, first to last, in place of `plane`.", readPlanes },
    { "velocity_range", "2 numbers, km/s", "none",
      "The integral over the channels in this range (moment 0); `plane` then names the place along "
      "the other axes.",
      readVelocityRange },
    { "mask_values", "numbers in the image's unit", "none", "Values that stand for blank pixels.",
      readMaskValues },
    withDefault(rightAscensionKey<I>([](I& i) -> double& { return i.coordinates.centre.ra; },
                  "Right ascension of the reference pixel, with pixel_scale."),
      "the header's"),
    withDefault(declinationKey<I>([](I& i) -> double& { return i.coordinates.centre.dec; },
                  "Declination of the reference pixel, with pixel_scale."),
      "the header's"),
    { "pixel_scale", "number greater than 0, arcsec a pixel", "the header's",
      "Pixel size of a tangent projection that replaces the header's coordinates.",
      readPixelScale },
    positionAngleKey<I>([](I& i) -> double& { return i.coordinates.positionAngle; },
      "Of the image's upward axis, North through East, with pixel_scale."),
    flagKey<I>(
      "mirrored", [](I& i) -> bool& { return i.coordinates.mirrored; },
      "Whether East is to the right of North, with pixel_scale."),
    { "reference_pixel", "2 numbers, pixels from 1", "the image's middle",
      "The pixel at ra and dec, with pixel_scale.", readReferencePixel },
    { "background", "number in the image's unit, or \"Auto\"", "0",
      "Subtracted; Auto finds the sky's, whatever margins, stars or gradient there are.",
      readBackground },
    withDefault(numberKey<I>("mask_stars_above", &I::maskStarsAbove, Range::positive(), "",
                  "Foreground stars that stand out by more than this are replaced by their "
                  "surroundings."),
      "no masking"),
    withDefault(textKey<I>("mask", &I::mask,
                  "FITS file of bad pixels, not 0 or NaN, which are filled from their "
                  "surroundings."),
      "none"),
    withDefault(textKey<I>("regions", &I::regions,
                  "DS9 or CASA region file of bad pixels: circle, ellipse, box, polygon."),
      "none"),
    { "beam", "number, arcsec, or 3 numbers, arcsec, arcsec and degrees", "the header's",
      "Resolution (FWHM), or the beam's two axes and position angle.", readBeam },
    withDefault(textKey<I>("unit", &I::unit, "Unit of the values, in place of the header's BUNIT."),
      "the header's"),
    choiceKey<I>("convert", &I::convert, { "None", "SurfaceBrightness", "ColumnDensity" },
      "What the values become when read (after mask_values): per arcsec^2, or H I atoms per cm^2."),
    { "combine", "list of 2 or more images' names", "none",
      "In place of `file`: the images that make this one, the sharpest first; the wider ones fill "
      "in what it misses.",
      readCombine },
    { "signal_above", "number in the first image's unit, or \"Auto\"", "\"Auto\"",
      "With combine: where the sharper images count; Auto is 3 sigma of each one's noise.",
      readSignal },
  };
  return keys;
}
}
