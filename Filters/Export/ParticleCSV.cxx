#include "Filters/Export/ParticleCSV.h"

#include "Filters/Export/AtomicFile.h"
#include "Filters/Model/ParallelFor.h"

#include <algorithm>
#include <charconv>
#include <vector>

namespace galaxy
{
namespace
{
constexpr std::size_t rowsAChunk = 512;
constexpr std::size_t chunksAtOnce = 32;
/// The longest float32 is -1.17549435e-38; a comma or line end follows each of at most 19 values.
constexpr std::size_t longestRow = 19 * 16;

/// Text of known largest length.
class RowWriter
{
public:
  explicit RowWriter(std::vector<char>& text)
    : text(text)
    , next(text.data())
  {
  }

  template <typename T>
  void add(T value)
  {
    this->next = std::to_chars(this->next, this->text.data() + this->text.size(), value).ptr;
    *this->next++ = ',';
  }

  template <typename T>
  void add(const T* values, int count)
  {
    for (int k = 0; k < count; ++k)
    {
      this->add(values[k]);
    }
  }

  void endRow() { this->next[-1] = '\n'; }
  std::size_t size() const { return static_cast<std::size_t>(this->next - this->text.data()); }

private:
  std::vector<char>& text;
  char* next;
};

std::string headerOf(const ParticleTable& table)
{
  std::string header = "x_kpc,y_kpc,z_kpc,vx_km_s,vy_km_s,vz_km_s,smoothing_length_kpc,intensity,"
                       "red,green,blue,component,absorbs";
  const auto add = [&header](const std::string& name, const float* values, int channels) {
    if (values)
    {
      header +=
        channels == 1 ? "," + name : "," + name + "_red," + name + "_green," + name + "_blue";
    }
  };
  add("emission", table.emission, table.emissionChannels);
  add("absorption", table.absorption, table.absorptionChannels);
  return header + "\n";
}

void addParticle(const ParticleTable& table, std::size_t i, RowWriter& row)
{
  const int component = table.componentOf(i);
  row.add(table.position + 3 * i, 3);
  row.add(table.velocityOf(i).data(), 3);
  row.add(table.smoothingLengthOf(i));
  row.add(table.intensityOf(i));
  for (const int channel : table.colorOf(i))
  {
    row.add(channel);
  }
  row.add(component);
  row.add(static_cast<int>(table.components[component].absorbs));
  if (table.emission)
  {
    row.add(table.emission + i * table.emissionChannels, table.emissionChannels);
  }
  if (table.absorption)
  {
    row.add(table.absorption + i * table.absorptionChannels, table.absorptionChannels);
  }
  row.endRow();
}

/// The length of the text of the chunk's particles.
std::size_t formatChunk(const ParticleTable& table, std::size_t chunk, std::vector<char>& text)
{
  text.resize(rowsAChunk * longestRow);
  RowWriter row(text);
  const std::size_t end = std::min((chunk + 1) * rowsAChunk, table.size);
  for (std::size_t i = chunk * rowsAChunk; i < end; ++i)
  {
    addParticle(table, i, row);
  }
  return row.size();
}
} // namespace

void writeParticleCSV(
  const ParticleTable& table, const std::string& file, const std::function<bool(double)>& progress)
{
  AtomicFile target(file);
  const std::string header = headerOf(table);
  target.write(header.data(), header.size());

  const std::size_t chunks = (table.size + rowsAChunk - 1) / rowsAChunk;
  ExportProgress done(progress, static_cast<double>(chunks));
  std::vector<std::vector<char>> texts(chunksAtOnce);
  std::vector<std::size_t> sizes(chunksAtOnce);
  for (std::size_t first = 0; first < chunks; first += chunksAtOnce)
  {
    const std::size_t count = std::min(chunksAtOnce, chunks - first);
    parallelForDynamic<std::size_t>(
      0, count, 1, [&](std::size_t k) { sizes[k] = formatChunk(table, first + k, texts[k]); });
    for (std::size_t k = 0; k < count; ++k)
    {
      target.write(texts[k].data(), sizes[k]);
    }
    done.advance(static_cast<double>(count));
  }
  target.commit();
}
} // namespace galaxy
