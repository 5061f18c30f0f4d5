#ifndef galaxy_RefusalFixtures_h
#define galaxy_RefusalFixtures_h

#include <map>
#include <string>
#include <vector>

namespace galaxy::testing
{
/// A key's place, "image.i" "plane", and what it is set to.
struct Setting
{
  std::string section;
  std::string key;
  std::string value;
};

/// A key whose value is a number, or a list of some.
struct NumericKey
{
  std::string section;
  std::string key;
  std::vector<std::string> good; ///< a value that makes sense, number by number
  bool isList = false;
  std::vector<Setting> context; ///< what else gives the key a meaning
};

/// A .galaxy file of one image and one component, by section and key.
class Scene
{
public:
  explicit Scene(const NumericKey& key)
  {
    this->sections["galaxy"] = { { "ra", "204.25" }, { "dec", "-29.87" }, { "distance", "4.9" } };
    this->sections["image.i"] = { { "file", "'cube.fits'" } };
    this->sections["component"] = { { "name", "'all'" }, { "particles", "60" } };
    this->sections["layers"] = { { "image", "'i'" } };
    for (const Setting& setting : key.context)
    {
      this->set(setting);
    }
  }

  /// An empty value takes the key away.
  void set(const Setting& setting)
  {
    auto& keys = this->sections[setting.section];
    if (setting.value.empty())
    {
      keys.erase(setting.key);
      return;
    }
    keys[setting.key] = setting.value;
  }

  std::string text() const
  {
    std::string text = "[galaxy]\n" + this->lines("galaxy");
    for (const char* name : { "image.i", "image.j", "image.all" })
    {
      text += this->sections.count(name) ? "[" + std::string(name) + "]\n" + this->lines(name) : "";
    }
    text += "[[component]]\n" + this->lines("component");
    if (const std::string layer = this->lines("layers"); !layer.empty())
    {
      std::string entries;
      for (const auto& [key, value] : this->sections.at("layers"))
      {
        entries += (entries.empty() ? "" : ", ") + key + " = " + value;
      }
      text += "layers = [{ " + entries + " }]\n";
    }
    for (const char* name : { "thickness", "dust", "spheroid", "smoothing" })
    {
      text += this->sections.count(name)
        ? "[component." + std::string(name) + "]\n" + this->lines(name)
        : "";
    }
    return text;
  }

private:
  std::string lines(const std::string& section) const
  {
    std::string text;
    for (const auto& [key, value] : this->sections.at(section))
    {
      text += key + " = " + value + "\n";
    }
    return text;
  }

