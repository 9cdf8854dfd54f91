// What JavaScript calls: one simulation at a time; text goes in and out as JSON, frames as typed arrays. Test:
// web/tests/core.mjs
#include "base/failure.hpp"
#include "ecm/loop/fibres.hpp"
#include "observe/frame.hpp"
#include "observe/readouts.hpp"
#include "observe/tracks.hpp"
#include "parameters/laws/law.hpp"
#include "parameters/presets.hpp"
#include "parameters/read.hpp"
#include "parameters/schema.hpp"
#include "parameters/write.hpp"
#include "run/cadence.hpp"
#include "simulation/simulation.hpp"
#include "simulation/start.hpp"
#include "sph/kernel.hpp"
#include "state/image.hpp"
#include "state/initial.hpp"

#include <emscripten/bind.h>
#include <emscripten/val.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <functional>
#include <memory>
#include <new>
#include <string_view>
#include <utility>

namespace matrigrate::live {

namespace {

using Json = nlohmann::ordered_json;
using emscripten::val;

run::Cadence rows_of(const Parameters& p) { return {p.output.track_interval, p.run.time_step}; }

/// A simulation that a page follows, with the rows of its tracks; its state can be kept and taken up again.
class Followed {
public:
  /// From the beginning.
  explicit Followed(const Parameters& p) : m_simulation(p), m_rows(rows_of(p)) { keep_track(); }

  /// From a state kept by image(), with the parameters that it then had.
  /// @throws std::invalid_argument if the bytes are no such state, or one of another size
  Followed(const Parameters& p, std::string_view image) : m_simulation(p, state_of(image)), m_rows(rows_of(p)) {
    m_rows.due(state().t); // its row was taken before
  }

  /// Advances until t_end [s], run.duration, or `enough`, which is asked after each step.
  /// @throws NumericalFailure
  void march(double t_end, const std::function<bool()>& enough) {
    m_simulation.march(std::min(t_end, parameters().run.duration), {}, [&](const State& /*now*/) {
      keep_track();
      return !enough();
    });
  }

  /// Advances to the next multiple of run.time_step, where a branch of the program can begin, and goes on with other
  /// parameters from there.
  /// @param overrides  "key=value"
  /// @throws ConfigurationError naming what cannot change, or is wrong; nothing has happened then
  /// @throws NumericalFailure
  void change(const std::vector<std::string>& overrides) {
    m_simulation.change(apply_overrides(parameters(), overrides, start_rules()), {}, [&](const State& /*now*/) {
      keep_track();
      return true;
    });
    m_rows = rows_of(parameters());
    m_rows.due(state().t);
  }

  /// True if run.duration is reached.
  bool done() const { return state().t >= parameters().run.duration - 0.5 * parameters().run.time_step; }

  const State& state() const { return m_simulation.s; }
  const Parameters& parameters() const { return m_simulation.p; }
  observe::Frame frame() const { return observe::frame(m_simulation.s, m_simulation.p, m_simulation.w); }

  /// Rows at the multiples of output.track_interval that were passed since the last call.
  std::vector<TrackRow> take_tracks() { return std::exchange(m_tracks, {}); }

private:
  void keep_track() {
    if (!m_rows.due(state().t)) return;
    for (const TrackRow& row : track_rows(state())) m_tracks.push_back(row);
  }

