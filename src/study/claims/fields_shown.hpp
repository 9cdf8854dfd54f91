#pragma once

#include "claims/judge.hpp"
#include "observe/frame.hpp"

#include <string>
#include <string_view>

/// Whether runs show their fields of displacement and von Mises stress over all their time (S1 to S4 Videos of Heck et
/// al. 2020). Test: tests/unit/claims/fields_shown_test.cpp
namespace matrigrate::study {

/// The header of a table of frames: t_s, particles, defined, largest_displacement_um, largest_von_mises_Pa, point.
std::string fields_header();

/// A row per frame: how many particles of solid it has, at how many of them both fields are finite, and the largest
/// values there.
std::string fields_rows(std::string_view label, const observe::Film& film);

/// Holds if two points are there, each with a frame every 300 s from 0 to t_end, both fields finite at every particle
/// of solid in all of them, and neither zero throughout.
/// @param t_end  [s]
/// @throws InputOutputError if the text is no such table
Finding fields_shown(std::string_view csv, double t_end);

} // namespace matrigrate::study
