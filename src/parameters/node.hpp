#pragma once

#include "parameters/assign.hpp"

#include <toml++/toml.h>

#include <string_view>

/// What stands at a place of a TOML file. Test: tests/unit/parameters/read_test.cpp
namespace matrigrate {

/// The kind of a value in words: "a table", "a number".
std::string_view type_of(const toml::node& node);

/// The value as assign() takes it.
Given given_by(const toml::node& node);

/// The same for a row: a table of names that laws.constants is given becomes its text, "F_c = 0.1 nN, n = 2".
Given given_for(const Row& row, const toml::node& node);

} // namespace matrigrate
