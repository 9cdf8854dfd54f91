#include "store/field_file.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "base/parallel.hpp"
#include "store/frame_log.hpp"
#include "store/hdf5.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace matrigrate::store {

namespace {

/// Where the view of frame k of an array is: "/frames/3/matrix/position" for "/matrix/position".
std::string frame_path(std::size_t k, std::string_view name) { return fmt::format("/frames/{}{}", k, name); }

/// Vectors of two components with a third one, 0; all else as it is.
observe::Floats in_space(const observe::Floats& values, std::uint32_t components) {
  if (components != 2) return values;
  observe::Floats all;
  all.reserve(values.size() / 2 * 3);
  for (std::size_t i = 0; i + 1 < values.size(); i += 2) all.insert(all.end(), {values[i], values[i + 1], 0.0F});
  return all;
}

observe::Floats positions(const observe::FrameHead& head, const observe::Frame& frame) {
  observe::Floats x = frame.matrix.displacement;
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += head.reference[i];
  return in_space(x, 2);
}

observe::Bytes solid(const observe::Frame& frame) {
  observe::Bytes flags;
  for (const float f : frame.matrix.f_degr) flags.push_back(f > 0.0F ? 1 : 0);
  return flags;
}

/// An array with numbers of each frame.
struct Column {
  std::string name;
  std::string_view unit;
  FrameArray array;
  std::function<std::string(const FrameArray&, const observe::Frame&)> compressed;
};

template <class Number>
void append(std::vector<Number>& to, const std::vector<Number>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

/// Writes fields.h5 frame by frame, and fields.xdmf with it.
class FieldWriter {
public:
  /// @param frames  how many there will be
  FieldWriter(const observe::FrameHead& head, std::size_t frames) : m_head(head), m_frames(frames) {}

  /// Writes each frame while the next one is compressed, and that after it read.
  /// @param next  gives them; none at the end
  void add_all(const std::function<std::optional<observe::Frame>()>& next) {
    std::optional<observe::Frame> before, now = next(), after;
    std::vector<std::string> of_before, of_now;
    if (now) begin(*now);
    while (before || now) {
      side_by_side({[&] {
                      if (now) of_now = compressed(*now);
                    },
                    [&] {
                      if (now) after = next();
                    },
                    [&] {
                      if (before) add(*before, of_before);
                    }});
      before = std::exchange(now, std::exchange(after, std::nullopt));
      of_before.swap(of_now);
    }
  }

  /// Writes what is of all frames.
  void finish(const FieldOrigin& origin) {
    if (!m_times.empty()) {
      write_protrusions();
      write_anchors();
    }
    m_file.write_attribute("program", origin.program);
    m_file.write_attribute("version", origin.version);
    m_file.write_attribute("seed", origin.seed);
    m_file.write_attribute("trajectory_hash", origin.trajectory_hash);
    m_file.write_attribute("scenario", origin.scenario);
    m_file.write("/time", m_times, "s");
    m_file.write("/matrix/radius", std::vector{m_head.radius}, "um");
    m_file.write("/matrix/spacing", std::vector{m_head.spacing}, "um");
    m_file.write("/matrix/reference", in_space(m_head.reference, 2), "um", 3);
    if (!m_head.obstacle.empty()) m_file.write("/matrix/obstacle", m_head.obstacle, "1");
    for (std::size_t k = 0; k < m_head.layers.size(); ++k)
      if (const MatrixField& layer = observe::matrix_layers()[k]; !m_head.layers[k].empty())
        m_file.write(fmt::format("/matrix/{}", layer.layer), m_head.layers[k], layer.layer_unit);
  }

  void add_all(const observe::Film& film, const FieldOrigin& origin) {
    auto frame = film.frames.begin();
    add_all([&] { return frame == film.frames.end() ? std::nullopt : std::optional(*frame++); });
    finish(origin);
  }

  std::string_view image() const { return m_file.view(); }
  std::size_t frames() const { return m_times.size(); }

  void save(const std::filesystem::path& folder) const {
    write_file(folder / field_file_name, image());
    write_file(folder / field_index_name, field_index(m_first ? &*m_first : nullptr, m_times, m_adhesions));
  }

private:
  /// @param first   frame, which tells the sizes
  void begin(const observe::Frame& first) {
    m_first = first;
    m_adhesions.assign(m_frames, 0);
    add_column("matrix/position", 3, "um", [this](const observe::Frame& f) { return positions(m_head, f); });
    add_column("matrix/solid", 1, "1", solid);
    for (const auto& field : observe::float_fields())
      if (!field.of_protrusions())
        add_column(field.name, field.components == 2 ? 3 : 1, field.unit,
                   [&field](const observe::Frame& f) { return in_space(field.in(f), field.components); });
    for (const auto& field : observe::byte_fields())
      if (!field.of_protrusions())
        add_column(field.name, 1, field.unit, [&field](const observe::Frame& f) { return field.in(f); });
  }

  template <class Of>
  void add_column(std::string_view field, std::uint32_t components, std::string_view unit, const Of& of) {
    const std::string name = fmt::format("/{}", field);
    if (const auto like = of(*m_first); !like.empty()) // else fibres, where there are none
      m_columns.push_back(
          {name, unit, FrameArray(m_file, name, like, m_frames, components, unit),
           [of](const FrameArray& array, const observe::Frame& frame) { return array.compressed(of(frame)); }});
  }

  /// The arrays of a frame as they are written; to compress them takes most of the time.
  std::vector<std::string> compressed(const observe::Frame& frame) const {
    std::vector<std::string> all(m_columns.size());
    parallel_parts(all.size(), [&](std::size_t k) { all[k] = m_columns[k].compressed(m_columns[k].array, frame); });
    return all;
  }

  /// @param arrays  compressed() of the frame
  void add(const observe::Frame& frame, const std::vector<std::string>& arrays) {
    const std::size_t now = m_times.size();
    for (std::size_t k = 0; k < m_columns.size(); ++k) {
      Column& column = m_columns[k];
      column.array.write(now, arrays[k]);
      m_file.name_frame(frame_path(now, column.name), column.name, now, column.unit);
    }
    for (const auto& field : observe::float_fields())
      if (field.of_protrusions()) append(field.of(m_table), field.in(frame));
    append(m_table.protrusions.phase, frame.protrusions.phase);
    m_frame_of_row.resize(m_table.protrusions.id.size(), static_cast<std::uint32_t>(now));
    m_times.push_back(frame.t);
  }

  void write_protrusions() {
    m_file.write("/protrusions/frame", m_frame_of_row, "1");
    for (const auto& field : observe::float_fields()) {
      if (!field.of_protrusions() || (field.of_several_cells() && m_first->outline.cell.empty())) continue;
      const std::string name = fmt::format("/{}", field.name);
      const observe::Floats& numbers = field.in(m_table);
      if (field.whole)
        m_file.write(name, std::vector<std::uint32_t>(numbers.begin(), numbers.end()), field.unit);
      else
        m_file.write(name, in_space(numbers, field.components), field.unit, field.components == 2 ? 3 : 1);
    }
    m_file.write("/protrusions/phase", m_table.protrusions.phase, "1");
  }

  /// The protrusions that adhere as points, for programs that draw fields.
  void write_anchors() {
    const observe::ProtrusionFrame& p = m_table.protrusions;
    std::vector<std::uint32_t> frames, ids;
    observe::Floats x, f_mat, force;
    for (std::size_t row = 0; row < p.id.size(); ++row) {
      if (std::isnan(p.anchor[2 * row])) continue;
      frames.push_back(m_frame_of_row[row]);
      ids.push_back(static_cast<std::uint32_t>(p.id[row]));
      x.insert(x.end(), {p.anchor[2 * row], p.anchor[2 * row + 1], 0.0F});
      f_mat.push_back(p.f_mat[row]);
      force.push_back(p.force[row]);
      ++m_adhesions[frames.back()];
    }
    m_file.write("/anchors/frame", frames, "1");
    m_file.write("/anchors/id", ids, "1");
    m_file.write("/anchors/position", x, "um", 3);
    m_file.write("/anchors/f_mat", f_mat, "1");
    m_file.write("/anchors/force", force, "nN");
    constexpr std::array<std::pair<const char*, const char*>, 4> views{
        {{"/anchors/id", "1"}, {"/anchors/position", "um"}, {"/anchors/f_mat", "1"}, {"/anchors/force", "nN"}}};
    std::size_t first = 0;
    for (std::size_t k = 0; k < m_adhesions.size(); first += m_adhesions[k++])
      if (m_adhesions[k] > 0)
        for (const auto& [name, unit] : views) m_file.name_rows(frame_path(k, name), name, first, m_adhesions[k], unit);
  }

  MemoryFile m_file;
  const observe::FrameHead& m_head;
  std::size_t m_frames;
  std::optional<observe::Frame> m_first;
  std::vector<double> m_times;
  std::vector<Column> m_columns;
  observe::Frame m_table{.matrix = {}, .outline = {}, .protrusions = {}}; ///< the protrusions of all frames
  std::vector<std::uint32_t> m_frame_of_row;
  std::vector<std::size_t> m_adhesions; ///< of each frame
};

} // namespace

std::string field_file(const observe::Film& film, const FieldOrigin& origin) {
  FieldWriter writer(film.head, film.frames.size());
  writer.add_all(film, origin);
  return std::string(writer.image());
}

void write_field_files(const std::filesystem::path& folder, const observe::Film& film, const FieldOrigin& origin) {
  FieldWriter writer(film.head, film.frames.size());
  writer.add_all(film, origin);
  writer.save(folder);
}

void write_field_files(const std::filesystem::path& folder, std::size_t frames, const FieldOrigin& origin) {
  const std::filesystem::path log = folder / frame_log_name;
  std::ifstream stream(log, std::ios::binary);
  std::optional<FrameReader> reader;
  naming(log, [&] { reader.emplace(stream); });
  FieldWriter writer(reader->head(), frames);
  naming(log, [&] {
    std::size_t read = 0;
    writer.add_all([&] { return read++ < frames ? reader->next() : std::nullopt; });
    if (writer.frames() != frames || reader->next())
      throw InputOutputError(fmt::format("does not hold the {} whole frames of the run", frames));
    writer.finish(origin);
  });
  writer.save(folder);
}

namespace {

/// An array at frame k.
std::string item(std::string_view name, std::string_view type, std::size_t k, std::size_t n, int components) {
  return fmt::format("<DataItem Dimensions=\"{}{}\" {} Format=\"HDF\">{}:{}</DataItem>", n, components == 3 ? " 3" : "",
                     type, field_file_name, frame_path(k, fmt::format("/{}", name)));
}

constexpr std::string_view floating = "NumberType=\"Float\" Precision=\"4\"";
constexpr std::string_view single_bytes = "NumberType=\"UChar\" Precision=\"1\"";
constexpr std::string_view whole_numbers = "NumberType=\"UInt\" Precision=\"4\"";

std::string attribute(std::string_view name, std::string_view type, std::size_t k, std::size_t n, int components) {
  return fmt::format("        <Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"Node\">{}</Attribute>\n",
                     name.substr(name.find('/') + 1), components == 3 ? "Vector" : "Scalar",
                     item(name, type, k, n, components));
}

/// All fields of one body; all frames have the same.
std::string attributes(std::string_view body, const observe::Frame& frame, std::size_t k, std::size_t n) {
  std::string text;
  for (const auto& field : observe::float_fields())
    if (field.name.starts_with(body) && field.name != "outline/position" && !field.in(frame).empty())
      text += attribute(field.name, floating, k, n, field.components == 2 ? 3 : 1);
  for (const auto& field : observe::byte_fields())
    if (field.name.starts_with(body)) text += attribute(field.name, single_bytes, k, n, 1);
  return text;
}

/// @param fields  its attributes
std::string grid(std::string_view name, const std::string& topology, double t, std::size_t k, std::size_t n,
                 const std::string& fields) {
  return fmt::format("      <Grid Name=\"{0}\" GridType=\"Uniform\">\n        <Time Value=\"{1}\"/>\n        {2}\n"
                     "        <Geometry GeometryType=\"XYZ\">{3}</Geometry>\n{4}      </Grid>\n",
                     name, t, topology, item(fmt::format("{}/position", name), floating, k, n, 3), fields);
}

std::string points(std::size_t n) {
  return fmt::format("<Topology TopologyType=\"Polyvertex\" NumberOfElements=\"{}\" NodesPerElement=\"1\"/>", n);
}

/// A line around each cell. All cells have as many particles.
std::string closed_lines(const observe::OutlineFrame& outline) {
  const std::vector<std::size_t> ends = observe::outline_ends(outline);
  std::string points;
  std::size_t first = 0;
  for (const std::size_t end : ends) {
    for (std::size_t i = first; i <= end; ++i) points += fmt::format("{} ", i == end ? first : i);
    first = end;
  }
  return fmt::format("<Topology TopologyType=\"Polyline\" NumberOfElements=\"{0}\" NodesPerElement=\"{1}\">"
                     "<DataItem Dimensions=\"{0} {1}\" NumberType=\"Int\" Format=\"XML\">{2}</DataItem></Topology>",
                     ends.size(), ends.front() + 1, points);
}

std::string collection(std::string_view name, const std::string& grids) {
  return fmt::format("    <Grid Name=\"{}\" GridType=\"Collection\" CollectionType=\"Temporal\">\n{}    </Grid>\n",
                     name, grids);
}

/// Readers find none at a time that is left out, and some of them stumble over a grid of no points.
std::string anchor_grids(std::span<const double> times, std::span<const std::size_t> anchors) {
  std::string text;
  for (std::size_t k = 0; k < times.size(); ++k) {
    const std::size_t n = anchors[k];
    if (n == 0) continue;
    text += grid("anchors", points(n), times[k], k, n,
                 attribute("anchors/id", whole_numbers, k, n, 1) + attribute("anchors/f_mat", floating, k, n, 1)
                     + attribute("anchors/force", floating, k, n, 1));
  }
  return text;
}

} // namespace

std::string field_index(const observe::Frame* first, std::span<const double> times,
                        std::span<const std::size_t> anchors) {
  std::string text = "<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.0\">\n  <Domain>\n";
  if (first != nullptr) {
    const std::size_t n = first->matrix.f_degr.size();
    const std::size_t m = first->outline.front.size();
    const std::string lines = m > 0 ? closed_lines(first->outline) : std::string();
    std::string matrix;
    std::string outline;
    for (std::size_t k = 0; k < times.size(); ++k) {
      matrix += grid("matrix", points(n), times[k], k, n,
                     attributes("matrix/", *first, k, n) + attribute("matrix/solid", single_bytes, k, n, 1));
      if (m > 0) outline += grid("outline", lines, times[k], k, m, attributes("outline/", *first, k, m));
    }
    text += collection("matrix", matrix);
    if (m > 0) text += collection("outline", outline);
    if (const std::string adhesions = anchor_grids(times, anchors); !adhesions.empty())
      text += collection("anchors", adhesions);
  }
  return text + "  </Domain>\n</Xdmf>\n";
}

namespace {

constexpr std::size_t max_field_file_bytes = std::size_t{64} << 30U;

template <class Number>
std::vector<Number> in_plane(const std::vector<Number>& values, std::uint32_t components) {
  if (components != 2) return values;
  std::vector<Number> all;
  all.reserve(values.size() / 3 * 2);
  for (std::size_t i = 0; i + 2 < values.size(); i += 3) all.insert(all.end(), {values[i], values[i + 1]});
  return all;
}

void read_protrusions(const MemoryFile& file, observe::Film& film) {
  std::vector<std::size_t> frames; // of the rows
  for (const float frame : file.floats("/protrusions/frame")) {
    if (!(frame >= 0.0F && static_cast<double>(frame) < static_cast<double>(film.frames.size())))
      throw InputOutputError("a protrusion belongs to no frame");
    frames.push_back(static_cast<std::size_t>(frame));
  }
  const auto hand_out = [&](const auto& field, const auto& numbers) {
    if (numbers.size() != frames.size() * field.components)
      throw InputOutputError("its tables of protrusions do not match in length");
    for (std::size_t row = 0; row < frames.size(); ++row) {
      const auto first = numbers.begin() + static_cast<std::ptrdiff_t>(row * field.components);
      auto& to = field.of(film.frames[frames[row]]);
      to.insert(to.end(), first, first + field.components);
    }
  };
  for (const auto& field : observe::float_fields())
    if (const std::string name = fmt::format("/{}", field.name);
        field.of_protrusions() && (field.of_all || file.has(name)))
      hand_out(field, in_plane(file.floats(name), field.components));
  for (const auto& field : observe::byte_fields())
    if (field.of_protrusions()) hand_out(field, file.array<std::uint8_t>(fmt::format("/{}", field.name)));
}

/// What all frames share, and their times.
observe::Film without_fields(const MemoryFile& file) {
  const std::vector<double> radius = file.array<double>("/matrix/radius"),
                            spacing = file.array<double>("/matrix/spacing");
  if (radius.size() != 1 || spacing.size() != 1) throw InputOutputError("is no field file of matrigrate");
  observe::Film film{
      .head = {.radius = radius[0], .spacing = spacing[0], .reference = in_plane(file.floats("/matrix/reference"), 2)},
      .frames = {}};
  if (file.has("/matrix/obstacle")) film.head.obstacle = file.array<std::uint8_t>("/matrix/obstacle");
  for (std::size_t k = 0; k < film.head.layers.size(); ++k)
    if (const std::string name = fmt::format("/matrix/{}", observe::matrix_layers()[k].layer); file.has(name))
      film.head.layers[k] = file.floats(name);
  if (!film.head.consistent()) throw InputOutputError("its arrays do not match");
  for (const double t : file.array<double>("/time"))
    film.frames.push_back({.t = t, .matrix = {}, .outline = {}, .protrusions = {}});
  return film;
}

observe::Film film_in(const MemoryFile& file, Wanted wanted) {
  observe::Film film = without_fields(file);
  std::vector<observe::Frame>& frames = film.frames;
  if (frames.empty()) return film;
  std::vector<bool> whole(frames.size(), true);
  const auto read = [&](const auto& field) {
    const std::string name = fmt::format("/{}", field.name);
    if (field.of_protrusions() || !file.has(name)) return;  // fibres, where there are none
    const std::size_t each = field.components == 2 ? 3 : 1; // vectors have a third component
    file.require_frames(name, frames.size(), field.name.starts_with("matrix/") ? each * film.head.particles() : 0);
    for (std::size_t k = 0; k < frames.size(); ++k) try {
        auto& numbers = field.of(frames[k]);
        using Number = typename std::remove_reference_t<decltype(numbers)>::value_type;
        numbers = in_plane(file.frame<Number>(name, k), field.components);
      } catch (const InputOutputError&) {
        if (wanted == Wanted::all) throw;
        whole[k] = false;
      }
  };
  std::ranges::for_each(observe::float_fields(), read);
  std::ranges::for_each(observe::byte_fields(), read);
  read_protrusions(file, film);
  const std::size_t fibres = file.has("/matrix/fibre_von_mises") ? film.head.particles() : 0;
  std::vector<observe::Frame> found;
  for (std::size_t k = 0; k < frames.size(); ++k)
    if (whole[k] && fits(frames[k], film.head, fibres))
      found.push_back(std::move(frames[k]));
    else if (wanted == Wanted::all)
      throw InputOutputError("its arrays do not match");
  frames = std::move(found);
  return film;
}

bool is_there(const std::filesystem::path& file) {
  std::error_code error;
  return std::filesystem::exists(file, error);
}

} // namespace

observe::Film read_field_file(std::string_view bytes, Wanted wanted) { return film_in(MemoryFile(bytes), wanted); }

observe::Film read_field_film(const std::filesystem::path& folder, Wanted wanted) {
  const std::filesystem::path path = folder / field_file_name;
  if (!is_there(path)) return {};
  std::string bytes = read_file(path, max_field_file_bytes);
  return naming(path, [&] {
    const MemoryFile file(bytes);
    bytes = std::string(); // HDF5 has taken a copy
    return film_in(file, wanted);
  });
}

observe::Film read_film(const std::filesystem::path& folder, const std::function<void(observe::Frame&)>& each) {
  const std::filesystem::path path = folder / frame_log_name;
  if (!is_there(path)) {
    observe::Film film = read_field_film(folder, Wanted::all);
    if (each) std::ranges::for_each(film.frames, each);
    return film;
  }
  return naming(path, [&] {
    std::ifstream log(path, std::ios::binary);
    return read_log(log, each);
  });
}

} // namespace matrigrate::store
