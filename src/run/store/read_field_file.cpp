#include "base/failure.hpp"
#include "base/file.hpp"
#include "store/field_file.hpp"
#include "store/frame_log.hpp"
#include "store/hdf5.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <utility>
#include <vector>

namespace matrigrate::store {

namespace {

constexpr std::size_t max_field_file_bytes = std::size_t{64} << 30U;

observe::Floats in_plane(const observe::Floats& values) {
  observe::Floats all;
  all.reserve(values.size() / 3 * 2);
  for (std::size_t i = 0; i + 2 < values.size(); i += 3) all.insert(all.end(), {values[i], values[i + 1]});
  return all;
}

/// A column of the table of protrusions.
/// @param rows  of the table
observe::Floats column(const MemoryFile& file, std::string_view name, std::uint32_t components, std::size_t rows) {
  const observe::Floats stored = file.floats(fmt::format("/{}", name));
  observe::Floats numbers = components == 2 ? in_plane(stored) : stored;
  if (numbers.size() != rows * components) throw InputOutputError("its tables of protrusions do not match in length");
  return numbers;
}

void read_protrusions(const MemoryFile& file, observe::Film& film) {
  const observe::Floats frame_of_row = file.floats("/protrusions/frame");
  const std::size_t rows = frame_of_row.size();
  std::vector<std::size_t> frames;
  for (const float frame : frame_of_row) {
    if (!(frame >= 0.0F && static_cast<double>(frame) < static_cast<double>(film.frames.size())))
      throw InputOutputError("a protrusion belongs to no frame");
    frames.push_back(static_cast<std::size_t>(frame));
  }
  const auto hand_out = [&](const auto& field, const auto& numbers) {
    for (std::size_t row = 0; row < rows; ++row) {
      const auto first = numbers.begin() + static_cast<std::ptrdiff_t>(row * field.components);
      auto& to = field.of(film.frames[frames[row]]);
      to.insert(to.end(), first, first + field.components);
    }
  };
  for (const auto& field : observe::float_fields())
    if (field.of_protrusions()) hand_out(field, column(file, field.name, field.components, rows));
  for (const auto& field : observe::count_fields())
    if (field.of_protrusions() && (!field.of_several_cells() || file.has("/protrusions/cell")))
      hand_out(field, observe::as_counts(column(file, field.name, 1, rows)));
  const std::vector<std::uint8_t> phases = file.bytes("/protrusions/phase");
  if (phases.size() != rows) throw InputOutputError("its tables of protrusions do not match in length");
  for (std::size_t row = 0; row < rows; ++row) film.frames[frames[row]].protrusions.phase.push_back(phases[row]);
}

/// @param whole  whether of each frame is to be told if it could be read; else the first that cannot is an error
observe::Film film_in(const MemoryFile& file, std::vector<bool>* whole = nullptr) {
  observe::Film film;
  const std::vector<double> times = file.doubles("/time");
  const std::vector<double> radius = file.doubles("/matrix/radius");
  const std::vector<double> spacing = file.doubles("/matrix/spacing");
  if (radius.size() != 1 || spacing.size() != 1) throw InputOutputError("is no field file of matrigrate");
  film.head = {.radius = radius[0], .spacing = spacing[0], .reference = in_plane(file.floats("/matrix/reference"))};
  if (file.has("/matrix/obstacle")) film.head.obstacle = file.bytes("/matrix/obstacle");
  for (std::size_t k = 0; k < film.head.layers.size(); ++k)
    if (const std::string name = fmt::format("/matrix/{}", observe::matrix_layers()[k].layer); file.has(name))
      film.head.layers[k] = file.floats(name);
  if (!film.head.consistent()) throw InputOutputError("its arrays do not match");
  for (const double t : times) film.frames.push_back({.t = t, .matrix = {}, .outline = {}, .protrusions = {}});
  if (whole != nullptr) whole->assign(times.size(), true);
  if (times.empty()) return film;
  const auto frames_of = [&](const std::string& name, std::size_t numbers, const auto& read, const auto& keep) {
    if (!file.has(name)) return; // fibres, where there are none
    file.require_frames(name, times.size(), numbers);
    for (std::size_t k = 0; k < film.frames.size(); ++k) {
      try {
        keep(film.frames[k], read(name, k));
      } catch (const InputOutputError&) {
        if (whole == nullptr) throw;
        (*whole)[k] = false;
      }
    }
  };
  const auto numbers_of = [&](const auto& field) {
    const std::size_t each = field.components == 2 ? 3 : 1; // vectors have a third component
    return field.name.starts_with("matrix/") ? each * film.head.particles() : 0;
  };
  for (const auto& field : observe::float_fields())
    if (!field.of_protrusions())
      frames_of(
          fmt::format("/{}", field.name), numbers_of(field),
          [&](const auto& name, std::size_t k) { return file.float_frame(name, k); },
          [&](observe::Frame& f, observe::Floats v) {
            field.of(f) = field.components == 2 ? in_plane(v) : std::move(v);
          });
  for (const auto& field : observe::count_fields())
    if (!field.of_protrusions())
      frames_of(
          fmt::format("/{}", field.name), 0, [&](const auto& name, std::size_t k) { return file.float_frame(name, k); },
          [&](observe::Frame& f, const observe::Floats& v) { field.of(f) = observe::as_counts(v); });
  for (const auto& field : observe::byte_fields())
    if (!field.of_protrusions())
      frames_of(
          fmt::format("/{}", field.name), numbers_of(field),
          [&](const auto& name, std::size_t k) { return file.byte_frame(name, k); },
          [&](observe::Frame& f, observe::Bytes v) { field.of(f) = std::move(v); });
  read_protrusions(file, film);
  const std::size_t fibres = file.has("/matrix/fibre_von_mises") ? film.head.particles() : 0;
  for (std::size_t k = 0; k < film.frames.size(); ++k) {
    if (fits(film.frames[k], film.head, fibres)) continue;
    if (whole == nullptr) throw InputOutputError("its arrays do not match");
    (*whole)[k] = false;
  }
  return film;
}

observe::Film whole_film_in(const MemoryFile& file) {
  std::vector<bool> whole;
  observe::Film film = film_in(file, &whole);
  observe::Film found{.head = film.head, .frames = {}};
  for (std::size_t k = 0; k < whole.size(); ++k)
    if (whole[k]) found.frames.push_back(std::move(film.frames[k]));
  return found;
}

bool is_there(const std::filesystem::path& file) {
  std::error_code error;
  return std::filesystem::exists(file, error);
}

/// Reads the field file of a folder, if it has one.
template <class Read>
observe::Film read_in(const std::filesystem::path& folder, const Read& read) {
  const std::filesystem::path path = folder / field_file_name;
  if (!is_there(path)) return {};
  std::string bytes = read_file(path, max_field_file_bytes);
  return naming(path, [&] {
    const MemoryFile file(bytes);
    bytes = std::string(); // HDF5 has taken a copy
    return read(file);
  });
}

} // namespace

observe::Film read_field_file(std::string_view bytes) { return film_in(MemoryFile(bytes)); }

observe::Film read_field_film(const std::filesystem::path& folder) {
  return read_in(folder, [](const MemoryFile& file) { return film_in(file); });
}

observe::Film whole_frames_of(std::string_view bytes) { return whole_film_in(MemoryFile(bytes)); }

observe::Film read_whole_frames(const std::filesystem::path& folder) { return read_in(folder, whole_film_in); }

observe::Film read_film(const std::filesystem::path& folder, const std::function<void(observe::Frame&)>& each) {
  const std::filesystem::path path = folder / frame_log_name;
  if (!is_there(path)) {
    observe::Film film = read_field_film(folder);
    if (each) std::ranges::for_each(film.frames, each);
    return film;
  }
  return naming(path, [&] {
    std::ifstream log(path, std::ios::binary);
    return read_log(log, each);
  });
}

} // namespace matrigrate::store
