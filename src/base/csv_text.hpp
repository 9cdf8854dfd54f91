#pragma once

#include <string>
#include <string_view>

namespace matrigrate {

/// Text as a field of CSV: in quotes where it holds a character that would end the field, and after an apostrophe where
/// a spreadsheet would compute it as a formula, that is, where it begins with = + - @, a tab or a line break and is no
/// number. Test: tests/unit/tables/tables_test.cpp
std::string csv_text(std::string_view field);

} // namespace matrigrate
