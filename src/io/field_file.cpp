#include "io/field_file.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "io/frame_log.hpp"
#include "io/hdf5.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace matrigrate::io {

namespace {

constexpr std::size_t most_bytes = std::size_t{64} << 30U;
constexpr std::string_view outline = "outline/", protrusions = "protrusions/";

/// Vectors of two components with a third one, 0; all else as it is.
Floats in_space(const Floats& values, std::uint32_t components) {
  if (components != 2) return values;
  Floats all;
  all.reserve(values.size() / 2 * 3);
  for (std::size_t i = 0; i + 1 < values.size(); i += 2) all.insert(all.end(), {values[i], values[i + 1], 0.0F});
  return all;
}

Floats in_plane(const Floats& values) {
  Floats all;
  all.reserve(values.size() / 3 * 2);
  for (std::size_t i = 0; i + 2 < values.size(); i += 3) all.insert(all.end(), {values[i], values[i + 1]});
  return all;
}

Floats positions(const FrameHead& head, const Frame& frame) {
  Floats x = frame.matrix.displacement;
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += head.reference[i];
  return in_space(x, 2);
}

Bytes solid(const Frame& frame) {
  Bytes flags;
  for (const float f : frame.matrix.f_degr) flags.push_back(f > 0.0F ? 1 : 0);
  return flags;
}

/// Writes what `of` gives for each frame, one chunk a frame.
template <class Of>
void write_frames(MemoryFile& file, const std::string& name, const Film& film, std::uint32_t components,
                  std::string_view unit, const Of& of) {
  const std::size_t n = of(film.frames.front()).size() / components;
  if (n == 0) return; // fibres, where there are none
  FrameArray array(file, name, of(film.frames.front()), film.frames.size(), n, components, unit);
  for (std::size_t k = 0; k < film.frames.size(); ++k) {
    array.write(k, of(film.frames[k]));
    file.name_frame(frame_path(k, name), name, k);
  }
}

/// Protrusions of all frames, one row each.
void write_protrusions(MemoryFile& file, const Film& film) {
  Floats frame_of_row;
  for (std::size_t k = 0; k < film.frames.size(); ++k)
    frame_of_row.resize(frame_of_row.size() + film.frames[k].protrusions.id.size(), static_cast<float>(k));
  file.write_rows("/protrusions/frame", frame_of_row, 1, "1");
  for (const auto& field : float_fields()) {
    if (!field.name.starts_with(protrusions)) continue;
    Floats all;
    for (const Frame& frame : film.frames) all.insert(all.end(), field.in(frame).begin(), field.in(frame).end());
    file.write_rows(fmt::format("/{}", field.name), in_space(all, field.components), field.components == 2 ? 3 : 1,
                    field.unit);
  }
  Bytes phases;
  for (const Frame& frame : film.frames)
    phases.insert(phases.end(), frame.protrusions.phase.begin(), frame.protrusions.phase.end());
  file.write("/protrusions/phase", phases);
}

void read_protrusions(const MemoryFile& file, Film& film) {
  const Floats frame_of_row = file.floats("/protrusions/frame");
  const std::vector<std::uint8_t> phases = file.bytes("/protrusions/phase");
  std::vector<Floats> columns;
  for (const auto& field : float_fields())
    if (field.name.starts_with(protrusions)) {
      const Floats stored = file.floats(fmt::format("/{}", field.name));
      columns.push_back(field.components == 2 ? in_plane(stored) : stored);
      if (columns.back().size() != frame_of_row.size() * field.components)
        throw InputOutputError("its tables of protrusions do not belong together");
    }
  if (phases.size() != frame_of_row.size()) throw InputOutputError("its tables of protrusions do not belong together");
  for (std::size_t row = 0; row < frame_of_row.size(); ++row) {
    const auto k = static_cast<std::size_t>(frame_of_row[row]);
    if (k >= film.frames.size()) throw InputOutputError("a protrusion is of no frame");
    std::size_t column = 0;
    for (const auto& field : float_fields()) {
      if (!field.name.starts_with(protrusions)) continue;
      const auto first = columns[column++].begin() + static_cast<std::ptrdiff_t>(row * field.components);
      Floats& to = field.of(film.frames[k]);
      to.insert(to.end(), first, first + field.components);
    }
    film.frames[k].protrusions.phase.push_back(phases[row]);
  }
}

void fill(MemoryFile& file, const Film& film) {
  const FrameHead& head = film.head;
  std::vector<double> times;
  for (const Frame& frame : film.frames) times.push_back(frame.t);
  file.write("/time", times, "s");
  file.write("/matrix/radius", std::array{head.radius}, "um");
  file.write("/matrix/spacing", std::array{head.spacing}, "um");
  file.write_rows("/matrix/reference", in_space(head.reference, 2), 3, "um");
  if (film.frames.empty()) return;
  write_frames(file, "/matrix/position", film, 3, "um", [&](const Frame& f) { return positions(head, f); });
  write_frames(file, "/matrix/solid", film, 1, "1", solid);
  for (const auto& field : float_fields())
    if (!field.name.starts_with(protrusions))
      write_frames(file, fmt::format("/{}", field.name), film, field.components == 2 ? 3 : 1, field.unit,
                   [&](const Frame& f) { return in_space(field.in(f), field.components); });
  for (const auto& field : byte_fields())
    if (!field.name.starts_with(protrusions))
      write_frames(file, fmt::format("/{}", field.name), film, 1, field.unit,
                   [&](const Frame& f) { return field.in(f); });
  write_protrusions(file, film);
}

} // namespace

