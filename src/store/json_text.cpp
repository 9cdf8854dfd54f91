#include "store/json_text.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "store/naming.hpp"

#include <fmt/format.h>

#include <string>

namespace matrigrate::store {

using Json = nlohmann::ordered_json;

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
      throw InputOutputError(fmt::format("has brackets within brackets, more than {} levels", max_json_levels));
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

Json read_json_object(const std::filesystem::path& file, std::size_t max_bytes) {
  const std::string text = read_file(file, max_bytes);
  return naming(file, [&text] {
    require_shallow(text);
    Json json = Json::parse(text, nullptr, false);
    if (json.is_discarded()) throw InputOutputError("is no JSON");
    if (!json.is_object()) throw InputOutputError(fmt::format("is no JSON object, but of type {}", json.type_name()));
    return json;
  });
}

} // namespace matrigrate::store
