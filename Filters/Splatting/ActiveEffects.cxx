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

OrderNeeds& OrderNeeds::operator+=(const OrderNeeds& other)
{
  this->ordered += other.ordered;
  this->oneSource += other.oneSource;
  this->thin += other.thin;
  return *this;
}

std::string activeEffects(const ProjectionCounts& counts, const OrderNeeds& tiles)
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
  if (tiles.ordered == 0)
  {
    return text +
      (tiles.oneSource > 0 ? "one source function, no sort" : "too thin for an order, no sort");
  }
  text += "depth order among " + shortCount(counts.absorbers) + " absorbers";
  if (const std::size_t others = counts.drawn - counts.absorbers; others > 0)
  {
    text += " and " + shortCount(others) + " emitters";
  }
  if (const std::size_t rest = tiles.oneSource + tiles.thin; rest > 0)
  {
    text += "; none in " + shortCount(rest) + " of " + shortCount(rest + tiles.ordered) +
      " tiles with absorbers";
  }
  return text;
}
} // namespace galaxy
