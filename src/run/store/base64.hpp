#pragma once

#include <string>
#include <string_view>

/// Bytes as text. Test: tests/unit/store/base64_test.cpp
namespace matrigrate::store {

/// base64 with padding (RFC 4648).
std::string base64(std::string_view bytes);

/// The bytes of a base64 text, up to its first character that is not a digit of base64.
std::string from_base64(std::string_view text);

} // namespace matrigrate::store
