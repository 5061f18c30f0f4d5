#ifndef galaxy_GadgetParts_h
#define galaxy_GadgetParts_h

#include <cstdint>
#include <string>
#include <vector>

namespace galaxy
{
/// The name of one of the files of a binary snapshot.
std::string gadgetPartName(const std::string& file, std::uint64_t part, std::uint64_t files);

/// What an earlier snapshot of the same name but another number of files has left: `file` itself
/// beside parts, and parts beside it or beyond the last. Only binary Gadget snapshots whose header
/// agrees with their name, whatever else is called like one.
std::vector<std::string> staleGadgetParts(const std::string& file, std::uint64_t files);
} // namespace galaxy

#endif
