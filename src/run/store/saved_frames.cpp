#include "store/saved_frames.hpp"

#include "base/failure.hpp"
#include "base/text.hpp"
#include "store/field_file.hpp"
#include "store/frame_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <utility>

namespace matrigrate::store {

namespace {

/// Calls with each whole frame of the log, and then, while some are `missing`, with each one of the field file.
template <class Keep, class Missing>
void for_each_whole(const std::filesystem::path& folder, const FrameShape& shape, const Keep& keep,
                    const Missing& missing, std::string* trouble = nullptr) {
  const auto see = [&](observe::Frame frame) {
    if (frame.outline.f_mat.size() != shape.outline) return;
    follow(frame, shape);
    keep(std::move(frame));
  };
  std::ifstream log;
  std::error_code error; // a named pipe would be waited for
  if (std::filesystem::is_regular_file(folder / frame_log_name, error))
    log.open(folder / frame_log_name, std::ios::binary);
  std::optional<FrameReader> reader;
  try {
    reader.emplace(log);
  } catch (const InputOutputError&) { // its head is damaged; its frames may be whole
    log.clear();
    log.seekg(0);
    reader.emplace(log, shape.head);
  }
  if (reader->head() == shape.head)
    while (std::optional<observe::Frame> frame = reader->next()) see(*std::move(frame));
  if (!missing()) return;
  try {
    observe::Film film = read_field_film(folder, Wanted::whole);
    if (film.head == shape.head)
      for (observe::Frame& frame : film.frames) see(std::move(frame));
  } catch (const InputOutputError& reason) { // then they are lost
    if (trouble != nullptr) *trouble = reason.what();
  }
}

} // namespace

void follow(observe::Frame& frame, const FrameShape& shape) {
  observe::Floats& stress = frame.matrix.fibre_von_mises;
  if (!shape.fibres)
    stress.clear();
  else if (stress.empty())
    stress.assign(shape.head.particles(), 0.0F);
}

SavedFrames saved_frames(const std::filesystem::path& folder, const FrameShape& shape, std::span<const double> times) {
  SavedFrames saved;
  const auto keep = [&](const observe::Frame& frame) {
    if (std::ranges::binary_search(times, frame.t) && !saved.contains(frame.t))
      saved.emplace(frame.t, log_frame(frame));
  };
  for_each_whole(folder, shape, keep, [&] { return saved.size() < times.size(); });
  return saved;
}

observe::Film saved_film(const std::filesystem::path& folder, const FrameShape& shape, std::span<const double> times,
                         std::string* trouble) {
  std::map<double, observe::Frame> saved;
  for_each_whole(
      folder, shape,
      [&](observe::Frame&& frame) {
        const double t = frame.t;
        saved.try_emplace(t, std::move(frame));
      },
      [&] { return !std::ranges::all_of(times, [&](double t) { return saved.contains(t); }); }, trouble);
  observe::Film film{.head = shape.head, .frames = {}};
  for (auto& [t, frame] : saved) film.frames.push_back(std::move(frame));
  return film;
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

} // namespace matrigrate::store