std::string frame_path(std::size_t k, std::string_view name) { return fmt::format("/frames/{}{}", k, name); }

std::string field_file(const Film& film) {
  MemoryFile file;
  fill(file, film);
  return std::string(file.view());
}

void write_field_file(const std::filesystem::path& path, const Film& film) {
  MemoryFile file;
  fill(file, film);
  write_file(path, file.view());
}

Film read_field_file(std::string_view bytes) {
  const MemoryFile file(bytes);
  Film film;
  const std::vector<double> times = file.doubles("/time");
  const std::vector<double> radius = file.doubles("/matrix/radius");
  const std::vector<double> spacing = file.doubles("/matrix/spacing");
  if (radius.size() != 1 || spacing.size() != 1) throw InputOutputError("is no field file of matrigrate");
  film.head = {.radius = radius[0], .spacing = spacing[0], .reference = in_plane(file.floats("/matrix/reference"))};
  for (const double t : times) film.frames.push_back({.t = t, .matrix = {}, .outline = {}, .protrusions = {}});
  if (times.empty()) return film;
  const auto frames_of = [&](const std::string& name, const auto& read, const auto& keep) {
    if (!file.has(name)) return; // fibres, where there are none
    for (std::size_t k = 0; k < film.frames.size(); ++k) keep(film.frames[k], read(name, k));
  };
  for (const auto& field : float_fields())
    if (!field.name.starts_with(protrusions))
      frames_of(
          fmt::format("/{}", field.name), [&](const auto& name, std::size_t k) { return file.float_frame(name, k); },
          [&](Frame& f, Floats v) { field.of(f) = field.components == 2 ? in_plane(v) : std::move(v); });
  for (const auto& field : byte_fields())
    if (!field.name.starts_with(protrusions))
      frames_of(
          fmt::format("/{}", field.name), [&](const auto& name, std::size_t k) { return file.byte_frame(name, k); },
          [&](Frame& f, Bytes v) { field.of(f) = std::move(v); });
  read_protrusions(file, film);
  return film;
}

namespace {

/// What `read` makes of a file; an empty film if it is not there.
Film film_of(const std::filesystem::path& file, Film (*read)(std::string_view)) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return {};
  try {
    return read(read_file(file, most_bytes));
  } catch (const InputOutputError& trouble) {
    throw InputOutputError(fmt::format("{}: {}", file.string(), trouble.what()));
  }
}

} // namespace

Film read_field_film(const std::filesystem::path& folder) { return film_of(folder / field_file_name, read_field_file); }

Film read_film(const std::filesystem::path& folder) {
  Film film = film_of(folder / frame_log_name, read_log);
  return film.head.particles() > 0 ? film : read_field_film(folder);
}

} // namespace matrigrate::io
