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
#include <utility>
#include <vector>

namespace matrigrate::store {

Anchors anchors(const observe::Frame& frame) {
  const observe::ProtrusionFrame& p = frame.protrusions;
  Anchors all;
  for (std::size_t i = 0; i < p.id.size(); ++i) {
    if (std::isnan(p.anchor[2 * i])) continue;
    all.x.insert(all.x.end(), {p.anchor[2 * i], p.anchor[2 * i + 1]});
    all.id.push_back(p.id[i]);
    all.f_mat.push_back(p.f_mat[i]);
    all.force.push_back(p.force[i]);
  }
  return all;
}

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

/// Writes fields.h5 frame by frame.
class FieldWriter {
public:
  /// @param first   frame, which tells the sizes
  FieldWriter(MemoryFile& file, const observe::FrameHead& head, const observe::Frame& first, std::size_t frames)
      : m_file(file), m_frames(frames), m_several(!first.outline.cell.empty()) {
    add_column(m_floats, "/matrix/position", 3, "um", first,
               [&head](const observe::Frame& f) { return positions(head, f); });
    add_column(m_bytes, "/matrix/solid", 1, "1", first, solid);
    for (const auto& field : observe::float_fields())
      if (!field.of_protrusions())
        add_column(m_floats, fmt::format("/{}", field.name), field.components == 2 ? 3 : 1, field.unit, first,
                   [&field](const observe::Frame& f) { return in_space(field.in(f), field.components); });
      else
        m_protrusions.emplace_back(); // a table's column
    for (const auto& field : observe::count_fields())
      if (!field.of_protrusions())
        add_column(m_floats, fmt::format("/{}", field.name), 1, field.unit, first,
                   [&field](const observe::Frame& f) { return observe::as_floats(field.in(f)); });
      else
        m_numbers.emplace_back();
    for (const auto& field : observe::byte_fields())
      if (!field.of_protrusions())
        add_column(m_bytes, fmt::format("/{}", field.name), 1, field.unit, first,
                   [&field](const observe::Frame& f) { return field.in(f); });
  }

  void add(const observe::Frame& frame) {
    write(m_floats, frame);
    write(m_bytes, frame);
    const std::size_t alive = frame.protrusions.id.size();
    m_frame_of_row.resize(m_frame_of_row.size() + alive, static_cast<std::uint32_t>(m_next));
    auto column = m_protrusions.begin();
    for (const auto& field : observe::float_fields())
      if (field.of_protrusions()) append(*column++, field.in(frame));
    auto numbers = m_numbers.begin();
    for (const auto& field : observe::count_fields())
      if (field.of_protrusions()) append(*numbers++, field.in(frame));
    append(m_phases, frame.protrusions.phase);
    add_anchors(anchors(frame));
    ++m_next;
  }

  /// Writes the tables of protrusions and anchors of all frames.
  void finish() {
    m_file.write("/protrusions/frame", m_frame_of_row, "1");
    auto numbers = m_numbers.begin();
    for (const auto& field : observe::count_fields()) {
      if (!field.of_protrusions()) continue;
      if (m_several || !field.of_several_cells()) m_file.write(fmt::format("/{}", field.name), *numbers, field.unit);
      ++numbers;
    }
    auto column = m_protrusions.begin();
    for (const auto& field : observe::float_fields())
      if (field.of_protrusions())
        m_file.write_rows(fmt::format("/{}", field.name), in_space(*column++, field.components),
                          field.components == 2 ? 3 : 1, field.unit);
    m_file.write("/protrusions/phase", m_phases, "1");
    write_anchors();
  }

private:
  template <class Number>
  static void append(std::vector<Number>& to, const std::vector<Number>& more) {
    to.insert(to.end(), more.begin(), more.end());
  }

  template <class Number, class Of>
  void add_column(std::vector<Column<Number>>& columns, const std::string& name, std::uint32_t components,
                  std::string_view unit, const observe::Frame& first, const Of& of) {
    const std::vector<Number> like = of(first);
    if (like.empty()) return; // fibres, where there are none
    columns.push_back(
        {name, unit, of, FrameArray(m_file, name, like, m_frames, like.size() / components, components, unit)});
  }

  template <class Number>
  void write(std::vector<Column<Number>>& columns, const observe::Frame& frame) {
    std::vector<std::string> compressed(columns.size());
    parallel_parts(columns.size(), [&](std::size_t k) {
      compressed[k] = columns[k].array.compressed(columns[k].of(frame)); // what takes the time
    });
    for (std::size_t k = 0; k < columns.size(); ++k) {
      Column<Number>& column = columns[k];
      column.array.write(m_next, compressed[k]);
      m_file.name_frame(frame_path(m_next, column.name), column.name, m_next, column.unit);
    }
  }

  void add_anchors(const Anchors& more) {
    m_anchors_of_frame.push_back(more.size());
    m_frame_of_anchor.resize(m_frame_of_anchor.size() + more.size(), static_cast<std::uint32_t>(m_next));
    append(m_anchors.x, more.x);
    append(m_anchors.id, more.id);
    append(m_anchors.f_mat, more.f_mat);
    append(m_anchors.force, more.force);
  }

