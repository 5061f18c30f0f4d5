#include "Readers/Formats/KeyTable.h"

#include "Readers/Formats/Error.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numeric>
#include <sstream>

namespace galaxy
{
namespace
{
std::string lower(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// Levenshtein's distance, capitals aside.
std::size_t editDistance(const std::string& first, const std::string& second)
{
  const std::string a = lower(first), b = lower(second);
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j)
    {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({ replaced, row[j] + 1, row[j + 1] + 1 });
    }
  }
  return row.back();
}

std::string joined(const std::vector<std::string>& names, const char* separator)
{
  std::string text;
  for (const std::string& name : names)
  {
    text += (text.empty() ? "" : separator) + name;
  }
  return text;
}

/// Empty where none is near.
std::string nearest(const std::string& name, const std::vector<std::string>& candidates)
{
  std::string nearest;
  // Farther than half of its letters, a name is another word rather than a misspelling.
  std::size_t least = name.size() / 2 + 1;
  for (const std::string& candidate : candidates)
  {
    const std::size_t distance = editDistance(name, candidate);
    if (distance < least)
    {
      least = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string didYouMean(const std::string& name)
{
  return "; did you mean `" + name + "`?";
}
} // namespace

bool Range::contains(double number) const
{
  const bool hasLowestOnly = std::isfinite(this->lowest) && !std::isfinite(this->highest);
  return std::isfinite(number) && number <= (hasLowestOnly ? Range::most : this->highest) &&
    (this->open ? number > this->lowest : number >= this->lowest);
}

std::string Range::text() const
{
  if (std::isfinite(this->highest))
  {
    return written(this->lowest) + " to " + written(this->highest);
  }
  if (std::isfinite(this->lowest))
  {
    return (this->open ? "greater than " : "at least ") + written(this->lowest);
  }
  return "";
}

std::string Range::complaint(double number) const
{
  if (!std::isfinite(number))
  {
    return "must be a finite number";
  }
  const bool isTooLarge = !std::isfinite(this->highest) && number > Range::most;
  return "must be " + (isTooLarge ? "at most " + written(Range::most) : this->text());
}

void KeyValue::fail(const std::string& what) const
{
  const std::string line = lineOf(this->node);
  throw Error(this->file, line + (line.empty() ? "" : ": ") + this->key, what);
}

void KeyValue::contradicts(const std::string& other) const
{
  this->fail("contradicts " + other + "; give one or the other");
}

void KeyValue::needs(const std::string& what) const
{
  this->fail("needs " + what + "; give it, or leave " + this->key + " out");
}

double KeyValue::number(const Range& range) const
{
  const auto number = this->node.value<double>();
  if (!this->node.is_number() || !number)
  {
    this->fail("must be a number");
  }
  if (!range.contains(*number))
  {
    this->fail(range.complaint(*number));
  }
  return *number;
}

long long KeyValue::integer(long long lowest, long long highest) const
{
  // 1e6 is a float to TOML and a whole number to people.
  const double number = this->number(Range::any());
  if (number != std::floor(number))
  {
    this->fail("must be a whole number");
  }
  if (number < static_cast<double>(lowest) || number > static_cast<double>(highest))
  {
    this->fail("must be " + std::to_string(lowest) + " to " + std::to_string(highest));
  }
  return static_cast<long long>(number);
}

std::string KeyValue::text() const
{
  const auto text = this->node.value<std::string>();
  if (!this->node.is_string() || !text)
  {
    this->fail("must be a text in quotes");
  }
  return *text;
}

bool KeyValue::flag() const
{
  if (!this->node.is_boolean())
  {
    this->fail("must be true or false");
  }
  return this->node.as_boolean()->get();
}

bool KeyValue::isAuto() const
{
  if (!this->node.is_string())
  {
    return false;
  }
  if (lower(this->text()) != "auto")
  {
    this->fail("must be a number or \"Auto\"");
  }
  return true;
}

std::vector<double> KeyValue::numbers(std::size_t count, const Range& range) const
{
  const toml::array* array = this->node.as_array();
  if (array == nullptr || array->size() != count)
  {
    this->fail("must be a list of " + std::to_string(count) + " numbers");
  }
  std::vector<double> numbers;
  for (const toml::node& entry : *array)
  {
    numbers.push_back(KeyValue(this->file, this->key, entry).number(range));
  }
  return numbers;
}

const toml::table& KeyValue::table() const
{
  const toml::table* table = this->node.as_table();
  if (table == nullptr)
  {
    this->fail("must be a section, [" + this->key + "]");
  }
  return *table;
}

std::vector<const toml::table*> KeyValue::tables() const
{
  std::vector<const toml::table*> tables;
  if (!this->node.is_array())
  {
    this->fail("must be a list of sections, each headed [[" + this->key + "]]");
  }
  for (const toml::node& entry : *this->node.as_array())
  {
    tables.push_back(&KeyValue(this->file, this->key, entry).table());
  }
  return tables;
}

std::size_t KeyValue::choice(const std::vector<std::string>& names) const
{
  const std::string text = this->text();
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    if (lower(names[i]) == lower(text))
    {
      return i;
    }
  }
  const std::string near = nearest(text, names);
  this->fail("must be one of " + joined(names, ", ") + ", not '" + text + "'" +
    (near.empty() ? "" : didYouMean(near)));
}

std::string lineOf(const toml::node& node)
{
  const auto line = node.source().begin.line;
  return line == 0 ? "" : "line " + std::to_string(line);
}

std::vector<std::pair<std::string, const toml::node*>> inTextOrder(const toml::table& table)
{
  std::vector<std::pair<std::string, const toml::node*>> entries;
  for (const auto& [key, node] : table)
  {
    entries.emplace_back(std::string(key.str()), &node);
  }
  std::stable_sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
    const auto first = a.second->source().begin, second = b.second->source().begin;
    return std::make_pair(first.line, first.column) < std::make_pair(second.line, second.column);
  });
  return entries;
}

