#pragma once

#include "base/failure.hpp"

#include <string>
#include <string_view>
#include <vector>

/// Text on the screen. Colour only on a terminal, and not where NO_COLOR is set (https://no-color.org).
namespace matrigrate::apps {

enum class Stream { out, err };
enum class Colour { bad, good, warning, strong };

/// text in a colour, if the stream shows colours
std::string coloured(std::string_view text, Colour colour, Stream stream);

/// @throws InputOutputError if the stream cannot be written
void print(std::string_view text);
void flush();

void print_error(std::string_view text);
void print_warning(std::string_view text); ///< a line, after the program's name
void print_faults(const std::vector<Fault>& faults);

} // namespace matrigrate::apps
