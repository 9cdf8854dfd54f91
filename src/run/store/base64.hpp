#pragma once

#include <string>
#include <string_view>

/// Bytes as text. Test: tests/unit/store/store_test.cpp
namespace matrigrate::store {

/// base64 with padding (RFC 4648).
std::string base64(std::string_view bytes);

} // namespace matrigrate::store