std::string suggestion(const std::string& name, const std::vector<std::string>& candidates)
{
  const std::string near = nearest(name, candidates);
  return !near.empty()   ? didYouMean(near)
    : candidates.empty() ? "; add it"
                         : "; use one of " + joined(candidates, ", ");
}

std::string written(double number)
{
  if (std::isinf(number))
  {
    return "none";
  }
  std::ostringstream text;
  text << number;
  return text.str();
}

std::string writtenType(const std::string& kind, const std::string& unit, const Range& range)
{
  const std::string bounds = range.text();
  return kind + (bounds.empty() ? "" : " " + bounds) + (unit.empty() ? "" : ", " + unit);
}

std::string writtenIntegerType(long long lowest, long long highest)
{
  // The largest int is how the code says that there is no bound.
  const std::string type = "whole number ";
  return highest < std::numeric_limits<int>::max() - 1
    ? type + std::to_string(lowest) + " to " + std::to_string(highest)
    : type + "at least " + std::to_string(lowest);
}

std::string writtenChoices(const std::vector<std::string>& names)
{
  return "\"" + joined(names, "\", \"") + "\"";
}

std::string writtenText(const std::string& text)
{
  return "\"" + text + "\"";
}

void failAtUnknownKey(
  const KeyValue& value, const std::string& section, const std::vector<std::string>& known)
{
  value.fail(
    "unknown key" + (section.empty() ? "" : " of " + section) + suggestion(value.key, known));
}

void failAtMissingKey(const std::string& file, const std::string& section, const toml::table& table,
  const std::string& key, const std::string& type)
{
  const std::string line = section.empty() ? "" : lineOf(table);
  throw Error(file, line + (line.empty() ? "" : ": ") + key,
    "missing" + (section.empty() ? "" : " in " + section) +
      (type.empty() ? "; add a section [" + key + "]" : "; give a " + type));
}
} // namespace galaxy
