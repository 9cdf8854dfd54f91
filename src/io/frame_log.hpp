#pragma once

#include "base/file.hpp"
#include "io/frame.hpp"

#include <filesystem>
#include <functional>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

/// The frames of a run on disk while it goes on: a head, then frame after frame, each compressed, with its length and
/// fingerprint before it. A run that is killed at any moment loses at most the frame that was being written.
/// Test: tests/unit/io/frame_log_test.cpp
namespace matrigrate::io {

inline constexpr const char* frame_log_name = "fields.part";

/// The bytes of a log of these frames.
std::string log_bytes(const Film& film);

/// The log's beginning: its head and at most `frames` whole frames; what is cut short or changed ends it. Empty if not
/// even the head is whole.
std::string whole_log(std::string_view bytes, std::size_t frames);

/// The frames of a log up to the first that is cut short or changed.
/// @throws InputOutputError if not even the head is whole
Film read_log(std::string_view bytes);
/// @param each  may take away fields that are not wanted
Film read_log(std::istream& log, const std::function<void(Frame&)>& each = {});

/// The frames of a log, one after the other, so that only one need be in memory.
class FrameReader {
public:
  /// @param log  stays until the reader is gone
  /// @throws InputOutputError if not even the head is whole
  explicit FrameReader(std::istream& log);

  const FrameHead& head() const { return m_head; }

  /// None behind the last one, and from the first on that is cut short or changed.
  std::optional<Frame> next();

private:
  std::istream& m_log;
  FrameHead m_head;
};

/// A log that grows.
class FrameLog {
public:
  /// Makes the file anew with what there is already; it is replaced as a whole or not at all.
  /// @param whole  from log_bytes() or whole_log()
  /// @throws InputOutputError naming the path and the reason
  FrameLog(std::filesystem::path path, std::string_view whole) : m_file(std::move(path), whole) {}

  /// Appends a frame; one that does not fit on the disk is taken back.
  /// @throws InputOutputError naming the path and the reason
  void add(const Frame& frame);

  /// Waits until all of it is on the disk, which a checkpoint that counts on it needs.
  /// @throws InputOutputError naming the path and the reason
  void flush() const { m_file.flush(); }

private:
  GrowingFile m_file;
};

} // namespace matrigrate::io