  void write_anchors() {
    m_file.write("/anchors/frame", m_frame_of_anchor, "1");
    m_file.write("/anchors/id", m_anchors.id, "1");
    m_file.write_rows("/anchors/position", in_space(m_anchors.x, 2), 3, "um");
    m_file.write_rows("/anchors/f_mat", m_anchors.f_mat, 1, "1");
    m_file.write_rows("/anchors/force", m_anchors.force, 1, "nN");
    constexpr std::array<std::pair<const char*, const char*>, 4> views{
        {{"/anchors/id", "1"}, {"/anchors/position", "um"}, {"/anchors/f_mat", "1"}, {"/anchors/force", "nN"}}};
    std::size_t first = 0;
    for (std::size_t k = 0; k < m_anchors_of_frame.size(); first += m_anchors_of_frame[k++])
      if (m_anchors_of_frame[k] > 0)
        for (const auto& [name, unit] : views)
          m_file.name_rows(frame_path(k, name), name, first, m_anchors_of_frame[k], unit);
  }

  MemoryFile& m_file;
  std::size_t m_frames;
  bool m_several; ///< cells
  std::size_t m_next = 0;
  std::vector<Column<float>> m_floats;
  std::vector<Column<std::uint8_t>> m_bytes;
  std::vector<std::uint32_t> m_frame_of_row;
  std::vector<observe::Floats> m_protrusions;
  std::vector<observe::Counts> m_numbers; ///< of protrusions and of their cells
  observe::Bytes m_phases;
  Anchors m_anchors; ///< of all frames
  std::vector<std::size_t> m_anchors_of_frame;
  std::vector<std::uint32_t> m_frame_of_anchor;
};

void write_head(MemoryFile& file, const observe::FrameHead& head, std::span<const double> times,
                const FieldOrigin& origin) {
  file.write_attribute("program", origin.program);
  file.write_attribute("version", origin.version);
  file.write_attribute("seed", origin.seed);
  file.write_attribute("trajectory_hash", origin.trajectory_hash);
  file.write_attribute("scenario", origin.scenario);
  file.write("/time", times, "s");
  file.write("/matrix/radius", std::array{head.radius}, "um");
  file.write("/matrix/spacing", std::array{head.spacing}, "um");
  file.write_rows("/matrix/reference", in_space(head.reference, 2), 3, "um");
  if (!head.obstacle.empty()) file.write("/matrix/obstacle", head.obstacle, "1");
  for (std::size_t k = 0; k < head.layers.size(); ++k)
    if (const MatrixField& layer = observe::matrix_layers()[k]; !head.layers[k].empty())
      file.write_rows(fmt::format("/matrix/{}", layer.layer), head.layers[k], 1, layer.layer_unit);
}

} // namespace

std::string frame_path(std::size_t k, std::string_view name) { return fmt::format("/frames/{}{}", k, name); }

std::string field_file(const observe::Film& film, const FieldOrigin& origin) {
  MemoryFile file;
  std::vector<double> times;
  for (const observe::Frame& frame : film.frames) times.push_back(frame.t);
  if (!film.frames.empty()) {
    FieldWriter writer(file, film.head, film.frames.front(), film.frames.size());
    for (const observe::Frame& frame : film.frames) writer.add(frame);
    writer.finish();
  }
  write_head(file, film.head, times, origin);
  return std::string(file.view());
}

void write_field_files(const std::filesystem::path& folder, std::size_t frames, const FieldOrigin& origin) {
  const std::filesystem::path log = folder / frame_log_name;
  MemoryFile file;
  std::vector<double> times;
  std::vector<std::size_t> adhesions;
  std::optional<observe::Frame> first;
  naming(log, [&] {
    std::ifstream stream(log, std::ios::binary);
    FrameReader reader(stream);
    std::optional<FieldWriter> writer;
    std::optional<observe::Frame> frame;
    while (times.size() < frames && (frame = reader.next())) {
      if (!writer) writer.emplace(file, reader.head(), *frame, frames);
      writer->add(*frame);
      times.push_back(frame->t);
      adhesions.push_back(anchors(*frame).size());
      if (!first) first = *frame;
    }
    if (times.size() != frames || reader.next())
      throw InputOutputError(fmt::format("does not hold the {} whole frames of the run", frames));
    if (writer) writer->finish();
    write_head(file, reader.head(), times, origin);
  });
  write_file(folder / field_file_name, file.view());
  write_file(folder / field_index_name, field_index(first ? &*first : nullptr, times, adhesions));
}

void write_field_files(const std::filesystem::path& folder, const observe::Film& film, const FieldOrigin& origin) {
  std::vector<double> times;
  std::vector<std::size_t> adhesions;
  for (const observe::Frame& frame : film.frames) {
    times.push_back(frame.t);
    adhesions.push_back(anchors(frame).size());
  }
  write_file(folder / field_file_name, field_file(film, origin));
  write_file(folder / field_index_name,
             field_index(film.frames.empty() ? nullptr : &film.frames.front(), times, adhesions));
}

} // namespace matrigrate::store
