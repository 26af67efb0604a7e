// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

// The options of a part of the suite are one plain struct with defaults and one free function
//
//   template <class P, class F> void visit(P& p, F&& f) {
//     f(options::Option{"cell_size_m", "edge of a cell, m", {0.01, 10}}, p.cell_size_m);
//     ...
//   }
//
// in the struct's namespace. Loading, saving, checking, the options table of doc/ and
// ini/reference.ini all come from that one list.
namespace traverse::options
{
/** Closed interval of allowed numbers; ignored for text, flags and enumerations. */
struct Range
{
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
};

/** What visit() says about one member. */
struct Option
{
  std::string_view key;
  std::string_view meaning;  //!< one line, with the unit
  Range range{};
};

/** A value that is no value of its option; says the key, the value and what is allowed. */
class OptionError : public std::runtime_error
{
 public:
  OptionError(std::string_view key, std::string_view value, std::string_view allowed);
};

/** Specialise for an enum: `static constexpr std::array<std::pair<E, std::string_view>, N> kNames`.
 */
template <class E>
struct EnumNames;

/** A member of visit() as text and back. Numbers are read without regard to the locale, whole:
 * "1,5", "1.5x", "nan", "inf" and "" are errors. */
void parse(const Option& option, std::string_view text, bool& value);
void parse(const Option& option, std::string_view text, int& value);
void parse(const Option& option, std::string_view text, double& value);
void parse(const Option& option, std::string_view text, std::string& value);
void parse(
    const Option& option, std::string_view text, std::vector<double>& value);  //!< blanks between
std::string format(bool value);
std::string format(int value);
std::string format(double value);  //!< shortest text that reads back as the same number
std::string format(const std::string& value);
std::string format(const std::vector<double>& value);

/** Throws OptionError where a number is out of the option's range. */
void check(const Option& option, double value);

template <class E>

requires std::is_enum_v<E> std::string format(E value)
{
  for (const auto& [e, name] : EnumNames<E>::kNames)
  {
    if (e == value)
    {
      return std::string(name);
    }
  }
  return "?";
}

/** "a | b | c", the names of an enumeration. */
template <class E>
std::string enumChoices()
{
  std::string all;
  for (const auto& [e, name] : EnumNames<E>::kNames)
  {
    all += (all.empty() ? "" : " | ") + std::string(name);
  }
  return all;
}

template <class E>
requires std::is_enum_v<E>

void parse(const Option& option, std::string_view text, E& value)
{
  for (const auto& [e, name] : EnumNames<E>::kNames)
  {
    if (name == text)
    {
      value = e;
      return;
    }
  }
  throw OptionError(option.key, text, enumChoices<E>());
}

/** One row of an options table. */
struct Row
{
  std::string key, value, type, allowed, meaning;
};

/** "[min, max]", "true | false", "text", ...: what may stand there, for tables and messages. */
std::string rangeText(const Option& option);

template <class T>
std::pair<std::string, std::string> typeAndAllowed(const Option& option)
{
  if constexpr (std::is_same_v<T, bool>)
  {
    return {"bool", "true | false"};
  }
  else if constexpr (std::is_same_v<T, int>)
  {
    return {"int", rangeText(option)};
  }
  else if constexpr (std::is_same_v<T, double>)
  {
    return {"number", rangeText(option)};
  }
  else if constexpr (std::is_same_v<T, std::vector<double>>)
  {
    return {"numbers", rangeText(option)};
  }
  else if constexpr (std::is_enum_v<T>)
  {
    return {"name", enumChoices<T>()};
  }
  else
  {
    return {"text", "any"};
  }
}

/** Every option of p with its present value, in the order of visit(). */
template <class P>
std::vector<Row> rows(const P& p)
{
  std::vector<Row> all;
  visit(
      p,
      [&](const Option& o, const auto& member)
      {
        const auto [type, allowed] = typeAndAllowed<std::remove_cvref_t<decltype(member)>>(o);
        all.push_back({std::string(o.key), format(member), type, allowed, std::string(o.meaning)});
      });
  return all;
}

/** Sets the option `key` from text. Returns false where p has no such key; throws OptionError. */
template <class P>
bool set(P& p, std::string_view key, std::string_view text)
{
  bool found = false;
  visit(
      p,
      [&](const Option& o, auto& member)
      {
        if (o.key == key)
        {
          parse(o, text, member);
          found = true;
        }
      });
  return found;
}

/** Throws OptionError where a member of p is out of its range (for structs filled by code). */
template <class P>
void check(const P& p)
{
  visit(
      p,
      [](const Option& o, const auto& member)
      {
        if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(member)>>)
        {
          check(o, static_cast<double>(member));
        }
      });
}

/** The word of `known` nearest to `word` by edit distance, or "" where none is near. */
std::string nearest(std::string_view word, const std::vector<std::string>& known);
}  // namespace traverse::options
