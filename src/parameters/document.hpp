#pragma once

#include "base/failure.hpp"

#include <toml++/toml.h>

#include <string>
#include <string_view>
#include <vector>

/// TOML with all of its syntax errors at once. Test: tests/unit/parameters/read_test.cpp
namespace matrigrate {

/// A header that stands twice or cannot be read is replaced, so that the keys below it are still read: under a section
/// whose name starts with one of these, followed by a number and, for `repeated`, the section meant.
inline constexpr std::string_view repeated_section = "matrigrate-repeated-";
inline constexpr std::string_view unread_section = "matrigrate-unread-";

/// What could be read, and what could not.
struct Document {
  toml::table table;
  std::vector<Fault> faults;
};

/// The parser stops at its first error; the line at fault is taken out and the rest parsed again, some fifty times.
/// @param name  the file, as it stands in the faults
Document parse_document(std::string_view text, const std::string& name);

} // namespace matrigrate
