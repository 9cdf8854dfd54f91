#pragma once

#include "base/failure.hpp"
#include "parameters/parameters.hpp"
#include "parameters/rules.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace matrigrate {

// From a scenario file to parameters. What a file leaves out has its default. A file that is not TOML has one fault,
// with its place; otherwise every fault of the file and of the overrides is reported at once, sorted by line, the
// first 200 in full. No fault leaves a half-read result. The time is linear in the length of the file. Test:
// tests/unit/parameters/read_test.cpp, tests/unit/parameters/hostile_test.cpp
//
// Files that other versions wrote are read as they were meant, also where this program does not compute that any more
// (Parameters::origin). Who computes names rules that must hold besides rules(), and is refused such a file.

/// @param overrides  "key=value" each, as after --set; the value in TOML or bare (400 Pa, hexagonal); the last one wins
/// @param more       rules that must hold besides rules()
/// @throws InputOutputError if the file cannot be read or has more than 1 MiB
/// @throws ConfigurationError with all faults
Parameters read_parameters(const std::filesystem::path& file, const std::vector<std::string>& overrides = {},
                           std::span<const Rule> more = {});

/// The same of the base of a study, which may break rules() that each of its points keeps.
Parameters read_unjudged(const std::filesystem::path& file);

/// @param name  stands for the file in faults
/// @throws ConfigurationError with all faults
Parameters parse_parameters(std::string_view text, const std::string& name,
                            const std::vector<std::string>& overrides = {}, std::span<const Rule> more = {});

/// Makes the text of a field the same from any folder: the whole path of its file, with a fingerprint of the content. A
/// text with a fingerprint is so already; its file is read when its values are needed.
/// @param folder  that names of files count from
/// @param grids   keeps what is read
/// @return what is wrong; empty if nothing is
std::string complete_field(std::string& text, const std::filesystem::path& folder, fields::Grids& grids);

/// @throws ConfigurationError with all faults, those of the file "--set"
Parameters apply_overrides(const Parameters& p, const std::vector<std::string>& overrides,
                           std::span<const Rule> more = {});

} // namespace matrigrate
