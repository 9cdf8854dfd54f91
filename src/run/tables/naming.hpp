#pragma once

#include "base/failure.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace matrigrate::store {

/// What `call` returns. @throws InputOutputError as it does, with the file named in front
template <class Call>
auto naming(const std::filesystem::path& file, const Call& call) {
  try {
    return call();
  } catch (const InputOutputError& trouble) {
    throw InputOutputError(fmt::format("{}: {}", file.string(), trouble.what()));
  }
}

} // namespace matrigrate::store
