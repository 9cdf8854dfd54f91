#pragma once

#include "base/failure.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

/// What is found while a file of tracks is read. Test: tests/unit/tracks/reading_test.cpp
namespace matrigrate::tracks {

/// Faults and notes of one file. Of faults of one kind the first is kept, the others are counted; so is what is beyond
/// twenty kinds.
class Findings {
public:
  explicit Findings(std::string file) : m_file(std::move(file)) {}

  /// Of the kind that the message is without its numbers and what it quotes.
  /// @param line  0 for the file as a whole
  void fault(std::size_t line, const std::string& message);
  template <class One, class... More>
  void fault(std::size_t line, fmt::format_string<One, More...> text, One&& one, More&&... more) {
    fault(line, fmt::format(text, std::forward<One>(one), std::forward<More>(more)...));
  }
  void fault_of_kind(const std::string& kind, std::size_t line, const std::string& message);

  void note(std::string message) { m_notes.push_back(std::move(message)); }
  template <class One, class... More>
  void note(fmt::format_string<One, More...> text, One&& one, More&&... more) {
    note(fmt::format(text, std::forward<One>(one), std::forward<More>(more)...));
  }

  bool good() const { return m_count == 0; }
  std::vector<std::string>& notes() { return m_notes; }

  /// @throws ConfigurationError if there is any fault
  void raise();

private:
  std::string m_file;
  std::vector<Fault> m_faults;
  std::vector<std::size_t> m_more;            ///< of the kind of each of them
  std::map<std::string, std::size_t> m_kinds; ///< indices of faults
  std::size_t m_count = 0;
  std::vector<std::string> m_notes;
};

/// "1 track", "2 tracks".
std::string counted(std::size_t n, const std::string& one);

} // namespace matrigrate::tracks
