#include "Filters/Splatting/ActiveEffects.h"

#include <cstdio>

namespace galaxy
{
std::string shortCount(std::size_t count)
{
  char text[32];
  if (count < 1000)
  {
    std::snprintf(text, sizeof(text), "%zu", count);
  }
  else if (count < 999500)
  {
    std::snprintf(text, sizeof(text), "%.3g k", count / 1e3);
  }
  else
  {
    std::snprintf(text, sizeof(text), "%.1f M", count / 1e6);
  }
  return text;
}

std::string activeEffects(const ProjectionCounts& counts)
{
  if (counts.drawn == 0)
  {
    return "nothing in view";
  }
  std::string text = counts.emitters > 0 ? "emission; " : "";
  if (counts.absorbers == 0)
  {
    return text + "no absorber, no sort";
  }
  text += counts.colored > 0 ? "per-channel absorption; " : "grey absorption; ";
  text += "depth order among " + shortCount(counts.absorbers) + " absorbers";
  if (const std::size_t others = counts.drawn - counts.absorbers; others > 0)
  {
    text += " and " + shortCount(others) + " emitters";
  }
  return text;
}
} // namespace galaxy
