#pragma once

#include "observe/readouts.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>

/// The one table of read-outs: what files, studies and pages call them, and what they mean.
/// Test: tests/unit/observe/readouts_test.cpp
namespace matrigrate {

/// A number, NaN where it is not defined, or a count.
using ReadOutValue = std::variant<double, std::uint64_t>;

struct ReadOutSpec {
  std::string_view name;    ///< in files and studies, with its unit at the end: "v_migr_abs_um_per_h"
  std::string_view label;   ///< without the unit: "v_migr_abs"
  std::string_view unit;    ///< "um/h"; "-" for a ratio, "" for a count
  std::string_view meaning; ///< for people
  ReadOutValue (*value)(const ReadOuts&);
  bool usual = false;     ///< one of the paper's, which a study compares if it names none
  bool of_fibres = false; ///< defined among uniaxial fibres only
  bool of_claims = false; ///< needed by claims alone: not among what people are shown of a run
  bool of_groups = false; ///< of several cells only
  bool is_late = false;   ///< tables of results of earlier versions lack it
  bool is_always = false; ///< defined of every run that is done, as counts are
  double least = 0.0;     ///< bounds of its values
  double most = 1e12;

  bool is_count() const { return std::holds_alternative<std::uint64_t>(value({})); }

  /// "speed, start to end (um/h)"; of a ratio or a count without
  std::string meaning_with_unit() const;
};

/// All read-outs of a run, in the order of its files; those of groups last.
std::span<const ReadOutSpec> readout_table();

/// @return nullptr if there is no read-out of that name
const ReadOutSpec* find_readout(std::string_view name);

} // namespace matrigrate
