#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

/// What has to be known about the bytes of a TOML file before a parser sees them.
/// Test: tests/unit/parameters/hostile_test.cpp
namespace matrigrate {

/// A finding in a text.
struct Finding {
  int line = 0;   ///< 1-based
  int column = 0; ///< 1-based, in characters
  std::string message;
};

/// The first thing for which a text is not given to the parser: bytes that are no text (control characters, invalid
/// UTF-8), brackets and dotted keys nested so deeply that a recursive parser would run out of stack, or more than
/// 50,000 dotted keys, among which the parser searches one by one.
std::optional<Finding> unreadable(std::string_view text);

/// A piece of a file for a message: control characters replaced, cut to `most` characters.
std::string excerpt(std::string_view text, std::size_t most = 60);

} // namespace matrigrate
