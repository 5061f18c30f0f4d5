#ifndef galaxy_NumberRows_h
#define galaxy_NumberRows_h

#include "Readers/Formats/Error.h"
#include "Readers/Formats/KeyTable.h"

#include <cstddef>
#include <string>

namespace galaxy
{
/// A number of a section, for the file and for a filter's properties alike.
template <class T>
struct NumberRow
{
  const char* name;
  double T::*member;
  Range range;
  const char* unit;
  const char* meaning;

  Key<T> key() const
  {
    return numberKey<T>(this->name, this->member, this->range, this->unit, this->meaning);
  }
};

/// Refuses what a description has that did not come from a file: Error (file, component) names the
/// section and the key.
class SectionCheck
{
public:
  SectionCheck(const std::string& file, const std::string& component, const char* section)
    : file(file)
    , component(component)
    , section(section)
  {
  }

  void require(bool right, const std::string& name, const std::string& range) const
  {
    if (!right)
    {
      this->fail(name, "must be " + range);
    }
  }

  void require(double value, const Range& range, const std::string& name) const
  {
    if (!range.contains(value))
    {
      this->fail(name, range.complaint(value));
    }
  }

  /// Defaults may be what the file cannot say, such as infinity.
  template <class T, std::size_t count>
  void requireNumbers(const NumberRow<T> (&rows)[count], const T& description) const
  {
    const T defaults;
    for (const NumberRow<T>& row : rows)
    {
      const double value = description.*row.member;
      if (value != defaults.*row.member)
      {
        this->require(value, row.range, row.name);
      }
    }
  }

  [[noreturn]] void fail(const std::string& name, const std::string& complaint) const
  {
    throw Error(this->file, this->component, this->section + ": " + name + " " + complaint);
  }

private:
  const std::string& file;
  const std::string& component;
  std::string section;
};
} // namespace galaxy

#endif
