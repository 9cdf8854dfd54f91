#include "exchange/simularium.hpp"

#include "observe/even_times.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <stdexcept>

namespace matrigrate::exchange {

namespace {

using Json = nlohmann::ordered_json;

// Numbers of the types of agents; that of cell k, counted from 0, is first_cell + k.
constexpr std::size_t matrix = 0, degraded = 1, adhesion = 2, nucleus = 3, obstacle = 4, first_cell = 5;
// Ids of agents: cells from 0, then nuclei, protrusions of each cell, particles of the matrix.
constexpr std::size_t first_nucleus = 1000, of_a_cell = 10000, first_particle = 10'000'000;

constexpr double line = 1.0;            // radius of a fibre [um]
constexpr double adhesion_radius = 1.2; // [um]
constexpr double in_front = 2.0;        // of the matrix: z of the cells [um]

Json type(const std::string& name, const char* shape, const char* colour) {
  return {{"name", name}, {"geometry", {{"displayType", shape}, {"url", ""}, {"color", colour}}}};
}

Json types(std::size_t cells) {
  static constexpr const char* colours[] = {"#2066a8", "#d55e00", "#009e73", "#cc79a7"};
  Json all{{"0", type("matrix#solid", "SPHERE", "#c8bfa9")},
           {"1", type("matrix#degraded", "SPHERE", "#eee9dd")},
           {"2", type("adhesion", "SPHERE", "#c1121f")},
           {"3", type("nucleus", "FIBER", "#4b3f72")},
           {"4", type("obstacle", "SPHERE", "#3c3c3c")}};
  for (std::size_t k = 0; k < cells; ++k)
    all[std::to_string(first_cell + k)] = type(fmt::format("cell {}", k + 1), "FIBER", colours[k % std::size(colours)]);
  return all;
}

Json point(double x, double y, double z) { return {{"x", x}, {"y", y}, {"z", z}}; }

Json info(const observe::Film& film, const observe::EvenTimes& times, std::size_t cells, const std::string& title,
          const std::string& version) {
  const double R = film.head.radius;
  return {{"version", 3},
          {"trajectoryTitle", title},
          {"modelInfo",
           {{"title", "Single-cell migration through a degradable viscoelastic matrix"},
            {"version", version},
            {"authors", "Heck et al. 2020; computed by Matrigrate"},
            {"description", "The cortex of the cell as a ring, its adhesions, and the particles of the matrix."},
            {"doi", "10.1371/journal.pcbi.1007250"}}},
          {"timeUnits", {{"magnitude", 1.0}, {"name", "s"}}},
          {"timeStepSize", times.all > 1 ? times.interval : 1.0},
          {"totalSteps", times.even},
          {"spatialUnits", {{"magnitude", 1.0}, {"name", "µm"}}},
          {"size", point(2.0 * R, 2.0 * R, 20.0)},
          {"cameraDefault",
           {{"position", point(0, 0, 1.4 * R)},
            {"lookAtPosition", point(0, 0, 0)},
            {"upVector", point(0, 1, 0)},
            {"fovDegrees", 75.0}}},
          {"typeMapping", types(cells)}};
}

/// Writes agents one after the other.
class Agents {
public:
  void sphere(std::size_t id, std::size_t of, double x, double y, double z, double radius) {
    begin();
    fmt::format_to(std::back_inserter(m_text), "1000,{},{},{:.2f},{:.2f},{:g},0,0,0,{:g},0", id, of, x, y, z, radius);
  }

  /// @param x  points from `first` to `end`; the first one follows the last one again
  void ring(std::size_t id, std::size_t of, const observe::Floats& x, std::size_t first, std::size_t end) {
    begin();
    fmt::format_to(std::back_inserter(m_text), "1001,{},{},0,0,0,0,0,0,{:g},{}", id, of, line, 3 * (end - first + 1));
    for (std::size_t k = first; k <= end; ++k) {
      const std::size_t i = k < end ? k : first;
      fmt::format_to(std::back_inserter(m_text), ",{:.3f},{:.3f},{:g}", x[2 * i], x[2 * i + 1], in_front);
    }
  }

