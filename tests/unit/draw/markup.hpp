#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace matrigrate {

inline std::size_t occurrences(std::string_view text, std::string_view what) {
  std::size_t n = 0;
  for (std::size_t at = text.find(what); at != std::string_view::npos; at = text.find(what, at + what.size())) ++n;
  return n;
}

/// An opening tag or a stretch of text of a document.
struct Piece {
  std::string name; ///< of the element; empty for text
  std::map<std::string, std::string> attributes;
  std::string text;
};

/// Reads well-formed XML of the kind that the figures are written in: each element closed in order, attributes in
/// double quotes and none twice, no bare & < >. Nothing if it is not well formed.
inline std::optional<std::vector<Piece>> parsed(std::string_view xml) {
  std::vector<Piece> pieces;
  std::vector<std::string> open;
  const auto entities_hold = [](std::string_view text) {
    return occurrences(text, "&")
           == occurrences(text, "&amp;") + occurrences(text, "&lt;") + occurrences(text, "&gt;")
                  + occurrences(text, "&quot;") + occurrences(text, "&#39;");
  };
  while (!xml.empty()) {
    if (xml.front() != '<') {
      const std::string_view text = xml.substr(0, xml.find('<'));
      if (text.find('>') != std::string_view::npos || !entities_hold(text)) return std::nullopt;
      if (open.empty() && text != "\n") return std::nullopt;
      pieces.push_back({"", {}, std::string(text)});
      xml.remove_prefix(text.size());
      continue;
    }
    const std::size_t end = xml.find('>');
    if (end == std::string_view::npos) return std::nullopt;
    std::string_view tag = xml.substr(1, end - 1);
    xml.remove_prefix(end + 1);
    if (tag.starts_with('/')) {
      if (open.empty() || open.back() != tag.substr(1)) return std::nullopt;
      open.pop_back();
      continue;
    }
    const bool empty_element = tag.ends_with('/');
    if (empty_element) tag.remove_suffix(1);
    Piece piece{std::string(tag.substr(0, tag.find(' '))), {}, ""};
    tag.remove_prefix(piece.name.size());
    while (!tag.empty()) {
      const std::size_t equals = tag.find("=\"");
      if (tag.front() != ' ' || equals == std::string_view::npos) return std::nullopt;
      const std::size_t close = tag.find('"', equals + 2);
      if (close == std::string_view::npos) return std::nullopt;
      const std::string_view value = tag.substr(equals + 2, close - equals - 2);
      if (!entities_hold(value) || value.find('<') != std::string_view::npos) return std::nullopt;
      if (!piece.attributes.emplace(tag.substr(1, equals - 1), value).second) return std::nullopt;
      tag.remove_prefix(close + 1);
    }
    if (!empty_element) open.push_back(piece.name);
    pieces.push_back(std::move(piece));
  }
  if (!open.empty()) return std::nullopt;
  return pieces;
}

} // namespace matrigrate
