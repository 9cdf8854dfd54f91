#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// The few pieces of SVG that the figures are made of. Lengths are pixels, x to the right, y down. No element carries
/// an id, so that many pictures can stand in one page. Test: tests/unit/draw/draw_test.cpp
namespace matrigrate::draw::svg {

inline constexpr std::string_view dark = "#1f2328"; ///< text, frames

inline constexpr double margin = 12.0; ///< free on all sides of a picture

inline constexpr double title_size = 18.0;
inline constexpr double label_size = 17.0;
inline constexpr double tick_size = 16.0;
inline constexpr double line_height = 1.3; ///< distance of two lines of text over their size

/// Text for the inside of an element or attribute of XML or HTML; control characters that XML forbids become spaces.
std::string escape(std::string_view text);

/// A coordinate rounded to a tenth of a pixel, without trailing zeros, the same in every locale: "12.5", "3", "-0.4".
std::string coordinate(double value);

/// Points of a path: "12.5 3".
std::string point(double x, double y);

enum class Anchor { start, middle, end };

struct TextStyle {
  double size = tick_size;
  Anchor anchor = Anchor::start;
  bool bold = false;
  bool upward = false; ///< turned by -90 degrees about its anchor, read from bottom to top
};

/// A line of text with its base line at (x, y); the text is escaped.
std::string text(double x, double y, std::string_view content, const TextStyle& style);

/// Lines of text below each other, the first one with its base line at (x, y); upward text goes on to the right.
std::string text_lines(double x, double y, const std::vector<std::string>& lines, const TextStyle& style);

/// A straight line.
std::string line(double x1, double y1, double x2, double y2, std::string_view colour, double width);

/// A filled rectangle.
std::string rectangle(double x, double y, double width, double height, std::string_view fill);

/// An empty frame.
std::string frame(double x, double y, double width, double height);

/// Width of a line of text in a common sans-serif font, estimated on the wide side.
double text_width(std::string_view content, double size);

/// The text cut at spaces into lines not wider than `width`; a longer word stays whole. Empty text gives no line.
std::vector<std::string> wrapped(std::string_view content, double width, double size);

/// Height of `lines` lines of text.
double text_height(std::size_t lines, double size);

/// The whole document on white.
/// @param title  read out by screen readers
std::string document(double width, double height, std::string_view title, std::string_view body);

} // namespace matrigrate::draw::svg
