#include "Filters/Splatting/RenderStatistics.h"

#include <algorithm>
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

void RenderStatistics::addSeconds(const RenderStatistics& other)
{
  for (const auto& stage : other.seconds)
  {
    const auto same = std::find_if(this->seconds.begin(), this->seconds.end(),
      [&stage](const auto& mine) { return mine.first == stage.first; });
    if (same == this->seconds.end())
    {
      this->seconds.push_back(stage);
    }
    else
    {
      same->second += stage.second;
    }
  }
}

std::string activeEffects(const RenderStatistics& counts)
{
  const OrderNeeds& tiles = counts.tiles;
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
  if (const std::size_t rest = tiles.unordered(); rest > 0)
  {
    text += "; none in " + shortCount(rest) + " of " + shortCount(rest + tiles.ordered) +
      " tiles with absorbers";
  }
  return counts.bySlices ? text + "; overlapping particles by slices" : text;
}
} // namespace galaxy
