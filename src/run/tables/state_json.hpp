#pragma once

#include "base/failure.hpp"
#include "state/protrusion.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string_view>
#include <utility>

/// Parts of the state as JSON, to be read back to the same bits; what is not defined (NaN) is null. Reading throws
/// nlohmann::json::exception where something is missing or of another type.
/// Test: tests/unit/store/checkpoint_test.cpp
namespace matrigrate::store {

using Json = nlohmann::ordered_json;

// Files that may come from anyone. Test: tests/unit/store/store_test.cpp

/// Most levels of nested brackets: a deeper value would overflow the stack when it is copied, written or deleted. The
/// program's own files have less than ten.
inline constexpr std::size_t max_json_levels = 100;

/// @throws InputOutputError if the text has more levels
void require_shallow(std::string_view json);

/// What a JSON text holds; discarded (Json::is_discarded) where it is no JSON or has too many levels.
Json parse_json(std::string_view text);

/// The JSON object that a text holds.
/// @throws InputOutputError if it is no JSON, no object, or has too many levels
Json parse_json_object(std::string_view text);

/// The JSON object of a file.
/// @throws InputOutputError naming the file, if it cannot be read, is no JSON, no object, or has too many levels
Json read_json_object(const std::filesystem::path& file, std::size_t max_bytes);

/// What `read` makes of JSON.
/// @throws InputOutputError "what cannot be read: ...", also where something is missing or of another type
template <class Read>
auto understood(std::string_view what, const Read& read) {
  const auto refuse = [what](const std::exception& error) {
    return InputOutputError(fmt::format("{} cannot be read: {}", what, error.what()));
  };
  try {
    return read();
  } catch (const Json::exception& error) {
    throw refuse(error);
  } catch (const std::invalid_argument& error) {
    throw refuse(error);
  }
}

/// An integer that T can hold. @throws std::invalid_argument if it is none
template <class T>
T integer(const Json& json) {
  if (json.is_number_unsigned() && std::in_range<T>(json.get<std::uint64_t>()))
    return static_cast<T>(json.get<std::uint64_t>());
  if (json.is_number_integer() && !json.is_number_unsigned() && std::in_range<T>(json.get<std::int64_t>()))
    return static_cast<T>(json.get<std::int64_t>());
  throw std::invalid_argument("a number is no integer, or out of range");
}

double number(const Json& json); ///< NaN for null
Vec2 vector(const Json& json);   ///< [x, y]
Json to_json(const Vec2& x);     ///< [x, y]

} // namespace matrigrate::store
