#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

/// What this program is made of and what it runs on.
namespace matrigrate::run {

/// "0.1.0 (1234abcd)", "0.1.0 (1234abcd, changed sources)" if the tree had changes.
std::string version_text();

/// version_text() after the name of the program.
std::string version_line();

/// {version, git_hash, git_dirty, compiler, flags, build_type, sanitizers, libraries: {name: version},
///  cpu: {model, threads, simd: [names]}}
nlohmann::ordered_json provenance();

/// provenance() as text for people.
std::string provenance_text();

} // namespace matrigrate::run
