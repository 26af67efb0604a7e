// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>
#include <vector>

namespace traverse::formats
{
/** Takes lines and words off a text; CRLF does no harm. */
class TextLines
{
 public:
  explicit TextLines(std::string_view text) : text_(text) {}

  bool atEnd() const { return next_ >= text_.size(); }

  /** Byte of what comes next. */
  size_t position() const { return next_; }

  /** The next line without its end; empty at the end of the text. */
  std::string_view line()
  {
    next_ = std::min(next_, text_.size());
    const size_t end = std::min(text_.find('\n', next_), text_.size());
    std::string_view line = text_.substr(next_, end - next_);
    next_ = end + 1;
    if (!line.empty() && line.back() == '\r')
    {
      line.remove_suffix(1);
    }
    return line;
  }

  /** The next word, over ends of lines; empty at the end. */
  std::string_view word()
  {
    const size_t begin = std::min(text_.find_first_not_of(kBlanks, next_), text_.size());
    const size_t end = std::min(text_.find_first_of(kBlanks, begin), text_.size());
    next_ = end;
    return text_.substr(begin, end - begin);
  }

 private:
  static constexpr std::string_view kBlanks = " \t\r\n\v\f";

  std::string_view text_;
  size_t next_ = 0;
};

inline std::vector<std::string_view> wordsOf(std::string_view line)
{
  TextLines rest(line);
  std::vector<std::string_view> words;
  for (std::string_view word = rest.word(); !word.empty(); word = rest.word())
  {
    words.push_back(word);
  }
  return words;
}

inline std::string lowerCase(std::string_view text)
{
  std::string lower(text);
  std::transform(
      lower.begin(), lower.end(), lower.begin(),
      [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}
}  // namespace traverse::formats
