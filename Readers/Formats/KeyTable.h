#ifndef galaxy_KeyTable_h
#define galaxy_KeyTable_h

// The keys of a TOML section as a table: one row a key, from which the key is read, checked,
// suggested where misspelt, and documented.

#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace galaxy
{
/// The numbers that a key accepts.
struct Range
{
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
  bool open = false; ///< true where the lowest itself is refused

  /// Where only a lowest is given, nothing larger is accepted all the same: particles keep numbers,
  /// and the products of a few, as float32.
  static constexpr double most = 1e30;

  static Range any() { return {}; }
  static Range positive() { return { 0, std::numeric_limits<double>::infinity(), true }; }
  static Range notNegative() { return { 0, std::numeric_limits<double>::infinity(), false }; }
  static Range from(double lowest, double highest) { return { lowest, highest, false }; }

  bool contains(double number) const;
  /// "greater than 0", "0 to 1", or empty where every number is accepted.
  std::string text() const;
  /// What is wrong with a number that is not contained.
  std::string complaint(double number) const;
};

/// A value of a TOML file that knows its key and line; each getter throws Error where the value
/// has the wrong type or is out of range.
class KeyValue
{
public:
  KeyValue(const std::string& file, const std::string& key, const toml::node& node)
    : file(file)
    , key(key)
    , node(node)
  {
  }

  double number(const Range& range) const;
  long long integer(long long lowest, long long highest) const;
  std::string text() const;
  bool flag() const;
  /// Whether "Auto" stands in place of a number.
  bool isAuto() const;
  std::vector<double> numbers(std::size_t count, const Range& range) const;
  const toml::table& table() const;
  /// The tables of an array of tables, `[[name]]` or `[{...}, {...}]`.
  std::vector<const toml::table*> tables() const;
  /// The index of the name that the text equals, capitals aside.
  std::size_t choice(const std::vector<std::string>& names) const;

  /// Throws Error at this key and line.
  [[noreturn]] void fail(const std::string& what) const;
  /// Another key says the same.
  [[noreturn]] void contradicts(const std::string& other) const;
  /// Without something else, the key means nothing.
  [[noreturn]] void needs(const std::string& what) const;

  const std::string& file;
  const std::string key;
  const toml::node& node;
};

/// "line 12", or empty for a table that stands nowhere in the text.
std::string lineOf(const toml::node& node);

/// The entries of a table in the order of the text.
std::vector<std::pair<std::string, const toml::node*>> inTextOrder(const toml::table& table);

/// What to do about a name that is none of the candidates: "; did you mean `nearest`?".
std::string suggestion(const std::string& name, const std::vector<std::string>& candidates);

/// One key of a section that describes a T.
template <class T>
struct Key
{
  std::string name;
  std::string type;      ///< with unit and range; empty for a section, which has its own table
  std::string byDefault; ///< read from a default-constructed T; "required" where it must be given
  std::string meaning;   ///< one sentence
  std::function<void(const KeyValue&, T&)> set;
  bool isRequired = false;
};

template <class T>
using Keys = std::vector<Key<T>>;

/// Reads a table into `out` by its keys; throws Error at an unknown or a missing key.
template <class T>
void readTable(const std::string& file, const std::string& section, const toml::table& table,
  const Keys<T>& keys, T& out);

// How defaults and types are written in the documentation.
std::string written(double number);
std::string writtenType(const std::string& kind, const std::string& unit, const Range& range);
std::string writtenIntegerType(long long lowest, long long highest);
std::string writtenChoices(const std::vector<std::string>& names);
std::string writtenText(const std::string& text);
template <std::size_t N>
std::string writtenList(const std::array<double, N>& numbers)
{
  std::string text;
  for (const double number : numbers)
  {
    text += (text.empty() ? "[" : ", ") + written(number);
  }
  return text + "]";
}

// The kinds of keys. `access` is a pointer to member, or a function from T& to the value's place.
template <class T, class Access>
Key<T> numberKey(
  const char* name, Access access, const Range& range, const char* unit, const char* meaning)
{
  T defaults;
  return { name, writtenType("number", unit, range), written(std::invoke(access, defaults)),
    meaning,
    [=](const KeyValue& value, T& out) { std::invoke(access, out) = value.number(range); } };
}

template <class T, class Access>
Key<T> integerKey(
  const char* name, Access access, long long lowest, long long highest, const char* meaning)
{
  T defaults;
  using Integer = std::decay_t<decltype(std::invoke(access, defaults))>;
  return { name, writtenIntegerType(lowest, highest), std::to_string(std::invoke(access, defaults)),
    meaning, [=](const KeyValue& value, T& out) {
      std::invoke(access, out) = static_cast<Integer>(value.integer(lowest, highest));
    } };
}

template <class T, class Access>
Key<T> textKey(const char* name, Access access, const char* meaning)
{
  T defaults;
  return { name, "text", writtenText(std::invoke(access, defaults)), meaning,
    [=](const KeyValue& value, T& out) { std::invoke(access, out) = value.text(); } };
}

template <class T, class Access>
Key<T> flagKey(const char* name, Access access, const char* meaning)
{
  T defaults;
  return { name, "true or false", std::invoke(access, defaults) ? "true" : "false", meaning,
    [=](const KeyValue& value, T& out) { std::invoke(access, out) = value.flag(); } };
}

/// `names` are the enumerators in their order, the first with the value `first`.
template <class T, class Access>
Key<T> choiceKey(const char* name, Access access, const std::vector<std::string>& names,
  const char* meaning, int first = 0)
{
  T defaults;
  using Enum = std::decay_t<decltype(std::invoke(access, defaults))>;
  return { name, writtenChoices(names),
    writtenText(names[static_cast<int>(std::invoke(access, defaults)) - first]), meaning,
    [=](const KeyValue& value, T& out) {
      std::invoke(access, out) = static_cast<Enum>(first + int(value.choice(names)));
    } };
}

/// A list of N numbers, N that of the std::array it is kept in.
template <class T, class Access>
Key<T> listKey(
  const char* name, Access access, const Range& range, const char* unit, const char* meaning)
{
  T defaults;
  const std::size_t count = std::invoke(access, defaults).size();
  return { name, writtenType(std::to_string(count) + " numbers", unit, range),
    writtenList(std::invoke(access, defaults)), meaning, [=](const KeyValue& value, T& out) {
      const std::vector<double> numbers = value.numbers(count, range);
      std::copy(numbers.begin(), numbers.end(), std::invoke(access, out).begin());
    } };
}

/// A section of its own, read by `set`.
template <class T>
Key<T> sectionKey(const char* name, std::function<void(const KeyValue&, T&)> set)
{
  return { name, "", "", "", std::move(set) };
}

template <class T>
Key<T> required(Key<T> key)
{
  key.byDefault = "required";
  key.isRequired = true;
  return key;
}

/// The same key with another word for its default, where the struct's value does not tell it.
template <class T>
Key<T> withDefault(Key<T> key, const char* byDefault)
{
  key.byDefault = byDefault;
  return key;
}

[[noreturn]] void failAtUnknownKey(
  const KeyValue& value, const std::string& section, const std::vector<std::string>& known);
[[noreturn]] void failAtMissingKey(const std::string& file, const std::string& section,
  const toml::table& table, const std::string& key, const std::string& type);

template <class T>
void readTable(const std::string& file, const std::string& section, const toml::table& table,
  const Keys<T>& keys, T& out)
{
  for (const auto& [name, node] : inTextOrder(table))
  {
    const KeyValue value(file, name, *node);
    const auto key = std::find_if(
      keys.begin(), keys.end(), [&name = name](const Key<T>& k) { return k.name == name; });
    if (key == keys.end())
    {
      std::vector<std::string> known;
      for (const Key<T>& k : keys)
      {
        known.push_back(k.name);
      }
      failAtUnknownKey(value, section, known);
    }
    key->set(value, out);
  }
  for (const Key<T>& key : keys)
  {
    if (key.isRequired && !table.contains(key.name))
    {
      failAtMissingKey(file, section, table, key.name, key.type);
    }
  }
}

/// The rows of a Markdown table, one a key, headed by the section's name.
template <class T>
std::string describeSection(const std::string& section, const Keys<T>& keys)
{
  std::string rows;
  for (const Key<T>& key : keys)
  {
    if (!key.type.empty())
    {
      rows += "| `" + section + "` | `" + key.name + "` | " + key.type + " | " + key.byDefault +
        " | " + key.meaning + " |\n";
    }
  }
  return rows;
}
} // namespace galaxy

#endif
