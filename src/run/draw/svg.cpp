#include "draw/svg.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace matrigrate::draw::svg {

std::string escape(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (const char c : text) {
    switch (c) {
    case '&':
      out += "&amp;";
      break;
    case '<':
      out += "&lt;";
      break;
    case '>':
      out += "&gt;";
      break;
    case '"':
      out += "&quot;";
      break;
    case '\'':
      out += "&#39;";
      break;
    case '\t':
    case '\n':
    case '\r':
      out += c;
      break;
    default:
      out += (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) ? ' ' : c;
    }
  }
  return out;
}

std::string coordinate(double value) {
  std::string out = fmt::format("{:.1f}", value);
  if (out.ends_with(".0")) out.resize(out.size() - 2);
  return out == "-0" ? "0" : out;
}

std::string point(double x, double y) { return coordinate(x) + ' ' + coordinate(y); }

std::string text(double x, double y, std::string_view content, const TextStyle& style) {
  std::string out = fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\"", coordinate(x), coordinate(y), style.size);
  if (style.anchor == Anchor::middle) out += " text-anchor=\"middle\"";
  if (style.anchor == Anchor::end) out += " text-anchor=\"end\"";
  if (style.bold) out += " font-weight=\"600\"";
  if (style.upward) out += fmt::format(" transform=\"rotate(-90 {})\"", point(x, y));
  return out + '>' + escape(content) + "</text>\n";
}

std::string text_lines(double x, double y, const std::vector<std::string>& lines, const TextStyle& style) {
  std::string out;
  for (const auto& content : lines) {
    out += text(x, y, content, style);
    (style.upward ? x : y) += line_height * style.size;
  }
  return out;
}

std::string line(double x1, double y1, double x2, double y2, std::string_view colour, double width) {
  return fmt::format("<path d=\"M{}L{}\" stroke=\"{}\" stroke-width=\"{}\"/>\n", point(x1, y1), point(x2, y2), colour,
                     width);
}

std::string rectangle(double x, double y, double width, double height, std::string_view fill) {
  return fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n", coordinate(x), coordinate(y),
                     coordinate(width), coordinate(height), fill);
}

std::string frame(double x, double y, double width, double height) {
  return fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"{}\"/>\n",
                     coordinate(x), coordinate(y), coordinate(width), coordinate(height), dark);
}

double text_width(std::string_view content, double size) {
  // Bytes 10xxxxxx go on with a character of UTF-8 and take no room of their own.
  const auto characters = std::count_if(content.begin(), content.end(),
                                        [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
  return 0.55 * size * static_cast<double>(characters);
}

std::vector<std::string> wrapped(std::string_view content, double width, double size) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < content.size();) {
    const std::size_t end = std::min(content.find(' ', begin), content.size());
    const std::string_view word = content.substr(begin, end - begin);
    begin = end + 1;
    if (word.empty()) continue;
    if (!lines.empty() && text_width(lines.back(), size) + text_width(word, size) + 0.55 * size <= width)
      lines.back().append(" ").append(word);
    else
      lines.emplace_back(word);
  }
  return lines;
}

double text_height(std::size_t lines, double size) { return line_height * size * static_cast<double>(lines); }

std::string document(double width, double height, std::string_view title, std::string_view body) {
  const std::string w = coordinate(width);
  const std::string h = coordinate(height);
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\" viewBox=\"0 0 {} {}\" role=\"img\" "
      "aria-label=\"{}\" font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\" fill=\"{}\">\n",
      w, h, w, h, escape(title), dark);
  out += rectangle(0, 0, width, height, "#ffffff");
  out += body;
  return out + "</svg>\n";
}

} // namespace matrigrate::draw::svg
