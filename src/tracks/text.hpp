#pragma once

#include "tracks/findings.hpp"

#include <string>
#include <string_view>

/// The text of a file, whatever wrote it. Test: tests/unit/tracks/text_test.cpp
namespace matrigrate::tracks {

struct Text {
  std::string utf8;     ///< lines end with \n, minus signs are "-", blanks " "
  std::string encoding; ///< "UTF-8", "UTF-16" or "Windows-1252"
};

/// Takes UTF-8, UTF-16 with its mark, and what is neither as Windows-1252 (which has Latin-1 in it), with a note. A
/// workbook, a compressed file and what is no text are faults.
Text decoded(std::string_view bytes, Findings& findings);

} // namespace matrigrate::tracks
