#include "tables/state_json.hpp"

#include "base/file.hpp"

#include <string>

namespace matrigrate::store {

double number(const Json& json) { return json.is_null() ? undefined : json.get<double>(); }

Vec2 vector(const Json& json) { return {number(json.at(0)), number(json.at(1))}; }

Json to_json(const Vec2& x) { return Json::array({x.x(), x.y()}); }

void require_shallow(std::string_view json) {
  std::size_t levels = 0;
  bool in_text = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (in_text && c == '\\')
      ++i;
    else if (c == '"')
      in_text = !in_text;
    else if (!in_text && (c == '[' || c == '{') && ++levels > max_json_levels)
      throw InputOutputError(fmt::format("has brackets nested more than {} levels deep", max_json_levels));
    else if (!in_text && (c == ']' || c == '}') && levels > 0)
      --levels;
  }
}

Json parse_json(std::string_view text) {
  try {
    require_shallow(text);
  } catch (const InputOutputError&) { // like text that is no JSON
    return Json(Json::value_t::discarded);
  }
  return Json::parse(text, nullptr, false);
}

Json parse_json_object(std::string_view text) {
  require_shallow(text);
  Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) throw InputOutputError("is no JSON");
  if (!json.is_object()) throw InputOutputError(fmt::format("is no JSON object, but of type {}", json.type_name()));
  return json;
}

Json read_json_object(const std::filesystem::path& file, std::size_t max_bytes) {
  const std::string text = read_file(file, max_bytes);
  return naming(file, [&text] { return parse_json_object(text); });
}

} // namespace matrigrate::store