  Simulation m_simulation;
  std::vector<TrackRow> m_tracks;
  run::Cadence m_rows; ///< of the tracks
};

std::unique_ptr<Followed>& running() {
  static std::unique_ptr<Followed> one;
  return one;
}

Followed& simulation() {
  if (!running()) throw std::logic_error("there is no simulation yet");
  return *running();
}

Json faults_json(const std::vector<Fault>& faults) {
  Json all = Json::array();
  for (const Fault& fault : faults)
    all.push_back({{"line", fault.line}, {"column", fault.column}, {"key", fault.key}, {"message", fault.message}});
  return all;
}

/// What `act` returns; where it fails, {"faults": [...]} for a wrong scenario and {"failure": "..."} for all else.
template <class Act>
std::string answer(const Act& act) {
  try {
    return act().dump();
  } catch (const ConfigurationError& error) {
    return Json{{"faults", faults_json(error.faults())}}.dump();
  } catch (const std::bad_alloc&) {
    return Json{{"failure", "the browser gives no more memory"}}.dump();
  } catch (const std::exception& error) {
    return Json{{"failure", error.what()}}.dump(-1, ' ', false, Json::error_handler_t::replace);
  }
}

std::vector<std::string> strings(const std::string& json) { return Json::parse(json).get<std::vector<std::string>>(); }

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }

/// Where the simulation is.
Json now_json() {
  const Followed& s = simulation();
  return {{"t_s", s.state().t}, {"step", s.state().step}, {"done", s.done()}};
}

Json value_json(const Row& row, const Parameters& p) {
  return {{"path", row.path}, {"value", Json::parse(value_text(row, p))}};
}

/// Every parameter whose value differs between the two.
Json changed_json(const Parameters& base, const Parameters& p) {
  Json all = Json::array();
  for (const Row& row : schema())
    if (differs(row, base, p)) all.push_back(value_json(row, p));
  return all;
}

/// From a particle to those that fibres join it to; of two opposite bonds one. Empty where their direction varies.
Json bonds_json(const Parameters& p) {
  Json bonds = Json::array();
  if (p.fibres.arrangement == FibreArrangement::none || !p.fibres.field.direction_deg.empty()) return bonds;
  const Kernel kernel(p.ecm.smoothing_length);
  for (const Vec2& X : lattice_patch(p.ecm, 2.0 * p.ecm.smoothing_length)) {
    const bool once = X.y() > 0.0 || (X.y() == 0.0 && X.x() > 0.0);
    if (once && kernel.W(X.norm()) > 0.0 && joined(X, p.fibres)) bonds.push_back({X.x(), X.y()});
  }
  return bonds;
}

/// Of all cells: points on their outlines, particles of their nuclei; of several the number of the cell of each point.
void put_cells(Json& head, const observe::Frame& frame) {
  head["n_outline"] = frame.outline.front.size();
  head["n_nucleus"] = frame.nucleus.size() / 2;
  if (!frame.outline.cell.empty()) head["cell"] = frame.outline.cell;
}

/// Places of the particles of rigid obstacles [um].
Json obstacles_json(const EcmState& ecm) {
  Json places = Json::array();
  for (std::size_t i = 0; i < ecm.size(); ++i)
    if (ecm.in_obstacle(i)) places.push_back({ecm.X[i].x(), ecm.X[i].y()});
  return places;
}

Json head_json() {
  const Followed& s = simulation();
  const Parameters& p = s.parameters();
  Json head = now_json();
  head["radius_um"] = p.ecm.radius;
  head["spacing_um"] = p.ecm.particle_spacing;
  head["n_particles"] = s.state().ecm.size();
  put_cells(head, s.frame());
  head["duration_s"] = p.run.duration;
  head["bonds_um"] = bonds_json(p);
  head["onset"] = p.fibres.onset;
  head["attractant"] = !s.state().ecm.attractant.empty();
  head["obstacles_um"] = obstacles_json(s.state().ecm);
  head["changed"] = changed_json(Parameters{}, p);
  return head;
}

Json record_json(const ProtrusionRecord& r, const Parameters& p) {
  return {{"id", r.id},
          {"centre_particle", r.centre},
          {"t_initiation_s", number(r.t_initiation)},
          {"t_adhesion_s", number(r.t_adhesion)},
          {"t_mature_s", number(r.t_mature)},
          {"t_disassembly_s", number(r.t_disassembly)},
          {"t_end_s", number(r.t_end)},
          {"length_um", number(r.length)},
          {"f_mat", number(r.f_mat)},
          {"force_nN", number(r.force)},
          {"f_adh_rel", number(relative_force(r, p))},
          {"cause", name(r.cause)}};
}

/// Makes a file in memory, for fields that a scenario names.
void put_file(const std::string& name, const std::string& content) { std::ofstream(name, std::ios::binary) << content; }

Parameters read(const std::string& toml, const std::string& overrides) {
  return parse_parameters(toml, "", strings(overrides), start_rules());
}

/// Checks a scenario. @return {"changed": [...], "toml": "..."}: what differs from the defaults of the program, and the
/// resolved scenario
std::string check(const std::string& toml, const std::string& overrides) {
  return answer([&] {
    const Parameters p = read(toml, overrides);
    return Json{{"changed", changed_json(Parameters{}, p)}, {"toml", to_toml(p)}};
  });
}

/// @param image  a state that was kept, to go on from; "": the beginning
std::string start(const std::string& toml, const std::string& overrides, const std::string& image) {
  return answer([&] {
    const Parameters p = read(toml, overrides);
    running().reset(); // two at a time need twice the memory
    running() = image.empty() ? std::make_unique<Followed>(p) : std::make_unique<Followed>(p, image);
    return head_json();
  });
}

/// @param wall_ms  returns after about so long, at the soonest after a step, or when t_end is reached
std::string march(double t_end, double wall_ms) {
  using Clock = std::chrono::steady_clock;
  return answer([&] {
    const auto until = Clock::now() + std::chrono::duration<double, std::milli>(wall_ms);
    simulation().march(t_end, [&] { return Clock::now() >= until; });
    return now_json();
  });
}

std::string change(const std::string& overrides) {
  return answer([&] {
    simulation().change(strings(overrides));
    return head_json();
  });
}

/// Puts numbers into the member `name` of `out`: into the array of that name in `spare` where it has their length, else
/// into a new one. Pictures come ten times a second, so that new arrays each time would be much garbage.
template <class T>
void put(val& out, const val& spare, const char* name, const char* type, const std::vector<T>& numbers) {
  const val view(emscripten::typed_memory_view(numbers.size(), numbers.data()));
  const val old = spare.isUndefined() ? val::undefined() : spare[name];
  if (old.isUndefined() || old["length"].as<std::size_t>() != numbers.size()) {
    out.set(name, val::global(type).new_(view));
    return;
  }
  old.call<void>("set", view);
  out.set(name, old);
}

/// What holds for the particles at all times: reference positions [um], and the layers of properties that vary.
val matrix() {
  const observe::FrameHead head = observe::frame_head(simulation().state(), simulation().parameters());
  const val none = val::undefined();
  val out = val::object();
  put(out, none, "reference", "Float32Array", head.reference);
  val layers = val::array();
  for (std::size_t k = 0; k < head.layers.size(); ++k) {
    if (head.layers[k].empty()) continue;
    const MatrixField& known = observe::matrix_layers()[k];
    val layer = val::object();
    layer.set("name", std::string(known.layer));
    layer.set("unit", std::string(known.layer_unit == "1" ? "" : known.layer_unit));
    layer.set("title", std::string(known.title));
    layer.set("meaning", std::string(known.meaning));
    put(layer, none, "values", "Float32Array", head.layers[k]);
    layers.call<void>("push", layer);
  }
  out.set("layers", layers);
  return out;
}

/// Copies of what the page draws.
/// @param spare  a frame of before that nobody reads any more, or undefined; its arrays are used again
val frame(const val& spare) {
  const observe::Frame f = simulation().frame();
  val out = val::object();
  const auto floats = [&](const char* name, const observe::Floats& numbers) {
    put(out, spare, name, "Float32Array", numbers);
  };
  const auto bytes = [&](const char* name, const observe::Bytes& numbers) {
    put(out, spare, name, "Uint8Array", numbers);
  };
  observe::Bytes f_degr;
  for (const float value : f.matrix.f_degr) f_degr.push_back(static_cast<std::uint8_t>(std::lround(255.0F * value)));
  out.set("t_s", f.t);
  floats("displacement", f.matrix.displacement);
  bytes("f", f_degr);
  floats("pressure", f.matrix.pressure);
  floats("vonMises", f.matrix.von_mises);
  if (!f.matrix.fibre_von_mises.empty()) floats("fibreVonMises", f.matrix.fibre_von_mises);
  if (!f.matrix.attractant.empty()) floats("attractant", f.matrix.attractant);
  floats("outline", f.outline.x);
  bytes("front", f.outline.front);
  bytes("protrusionOf", f.outline.protrusion);
  floats("fMat", f.outline.f_mat);
  floats("force", f.outline.force);
  if (!f.nucleus.empty()) floats("nucleus", f.nucleus);
  if (!f.protrusions.cell.empty()) floats("cells", f.protrusions.cell);
  floats("ids", f.protrusions.id);
  floats("centres", f.protrusions.centre);
  bytes("phases", f.protrusions.phase);
  floats("anchors", f.protrusions.anchor);
  floats("fMats", f.protrusions.f_mat);
  floats("forces", f.protrusions.force);
  return out;
}

/// Rows of tracks since the last call; those of several cells end with the number of the cell.
std::string tracks() {
  return answer([] {
    const bool several = simulation().state().cells.size() > 1;
    Json all = Json::array();
    for (const TrackRow& row : simulation().take_tracks()) {
      all.push_back({row.t, row.centre.x(), row.centre.y(), row.area, row.perimeter,
                     row.polarization ? Json(*row.polarization) : Json(), row.alive()});
      if (several) all.back().push_back(number_of(row.cell));
    }
    return all;
  });
}

/// Protrusions of one cell after those of the other, ended or alive, as the page of a run has them.
std::string protrusions() {
  return answer([] {
    const std::vector<Cell>& cells = simulation().state().cells;
    Json all = Json::array();
    for (const Cell& cell : cells)
      for (const ProtrusionRecord& r : protrusion_records(cell)) {
        all.push_back(record_json(r, simulation().parameters()));
        if (cells.size() > 1) all.back()["cell"] = number_of(cell.id);
      }
    return all;
  });
}

/// All of the state, to be read by this build of the program alone.
val image() {
  const std::string all = image_of(simulation().state());
  return val::global("Uint8Array")
      .new_(val(emscripten::typed_memory_view(all.size(), reinterpret_cast<const unsigned char*>(all.data()))));
}

std::string preset_list() {
  return answer([] {
    Json all = Json::array();
    for (const Preset& preset : presets())
      all.push_back({{"name", preset.name}, {"description", preset.description}, {"overrides", preset.overrides}});
    return all;
  });
}

/// The default laws, with what their formulas may name.
std::string law_list() {
  return answer([] {
    const Parameters usual;
    Json all = Json::array();
    for (const Row& law : law_rows()) {
      Json names = Json::array();
      for (const LawVariable& argument : law.arguments) names.push_back(argument.name);
      all.push_back({{"path", law.path},
                     {"unit", law.unit == "1" ? "" : law.unit},
                     {"meaning", description_of(law)},
                     {"formula", text_of(law, usual)},
                     {"arguments", names}});
    }
    return all;
  });
}

} // namespace

EMSCRIPTEN_BINDINGS(matrigrate) {
  using emscripten::function;
  function("putFile", &put_file);
  function("check", &check);
  function("start", &start);
  function("march", &march);
  function("change", &change);
  function("matrix", &matrix);
  function("frame", &frame);
  function("tracks", &tracks);
  function("protrusions", &protrusions);
  function("image", &image);
  function("presets", &preset_list);
  function("laws", &law_list);
}

} // namespace matrigrate::live
