#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <filesystem>
#include <string_view>

/// JSON from files that may come from anyone. Test: tests/unit/store/json_text_test.cpp
namespace matrigrate::store {

/// Levels of brackets within brackets: what is deeper would take the stack of those who copy, write or delete it. The
/// program's own files have less than ten.
inline constexpr std::size_t max_json_levels = 100;

/// @throws InputOutputError if the text has more levels
void require_shallow(std::string_view json);

/// What a JSON text holds; discarded (Json::is_discarded) where it is no JSON or has too many levels.
nlohmann::ordered_json parse_json(std::string_view text);

/// The JSON object of a file.
/// @throws InputOutputError naming the file, if it cannot be read, is no JSON, no object, or has too many levels
nlohmann::ordered_json read_json_object(const std::filesystem::path& file, std::size_t max_bytes);

} // namespace matrigrate::store