  std::map<std::string, std::map<std::string, std::string>> sections;
};

/// Every key of a number in a .galaxy file, with what it needs beside it.
inline std::vector<NumericKey> numericKeys()
{
  using Context = std::vector<Setting>;
  std::vector<NumericKey> keys;
  const auto scalar = [&](const char* section, const char* key, const char* good,
                        const Context& context = {}) {
    keys.push_back({ section, key, { good }, false, context });
  };
  const auto list = [&](const char* section, const char* key, std::vector<std::string> good,
                      const Context& context = {}) {
    keys.push_back({ section, key, std::move(good), true, context });
  };

  scalar("galaxy", "ra", "204.25");
  scalar("galaxy", "dec", "-29.87");
  scalar("galaxy", "distance", "4.9");
  const Context rings = { { "galaxy", "rings", "'model.rings'" } };
  scalar("galaxy", "ring_disk", "1", rings);
  scalar("galaxy", "ring_pixel_scale", "2.5", rings);
  scalar("galaxy", "inclination", "30");
  scalar("galaxy", "position_angle", "40");
  scalar("galaxy", "rotation_velocity", "200");
  scalar("galaxy", "radius", "5");

  const Context supplied = { { "image.i", "ra", "204.25" }, { "image.i", "dec", "-29.87" },
    { "image.i", "pixel_scale", "20" } };
  scalar("image.i", "hdu", "0");
  scalar("image.i", "plane", "1");
  list("image.i", "planes", { "0", "1" });
  list("image.i", "velocity_range", { "-1e9", "1e9" });
  list("image.i", "mask_values", { "2" });
  scalar("image.i", "ra", "204.25", supplied);
  scalar("image.i", "dec", "-29.87", supplied);
  scalar("image.i", "pixel_scale", "20", supplied);
  scalar("image.i", "position_angle", "40", supplied);
  list("image.i", "reference_pixel", { "12", "12" }, supplied);
  scalar("image.i", "background", "0.1");
  scalar("image.i", "mask_stars_above", "3");
  scalar("image.i", "beam", "30", { { "component", "particles", "'Auto'" } });
  list("image.i", "beam", { "30", "20", "10" }, { { "component", "particles", "'Auto'" } });
  scalar("image.all", "signal_above", "0.5",
    { { "image.j", "file", "'cube.fits'" }, { "image.j", "beam", "60" },
      { "image.i", "beam", "30" }, { "image.all", "combine", "['i', 'j']" },
      { "layers", "image", "'all'" } });

  const Context absorbs = { { "component", "role", "'Absorbs'" } };
  const auto absorber = [&](const char* key, const char* value, const char* unit = "") {
    Context context = absorbs;
    context.push_back({ "component", key, value });
    if (*unit)
    {
      context.push_back({ "image.i", "unit", unit });
      context.push_back({ "image.i", "beam", "30" });
    }
    return context;
  };
  scalar("component", "particles", "60");
  scalar("component", "noise", "0.5", { { "component", "particles", "'Auto'" } });
  scalar("component", "scale_length", "2",
    { { "component", "profile", "'Exponential'" }, { "layers", "image", "" } });
  scalar("component", "inner_radius", "1");
  scalar("component", "outer_radius", "4");
  list("component", "color", { "1", "0.5", "0.2" });
  scalar("component", "smoothing_length", "0.1");
  scalar("component", "size", "1");
  scalar("component", "brightness", "1");
  scalar("component", "optical_depth", "1", absorbs);
  list("component", "absorption", { "0.8", "1", "1.3" }, absorbs);
  scalar("component", "velocity_dispersion", "10");
  scalar("component", "r_v", "3.1", absorber("extinction", "'CCM89'"));
  list("component", "bands", { "0.6", "0.5", "0.4" }, absorber("extinction", "'CCM89'"));
  const Context pah = absorber("calibration", "'PAH8um'", "'MJy/sr'");
  scalar("component", "reference_optical_depth", "0.5", pah);
  scalar("component", "reference_radius", "3", pah);
  Context gas = absorber("calibration", "'Gas'", "'cm-2'");
  scalar("component", "dust_to_gas", "1", gas);
  gas.insert(gas.end(),
    { { "image.j", "file", "'cube.fits'" }, { "image.j", "unit", "'K km/s'" },
      { "component", "molecular_image", "'j'" } });
  scalar("component", "co_to_h2", "2e20", gas);
  const Context emission = absorber("calibration", "'Dust250um'", "'MJy/sr'");
  scalar("component", "dust_temperature", "20", emission);
  scalar("component", "v_over_250um", "6500", emission);

  list("layers", "color", { "1", "0.5", "0.2" });
  scalar("layers", "weight", "1");
  list("layers", "clip", { "0", "4" });
  list("layers", "clip_percentile", { "1", "99" });
  scalar("layers", "threshold", "0.1");

  const auto thickness = [&](
                           const char* model, std::vector<std::pair<const char*, const char*>> of) {
    for (const auto& [key, good] : of)
    {
      scalar("thickness", key, good, { { "thickness", "model", model } });
    }
  };
  thickness("'Gaussian'", { { "children", "3" }, { "sigma", "0.1" }, { "compression", "0.5" } });
  thickness("'Tapered'",
    { { "children", "3" }, { "maximum_children", "10" }, { "sigma", "0.1" },
      { "scale_length", "2" }, { "scale_height", "0.3" } });
  thickness("'Flared'",
    { { "fwhm_centre", "0.3" }, { "fwhm_edge", "0.8" }, { "edge_radius", "3" },
      { "flare_length", "17" }, { "fwhm_maximum", "4" }, { "reference_velocity", "189" },
      { "velocity_exponent", "1" } });
  thickness("'Hydrostatic'",
    { { "gas_dispersion", "8" }, { "stellar_surface_density", "500" },
      { "gas_surface_density", "10" }, { "scale_length", "2" }, { "scale_height", "0.3" } });

  const auto dust = [&](const char* model, std::vector<std::pair<const char*, const char*>> of) {
    for (const auto& [key, good] : of)
    {
      Context context = absorbs;
      context.push_back({ "dust", "model", model });
      scalar("dust", key, good, context);
    }
  };
  for (const char* walk : { "'RingVelocity'", "'DiskRotation'" })
  {
    dust(walk,
      { { "steps", "5" }, { "step_length", "0.03" }, { "velocity_dispersion", "10" },
        { "vertical_dispersion", "6" }, { "scale_height", "0.1" }, { "damping_time", "10" } });
  }
  dust("'Fractal'",
    { { "lacunarity", "2" }, { "hurst", "0.33" }, { "contrast", "1" }, { "noise_scale", "0.5" },
      { "winding", "2" }, { "spread", "0.05" }, { "octaves", "5" }, { "children", "8" },
      { "scale_height", "0.1" } });

  const auto spheroid = [&](const char* profile, Context more = {}) {
    more.insert(more.end(),
      { { "component", "type", "'Spheroid'" }, { "layers", "image", "" },
        { "spheroid", "profile", profile } });
    return more;
  };
  list("spheroid", "sigma", { "0.3", "0.3", "0.2" }, spheroid("'Gaussian'"));
  scalar("spheroid", "effective_radius", "0.5", spheroid("'Sersic'"));
  scalar("spheroid", "sersic_index", "4", spheroid("'Sersic'"));
  for (const char* profile : { "'Hernquist'", "'Exponential'", "'Plummer'", "'NFW'", "'Cored'" })
  {
    scalar("spheroid", "scale_radius", "0.5", spheroid(profile));
    scalar("spheroid", "truncation", "5", spheroid(profile));
    list("spheroid", "axis_ratios", { "0.9", "0.7" }, spheroid(profile));
  }
  scalar("spheroid", "slope", "3.9", spheroid("'Cored'"));
  scalar("spheroid", "concentration", "10", spheroid("'NFW'"));
  scalar("spheroid", "position_angle", "40", spheroid("'Plummer'"));
  scalar("spheroid", "inclination", "30", spheroid("'Plummer'"));
  scalar("spheroid", "central_brightness", "2", spheroid("'Plummer'"));
  scalar("spheroid", "luminosity", "2", spheroid("'Plummer'"));
  scalar("spheroid", "clusters", "7", spheroid("'Plummer'"));
  scalar("spheroid", "cluster_radius", "0.01",
    spheroid("'Plummer'", { { "spheroid", "clusters", "7" } }));

  const auto smoothing = [&](
                           const char* model, std::vector<std::pair<const char*, const char*>> of) {
    for (const auto& [key, good] : of)
    {
      scalar("smoothing", key, good, { { "smoothing", "model", model } });
    }
  };
  for (const char* model : { "'Density'", "'Neighbours'" })
  {
    smoothing(model,
      { { "factor", "1.5" }, { "neighbours", "8" }, { "minimum", "0.01" }, { "maximum", "1" } });
  }
  smoothing("'Constant'", { { "length", "0.1" } });
  smoothing("'Brightness'", { { "length", "0.1" }, { "exponent", "0.3" } });
  return keys;
}
} // namespace galaxy::testing

#endif
