#include "store/field_file.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "base/parallel.hpp"
#include "store/frame_log.hpp"
#include "store/hdf5.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <fstream>
#include <optional>
#include <utility>

namespace matrigrate::store {

namespace {

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

/// An array with a frame of numbers made by `of` from each frame.
template <class Number>
struct Column {
  std::string name;
  std::string_view unit;
  std::function<std::vector<Number>(const observe::Frame&)> of;
  FrameArray array;
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

  void add(const observe::Frame& frame) {
    if (m_times.empty()) begin(frame);
    write(m_floats, frame);
    write(m_bytes, frame);
    for (const auto& field : observe::float_fields())
      if (field.of_protrusions()) append(field.of(m_table), field.in(frame));
    append(m_table.protrusions.phase, frame.protrusions.phase);
    m_frame_of_row.resize(m_table.protrusions.id.size(), static_cast<std::uint32_t>(m_times.size()));
    m_times.push_back(frame.t);
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
    for (const observe::Frame& frame : film.frames) add(frame);
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
    add_column(m_floats, "matrix/position", 3, "um", [this](const observe::Frame& f) { return positions(m_head, f); });
    add_column(m_bytes, "matrix/solid", 1, "1", solid);
    for (const auto& field : observe::float_fields())
      if (!field.of_protrusions())
        add_column(m_floats, field.name, field.components == 2 ? 3 : 1, field.unit,
                   [&field](const observe::Frame& f) { return in_space(field.in(f), field.components); });
    for (const auto& field : observe::byte_fields())
      if (!field.of_protrusions())
        add_column(m_bytes, field.name, 1, field.unit, [&field](const observe::Frame& f) { return field.in(f); });
  }

  template <class Number, class Of>
  void add_column(std::vector<Column<Number>>& columns, std::string_view field, std::uint32_t components,
                  std::string_view unit, const Of& of) {
    const std::string name = fmt::format("/{}", field);
    if (const std::vector<Number> like = of(*m_first); !like.empty()) // else fibres, where there are none
      columns.push_back({name, unit, of, FrameArray(m_file, name, like, m_frames, components, unit)});
  }

  template <class Number>
  void write(std::vector<Column<Number>>& columns, const observe::Frame& frame) {
    std::vector<std::string> compressed(columns.size());
    parallel_parts(columns.size(), [&](std::size_t k) {
      compressed[k] = columns[k].array.compressed(columns[k].of(frame)); // what takes the time
    });
    const std::size_t now = m_times.size();
    for (std::size_t k = 0; k < columns.size(); ++k) {
      Column<Number>& column = columns[k];
      column.array.write(now, compressed[k]);
      m_file.name_frame(frame_path(now, column.name), column.name, now, column.unit);
    }
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
  std::vector<Column<float>> m_floats;
  std::vector<Column<std::uint8_t>> m_bytes;
  observe::Frame m_table{.matrix = {}, .outline = {}, .protrusions = {}}; ///< the protrusions of all frames
  std::vector<std::uint32_t> m_frame_of_row;
  std::vector<std::size_t> m_adhesions; ///< of each frame
};

} // namespace

std::string frame_path(std::size_t k, std::string_view name) { return fmt::format("/frames/{}{}", k, name); }

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
    std::optional<observe::Frame> frame;
    while (writer.frames() < frames && (frame = reader->next())) writer.add(*frame);
    if (writer.frames() != frames || reader->next())
      throw InputOutputError(fmt::format("does not hold the {} whole frames of the run", frames));
    writer.finish(origin);
  });
  writer.save(folder);
}

} // namespace matrigrate::store
