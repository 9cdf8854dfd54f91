#pragma once

#include "base/file.hpp"
#include "observe/frame.hpp"

#include <filesystem>
#include <functional>
#include <istream>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

/// The frames of a run on disk while it goes on: a head, then frame after frame, each compressed, with its length and
/// fingerprint before it. A run that is killed at any moment loses at most the frame that was being written, and damage
/// loses only the frames in which it lies.
/// Test: tests/unit/store/frames_test.cpp
namespace matrigrate::store {

inline constexpr const char* frame_log_name = "fields.part";

/// The beginning of a log, before its first frame.
std::string log_head(const observe::FrameHead& head);

/// A frame as it stands in a log.
std::string log_frame(const observe::Frame& frame);

/// Whether the arrays of a frame have the lengths that its own bodies and those of the head give them.
/// @param fibres  particles with a stress of fibres: all or none
bool fits(const observe::Frame& frame, const observe::FrameHead& head, std::size_t fibres);

/// The whole frames of a log.
/// @param each  may take away fields that are not wanted
/// @throws InputOutputError if not even the head is whole
observe::Film read_log(std::istream& log, const std::function<void(observe::Frame&)>& each = {});

/// The frames of a log, one after the other, so that only one need be in memory; from the first damage on, the rest of
/// the log is in memory too.
class FrameReader {
public:
  /// @param log  can be searched, and outlives the reader
  /// @throws InputOutputError if not even the head is whole
  explicit FrameReader(std::istream& log);
  /// For a log whose head is not whole.   @param head  what it should be
  FrameReader(std::istream& log, observe::FrameHead head) : m_log(&log), m_head(std::move(head)) {}

  const observe::FrameHead& head() const { return m_head; }

  /// The next whole frame; what is damaged, or of other sizes than the head, is passed over. None at the end.
  std::optional<observe::Frame> next();

private:
  bool find_next(std::streampos start);

  std::istream* m_log;
  std::istringstream m_rest; ///< what follows the first damage
  std::size_t m_budget = 0;
  observe::FrameHead m_head;
  std::optional<std::size_t> m_fibres; ///< as in the first frame
};

/// A log that grows.
class FrameLog {
public:
  /// Writes the file with the frames so far; an older file is replaced as a whole or not at all.
  /// @param whole  head and frames
  /// @throws InputOutputError naming the path and the reason
  FrameLog(std::filesystem::path path, std::string_view whole) : m_file(std::move(path), whole) {}

  /// Appends a frame; one that does not fit on the disk is taken back.
  /// @throws InputOutputError naming the path and the reason
  void add(const observe::Frame& frame);

  /// Waits until the whole log is on the disk, as a checkpoint that counts its frames requires.
  /// @throws InputOutputError naming the path and the reason
  void flush() const { m_file.flush(); }

private:
  GrowingFile m_file;
};

} // namespace matrigrate::store
