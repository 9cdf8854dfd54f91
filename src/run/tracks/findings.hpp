#pragma once

#include "base/failure.hpp"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

/// What is found while a file of tracks is read. Test: tests/unit/tracks/read_tracks_test.cpp
namespace matrigrate::tracks {

/// Faults and notes of one file. The first twenty faults are kept, the others counted.
class Findings {
public:
  explicit Findings(std::string file) : m_file(std::move(file)) {}

  /// @param line  0 for the file as a whole
  void fault(std::size_t line, std::string message);
  void note(std::string message) { m_notes.push_back(std::move(message)); }

  bool good() const { return m_count == 0; }
  std::vector<std::string>& notes() { return m_notes; }

  /// @throws ConfigurationError if there is any fault
  void raise();

private:
  std::string m_file;
  std::vector<Fault> m_faults;
  std::size_t m_count = 0;
  std::vector<std::string> m_notes;
};

/// "1 track", "2 tracks".
std::string counted(std::size_t n, const std::string& one);

} // namespace matrigrate::tracks
