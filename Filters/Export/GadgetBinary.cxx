#include "Filters/Export/GadgetBinary.h"

#include "Filters/Export/CommitTogether.h"
#include "Filters/Export/GadgetFields.h"
#include "Filters/Export/GadgetParts.h"
#include "Readers/Formats/Error.h"

#include <algorithm>
#include <memory>
#include <vector>

namespace galaxy
{
namespace
{
/// For each type the ranks of its first particle in a file and in the next one.
struct Share
{
  std::array<std::uint64_t, gadgetTypes> first;
  std::array<std::uint64_t, gadgetTypes> last;

  std::uint64_t count(int type) const { return this->last[type] - this->first[type]; }
};

Share shareOf(const TypeOrder& order, std::uint64_t file, std::uint64_t files)
{
  Share share;
  for (int type = 0; type < gadgetTypes; ++type)
  {
    share.first[type] = order.counts()[type] * file / files;
    share.last[type] = order.counts()[type] * (file + 1) / files;
  }
  return share;
}

/// One file of a snapshot.
class SnapshotFile
{
public:
  SnapshotFile(const std::string& name, int format, const TypeOrder& order, const Share& share)
    : file(name)
    , format(format)
    , order(order)
    , share(share)
  {
  }

  void reserve(const std::vector<GadgetField>& fields)
  {
    const std::uint64_t frame = this->format == 2 ? 24 : 8;
    std::uint64_t bytes = frame + sizeof(GadgetHeader);
    for (const GadgetField& field : fields)
    {
      bytes += frame + this->bytesOf(field);
    }
    this->file.reserve(bytes);
  }

  void writeHeader(int files)
  {
    GadgetHeader header;
    for (int type = 0; type < gadgetTypes; ++type)
    {
      const std::uint64_t total = this->order.counts()[type];
      header.npart[type] = static_cast<std::uint32_t>(this->share.count(type));
      header.npartTotal[type] = static_cast<std::uint32_t>(total);
      header.npartTotalHighWord[type] = static_cast<std::uint32_t>(total >> 32);
    }
    header.numFiles = files;
    this->beginRecord("HEAD", sizeof(header));
    this->file.write(&header, sizeof(header));
    this->writeMarker(sizeof(header));
  }

  void writeBlock(const GadgetField& field, ExportProgress& progress)
  {
    const std::uint64_t bytes = this->bytesOf(field);
    this->beginRecord(field.block, bytes);
    std::vector<char> values(TypeOrder::chunk * field.bytes());
    for (int type = 0; type < this->typesOf(field); ++type)
    {
      this->order.visit(type, this->share.first[type], this->share.last[type],
        [&](const std::size_t* particles, std::size_t count) {
          field.gather(particles, count, values.data());
          this->file.write(values.data(), count * field.bytes());
          progress.advance(static_cast<double>(count * field.bytes()));
        });
    }
    this->writeMarker(bytes);
  }

  AtomicFile& target() { return this->file; }

private:
  static int typesOf(const GadgetField& field) { return field.gasOnly ? 1 : gadgetTypes; }

  std::uint64_t bytesOf(const GadgetField& field) const
  {
    std::uint64_t count = 0;
    for (int type = 0; type < typesOf(field); ++type)
    {
      count += this->share.count(type);
    }
    return count * field.bytes();
  }

  void writeMarker(std::uint64_t bytes)
  {
    const auto marker = static_cast<std::uint32_t>(bytes);
    this->file.write(&marker, sizeof(marker));
  }

  /// In format 2 a record of eight bytes comes before: the name, and the length of the record
  /// that follows with its markers.
  void beginRecord(const std::string& name, std::uint64_t bytes)
  {
    if (this->format == 2)
    {
      this->writeMarker(8);
      this->file.write(name.data(), 4);
      this->writeMarker(bytes + 8);
      this->writeMarker(8);
    }
    this->writeMarker(bytes);
  }

  AtomicFile file;
  int format;
  const TypeOrder& order;
  Share share;
};

/// A share is at most one particle of each type larger than the mean.
std::uint64_t filesFor(
  std::size_t size, const std::vector<GadgetField>& fields, std::uint64_t largestBlock)
{
  std::uint64_t widest = 0;
  for (const GadgetField& field : fields)
  {
    widest = std::max<std::uint64_t>(widest, field.bytes());
  }
  const std::uint64_t particles = largestBlock / widest;
  return size <= particles ? 1 : (size + particles - gadgetTypes - 1) / (particles - gadgetTypes);
}
} // namespace

void writeGadgetBinary(const ParticleTable& table, const std::string& file, int format,
  std::uint64_t largestBlock, const std::function<bool(double)>& progress)
{
  const TypeOrder order(table);
  std::vector<GadgetField> fields = gadgetFields(table, false);
  if (order.counts()[0] == 0)
  {
    fields.erase(std::remove_if(fields.begin(), fields.end(),
                   [](const GadgetField& field) { return field.gasOnly; }),
      fields.end());
  }
  double total = 0;
  for (const GadgetField& field : fields)
  {
    total += static_cast<double>((field.gasOnly ? order.counts()[0] : table.size) * field.bytes());
  }
  ExportProgress done(progress, total);

  const std::uint64_t files = filesFor(table.size, fields, largestBlock);
  std::vector<std::unique_ptr<SnapshotFile>> snapshot;
  for (std::uint64_t k = 0; k < files; ++k)
  {
    snapshot.push_back(std::make_unique<SnapshotFile>(
      gadgetPartName(file, k, files), format, order, shareOf(order, k, files)));
    snapshot.back()->reserve(fields);
  }
  for (const auto& part : snapshot)
  {
    part->writeHeader(static_cast<int>(files));
    for (const GadgetField& field : fields)
    {
      part->writeBlock(field, done);
    }
  }
  std::vector<AtomicFile*> parts;
  for (const auto& part : snapshot)
  {
    parts.push_back(&part->target());
  }
  commitTogether(parts, staleGadgetParts(file, files));
}
} // namespace galaxy
