#include "io/saved_frames.hpp"

#include "base/failure.hpp"
#include "io/cell_picture.hpp"
#include "io/field_file.hpp"
#include "io/frame_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <vector>

namespace matrigrate::io {

namespace {

bool same(const FrameHead& a, const FrameHead& b) {
  return a.radius == b.radius && a.spacing == b.spacing && a.reference == b.reference;
}

} // namespace

SavedFrames saved_frames(const std::filesystem::path& folder, const FrameShape& shape, std::span<const double> times) {
  SavedFrames saved;
  const auto keep = [&](const Frame& frame) {
    const bool fits = frame.outline.f_mat.size() == shape.outline
                      && frame.matrix.fibre_von_mises.empty() != shape.fibres
                      && std::ranges::binary_search(times, frame.t);
    if (fits && !saved.contains(frame.t)) saved.emplace(frame.t, log_frame(frame));
  };
  std::ifstream log(folder / frame_log_name, std::ios::binary);
  std::optional<FrameReader> reader;
  try {
    reader.emplace(log);
  } catch (const InputOutputError&) { // its head is damaged; its frames may be whole
    log.clear();
    log.seekg(0);
    reader.emplace(log, shape.head);
  }
  if (same(reader->head(), shape.head))
    while (const std::optional<Frame> frame = reader->next()) keep(*frame);
  if (saved.size() == times.size()) return saved;
  try {
    const Film film = read_field_film(folder);
    if (same(film.head, shape.head)) std::ranges::for_each(film.frames, keep);
  } catch (const InputOutputError&) { // then they are lost
  }
  return saved;
}

LostFrames lost_frames(std::span<const double> written, std::span<const double> there) {
  std::vector<double> lost;
  std::ranges::set_difference(written, there, std::back_inserter(lost));
  if (lost.empty()) return {.count = 0, .written = written.size(), .first = 0.0, .last = 0.0};
  return {.count = lost.size(), .written = written.size(), .first = lost.front(), .last = lost.back()};
}

std::string to_text(const LostFrames& lost) {
  if (lost.count == 0) return {};
  const std::string first = time_text(lost.first);
  const std::string when = lost.count == 1 ? "at " + first : fmt::format("from {} to {}", first, time_text(lost.last));
  return fmt::format("{} of {} frames ({}) {} lost: neither {} nor {} holds {} whole", lost.count, lost.written, when,
                     lost.count == 1 ? "is" : "are", frame_log_name, field_file_name, lost.count == 1 ? "it" : "them");
}

std::vector<double> times_of(const Film& film) {
  std::vector<double> times;
  times.reserve(film.frames.size());
  for (const Frame& frame : film.frames) times.push_back(frame.t);
  return times;
}

} // namespace matrigrate::io
