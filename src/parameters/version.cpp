#include "parameters/version.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>

namespace matrigrate {

namespace {

/// {0, 2, 0} of "0.2.0"; what is no number counts as 0.
std::array<int, 3> numbers_of(std::string_view version) {
  std::array<int, 3> all{};
  for (int& number : all) {
    const std::size_t dot = std::min(version.find('.'), version.size());
    std::from_chars(version.data(), version.data() + dot, number);
    version.remove_prefix(std::min(dot + 1, version.size()));
  }
  return all;
}

} // namespace

bool has_this_model(std::string_view version) {
  const auto asked = numbers_of(version);
  return asked >= numbers_of(model_since) && asked <= numbers_of(this_version);
}

std::string version_of_program(std::string_view program) {
  const std::size_t name = program.find(' ');
  if (name != std::string_view::npos) program.remove_prefix(name + 1);
  return std::string(program.substr(0, program.find(' ')));
}

std::string model_text(std::string_view version) {
  if (has_this_model(version)) return {};
  if (numbers_of(version) > numbers_of(this_version))
    return fmt::format("{} is a later version, whose model may be another: results may differ, not only bits", version);
  return fmt::format(
      "the model has changed since {}: results differ, not only bits, most where adhesions mature within "
      "a few time steps",
      version);
}

} // namespace matrigrate
