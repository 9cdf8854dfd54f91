#include "parameters/node.hpp"

#include <fmt/format.h>

#include <sstream>
#include <utility>

namespace matrigrate {

std::string_view type_of(const toml::node& node) {
  switch (node.type()) {
  case toml::node_type::table:
    return "a table";
  case toml::node_type::array:
    return "an array";
  case toml::node_type::string:
    return "a string";
  case toml::node_type::boolean:
    return "a flag";
  case toml::node_type::integer:
  case toml::node_type::floating_point:
    return "a number";
  default:
    return "a date or time";
  }
}

Given given_by(const toml::node& node) {
  Given given{{}, type_of(node)};
  if (const auto* flag = node.as_boolean())
    given.value = flag->get();
  else if (const auto* whole = node.as_integer())
    given.value = whole->get();
  else if (const auto* real = node.as_floating_point())
    given.value = real->get();
  else if (const auto* text = node.as_string())
    given.value = text->get();
  return given;
}

Given given_for(const Row& row, const toml::node& node) {
  const toml::table* names = node.as_table();
  if (kind(row) != Kind::constants || names == nullptr) return given_by(node);
  std::string text;
  for (const auto& [name, value] : *names) {
    std::ostringstream number;
    if (const auto* quantity = value.as_string())
      number << quantity->get();
    else if (value.is_number())
      value.visit([&](const auto& typed) { number << typed; });
    else
      number << type_of(value);
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", name.str(), number.str());
  }
  return {std::move(text), "a table"};
}

} // namespace matrigrate
