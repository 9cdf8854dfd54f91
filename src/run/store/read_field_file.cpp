#include "base/failure.hpp"
#include "base/file.hpp"
#include "store/field_file.hpp"
#include "store/frame_log.hpp"
#include "store/hdf5.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <type_traits>
#include <utility>
#include <vector>

namespace matrigrate::store {

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