  const std::string& text() const { return m_text; }

private:
  void begin() {
    if (!m_text.empty()) m_text += ',';
  }
  std::string m_text;
};

void add_cells(const observe::Frame& frame, Agents& agents) {
  const std::vector<std::size_t> ends = observe::outline_ends(frame.outline);
  const std::size_t of_nucleus = ends.empty() ? 0 : frame.nucleus.size() / 2 / ends.size();
  std::size_t first = 0;
  for (std::size_t k = 0; k < ends.size(); first = ends[k++]) {
    agents.ring(k, first_cell + k, frame.outline.x, first, ends[k]);
    if (of_nucleus > 0) agents.ring(first_nucleus + k, nucleus, frame.nucleus, k * of_nucleus, (k + 1) * of_nucleus);
  }
  const observe::ProtrusionFrame& p = frame.protrusions;
  for (std::size_t k = 0; k < p.id.size(); ++k) {
    if (std::isnan(p.anchor[2 * k])) continue;
    const std::size_t cell = p.cell.empty() ? 1 : p.cell[k];
    agents.sphere(cell * of_a_cell + p.id[k], adhesion, p.anchor[2 * k], p.anchor[2 * k + 1], in_front,
                  adhesion_radius);
  }
}

void add_matrix(const observe::FrameHead& head, const observe::Frame& frame, Agents& agents) {
  const double radius = 0.4 * head.spacing;
  for (std::size_t i = 0; i < head.particles(); ++i) {
    const bool rigid = !head.obstacle.empty() && head.obstacle[i] != 0;
    agents.sphere(first_particle + i,
                  rigid                           ? obstacle
                  : frame.matrix.f_degr[i] > 0.0F ? matrix
                                                  : degraded,
                  head.reference[2 * i] + frame.matrix.displacement[2 * i],
                  head.reference[2 * i + 1] + frame.matrix.displacement[2 * i + 1], 0.0, radius);
  }
}

Json plots(std::span<const TrackRow> rows, std::size_t cells) {
  Json distance = Json::array(), way = Json::array();
  for (std::size_t k = 0; k < cells; ++k) {
    const std::vector<TrackRow> own = rows_of(rows, static_cast<std::uint32_t>(k));
    Json t = Json::array(), d = Json::array(), x = Json::array(), y = Json::array();
    for (const TrackRow& row : own) {
      t.push_back(row.t);
      d.push_back((row.centre - own.front().centre).norm());
      x.push_back(row.centre.x());
      y.push_back(row.centre.y());
    }
    const std::string name = fmt::format("cell {}", k + 1);
    distance.push_back({{"name", name}, {"type", "scatter"}, {"mode", "lines"}, {"x", t}, {"y", d}});
    way.push_back({{"name", name}, {"type", "scatter"}, {"mode", "lines"}, {"x", x}, {"y", y}});
  }
  const auto plot = [](const char* title, const char* along, const char* up, const Json& data) -> Json {
    return {{"layout", {{"title", title}, {"xaxis", {{"title", along}}}, {"yaxis", {{"title", up}}}}}, {"data", data}};
  };
  return {{"version", 1},
          {"data", Json::array({plot("Distance from the start", "time (s)", "distance (µm)", distance),
                                plot("Path of the centre of mass", "x (µm)", "y (µm)", way)})}};
}

} // namespace

bool fits_simularium(const observe::Film& film) {
  const observe::EvenTimes times = observe::even_times(observe::times_of(film));
  return times.is_even() || times.but_the_last();
}

std::string simularium(const observe::Film& film, std::span<const TrackRow> rows, const std::string& title,
                       const std::string& version) {
  const observe::EvenTimes times = observe::even_times(observe::times_of(film));
  if (!fits_simularium(film)) throw std::invalid_argument(fmt::format("the frames are {}", times.text()));
  const std::size_t cells = observe::outline_ends(film.frames.front().outline).size();
  const auto text_of = [](const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); };
  std::string text =
      fmt::format("{{\"trajectoryInfo\":{},\n\"spatialData\":{{\"version\":1,\"msgType\":1,\"bundleStart\":0,"
                  "\"bundleSize\":{},\"bundleData\":[",
                  text_of(info(film, times, cells, title, version)), times.even);
  for (std::size_t k = 0; k < times.even; ++k) {
    Agents agents;
    add_cells(film.frames[k], agents);
    add_matrix(film.head, film.frames[k], agents);
    fmt::format_to(std::back_inserter(text), "{}\n{{\"frameNumber\":{},\"time\":{},\"data\":[{}]}}", k > 0 ? "," : "",
                   k, film.frames[k].t, agents.text());
  }
  return text + fmt::format("]}},\n\"plotData\":{}}}\n", text_of(plots(rows, cells)));
}

} // namespace matrigrate::exchange
