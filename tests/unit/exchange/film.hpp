#pragma once

#include "observe/frame.hpp"

namespace matrigrate::exchange {

/// Two frames of four particles of matrix at the corners of a square, and a square cell in the middle of it.
inline observe::Film small_film() {
  observe::Film film;
  film.head.radius = 4.0;
  film.head.spacing = 4.0;
  film.head.reference = {-2, -2, 2, -2, -2, 2, 2, 2};
  film.head.layers[0] = {100, 200, 300, 400};
  observe::Frame frame;
  frame.matrix.displacement = {0, 0, 0.25F, 0, 0, 0, 0, 0};
  frame.matrix.velocity = observe::Floats(8, 0.0F);
  frame.matrix.f_degr = {1, 0, 1, 1};
  frame.matrix.pressure = {10, 20, 30, 40};
  frame.matrix.von_mises = {1, 2, 3, 4};
  frame.outline.x = {-1, -1, 1, -1, 1, 1, -1, 1};
  frame.outline.front = {1, 1, 0, 0};
  frame.protrusions.id = {7};
  frame.protrusions.anchor = {1.5F, 0};
  film.frames = {frame, frame};
  film.frames[1].t = 300.0;
  film.frames[1].matrix.pressure = {11, 21, 31, 41};
  film.frames[1].protrusions = {};
  return film;
}

} // namespace matrigrate::exchange
