#include "apps/terminal/terminal.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <system_error>

namespace matrigrate::apps {

namespace {

bool shows_colours(Stream stream) {
  const char* no_colour = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  if (no_colour != nullptr && *no_colour != '\0') return false;
  if (terminal == nullptr || std::string_view(terminal) == "dumb") return false;
  return ::isatty(stream == Stream::out ? STDOUT_FILENO : STDERR_FILENO) == 1;
}

[[noreturn]] void fail() {
  throw InputOutputError(fmt::format("standard output: cannot be written: {}", std::generic_category().message(errno)));
}

} // namespace

std::string coloured(std::string_view text, Colour colour, Stream stream) {
  if (!shows_colours(stream)) return std::string(text);
  constexpr std::array codes{31, 32, 33, 1}; // in the order of Colour
  return fmt::format("\x1b[{}m{}\x1b[0m", codes.at(static_cast<std::size_t>(colour)), text);
}

void print(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) fail();
}

void print_json(const nlohmann::ordered_json& json) {
  print(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

void flush() {
  if (std::fflush(stdout) != 0) fail();
}

void print_error(std::string_view text) {
  std::fflush(stdout);
  std::fwrite(text.data(), 1, text.size(), stderr);
}

void print_warning(std::string_view text) {
  print_error(fmt::format("{} {}\n", coloured("matrigrate:", Colour::warning, Stream::err), text));
}

void print_failure(std::string_view text) {
  print_error(fmt::format("{} {}\n", coloured("matrigrate:", Colour::bad, Stream::err), text));
}

void print_faults(const std::vector<Fault>& faults) {
  for (const Fault& fault : faults) print_error(to_string(fault) + "\n");
}

std::string number_text(double value) { return std::isnan(value) ? "-" : fmt::format("{:.3g}", value); }

std::string interval_text(const statistics::Interval& i) {
  return std::isfinite(i.low) && std::isfinite(i.high) ? fmt::format("{:.3g} to {:.3g}", i.low, i.high) : "-";
}

std::string aligned(const std::vector<std::vector<std::string>>& rows, std::size_t words) {
  std::vector<std::size_t> width(rows.front().size(), 0);
  for (const auto& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) width[c] = std::max(width[c], row[c].size());
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t c = 0; c < row.size(); ++c)
      line += c < words ? fmt::format("  {:<{}}", row[c], width[c]) : fmt::format("  {:>{}}", row[c], width[c]);
    text += line.erase(line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

} // namespace matrigrate::apps
