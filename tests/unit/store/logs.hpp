#pragma once

#include "store/frame_log.hpp"

#include <sstream>
#include <string>

/// Logs of frames in memory.
namespace matrigrate::store {

inline std::string log_bytes(const observe::Film& film) {
  std::string bytes = log_head(film.head);
  for (const observe::Frame& frame : film.frames) bytes += log_frame(frame);
  return bytes;
}

inline observe::Film read_log(std::string_view bytes) {
  std::istringstream log{std::string(bytes)};
  return read_log(log);
}

} // namespace matrigrate::store
