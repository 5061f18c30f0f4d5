#include "Readers/Formats/Error.h"
#include "Readers/Formats/GalaxyKeys.h"

#include <filesystem>

namespace galaxy
{
namespace
{
void readGroup(const KeyValue& value, GroupDescription& out)
{
  readTable(value.file, "[group]", value.table(), groupKeys(), out);
}

void readMembers(const KeyValue& value, GroupDescription& out)
{
  for (const toml::table* table : value.tables())
  {
    readTable(value.file, "[[member]]", *table, memberKeys(), out.members.emplace_back());
  }
}
} // namespace

const Keys<GroupDescription>& groupFileKeys()
{
  static const Keys<GroupDescription> keys = {
    sectionKey<GroupDescription>("group", readGroup),
    sectionKey<GroupDescription>("member", readMembers),
  };
  return keys;
}

const Keys<GroupDescription>& groupKeys()
{
  using G = GroupDescription;
  static const Keys<G> keys = {
    withDefault(textKey<G>("name", &G::name, "The group's name."), "the file's name"),
    numberKey<G>("magnification", &G::magnification, Range::positive(), "",
      "Each galaxy is enlarged by it about its own centre."),
    numberKey<G>("separation", &G::separation, Range::positive(), "",
      "Factor on the distances from the first member."),
  };
  return keys;
}

const Keys<GroupMember>& memberKeys()
{
  using M = GroupMember;
  static const Keys<M> keys = {
    required(textKey<M>("galaxy", &M::galaxy, "A .galaxy file, relative to this one.")),
    numberKey<M>("magnification", &M::magnification, Range::positive(), "",
      "The same for this member alone, times the group's."),
  };
  return keys;
}

GroupDescription parseGroupDescription(const std::string& text, const std::string& file)
{
  const toml::table root = parseToml(text, file);
  GroupDescription group;
  group.file = file;
  group.name = std::filesystem::path(file).stem().string();
  readTable(file, "", root, groupFileKeys(), group);
  if (group.members.empty())
  {
    throw Error(file, "member", "missing; add a section [[member]] for every galaxy");
  }
  return group;
}

GroupDescription readGroupDescription(const std::string& file)
{
  return parseGroupDescription(readText(file), file);
}
} // namespace galaxy
