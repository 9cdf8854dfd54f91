#include "store/state_json.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "store/naming.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <stdexcept>
#include <string>

namespace matrigrate::store {

namespace {

struct PhaseJson {
  Json operator()(const Growing& phase) const {
    return {{"direction", to_json(phase.direction)}, {"base_width", phase.base_width}};
  }
  Json operator()(const Maturing& phase) const {
    return {{"direction", to_json(phase.direction)},
            {"anchor", to_json(phase.anchor)},
            {"steps", phase.steps},
            {"last_step", phase.last_step},
            {"held", to_json(phase.held)}};
  }
  Json operator()(const Contracting& phase) const {
    return {{"anchor", to_json(phase.anchor)},
            {"f_mat", phase.f_mat},
            {"bundle", phase.bundle},
            {"falling", phase.falling},
            {"held", to_json(phase.held)}};
  }
  Json operator()(const Finishing& phase) const { return {{"f_mat", phase.f_mat}}; }
};

/// The anchor in the reference configuration; files of programs that did not know it do not need it.
Vec2 held_of(const Json& json) { return vector(json.contains("held") ? json.at("held") : json.at("anchor")); }

Phase phase_of(const Json& json) {
  const std::string name = json.at("name");
  if (name == "growing") return Growing{vector(json.at("direction")), number(json.at("base_width"))};
  if (name == "maturing")
    return Maturing{vector(json.at("direction")), vector(json.at("anchor")), integer<int>(json.at("steps")),
                    number(json.at("last_step")), held_of(json)};
  if (name == "contracting")
    return Contracting{vector(json.at("anchor")), number(json.at("f_mat")), number(json.at("bundle")),
                       number(json.at("falling")), held_of(json)};
  if (name == "finishing") return Finishing{number(json.at("f_mat"))};
  throw std::invalid_argument("there is no phase \"" + name + "\"");
}

EndCause cause_of(const std::string& text) {
  for (const EndCause cause :
       {EndCause::none, EndCause::unadhered, EndCause::disassembly, EndCause::rupture, EndCause::lost})
    if (name(cause) == text) return cause;
  throw std::invalid_argument("an adhesion does not end by \"" + text + "\"");
}

} // namespace

double number(const Json& json) { return json.is_null() ? undefined : json.get<double>(); }

Vec2 vector(const Json& json) { return {number(json.at(0)), number(json.at(1))}; }

Json to_json(const Vec2& x) { return Json::array({x.x(), x.y()}); }

Json to_json(const std::vector<Vec2>& points) {
  Json json = Json::array();
  for (const Vec2& x : points) json.push_back(to_json(x));
  return json;
}

std::vector<Vec2> vectors(const Json& json) {
  std::vector<Vec2> points;
  points.reserve(json.size());
  for (const Json& x : json) points.push_back(vector(x));
  return points;
}

Json to_json(const ProtrusionRecord& r) {
  return {{"id", r.id},
          {"centre", r.centre},
          {"t_initiation", r.t_initiation},
          {"t_adhesion", r.t_adhesion},
          {"t_mature", r.t_mature},
          {"t_disassembly", r.t_disassembly},
          {"t_end", r.t_end},
          {"length", r.length},
          {"direction", r.direction},
          {"f_mat", r.f_mat},
          {"force", r.force},
          {"cause", name(r.cause)}};
}

ProtrusionRecord record_of(const Json& json) {
  return {.id = integer<std::uint32_t>(json.at("id")),
          .centre = integer<std::uint32_t>(json.at("centre")),
          .t_initiation = number(json.at("t_initiation")),
          .t_adhesion = number(json.at("t_adhesion")),
          .t_mature = number(json.at("t_mature")),
          .t_disassembly = number(json.at("t_disassembly")),
          .t_end = number(json.at("t_end")),
          .length = number(json.at("length")),
          .direction = number(json.at("direction")),
          .f_mat = number(json.at("f_mat")),
          .force = number(json.at("force")),
          .cause = cause_of(json.at("cause").get<std::string>())};
}

Json to_json(const Protrusion& protrusion) {
  Json phase{{"name", name(protrusion.phase)}};
  phase.update(std::visit(PhaseJson{}, protrusion.phase));
  return {{"centre", protrusion.centre},
          {"since", protrusion.since},
          {"phase", phase},
          {"record", to_json(protrusion.record)}};
}

Protrusion protrusion_of(const Json& json) {
  return {.centre = integer<std::uint32_t>(json.at("centre")),
          .since = number(json.at("since")),
          .phase = phase_of(json.at("phase")),
          .record = record_of(json.at("record"))};
}

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
