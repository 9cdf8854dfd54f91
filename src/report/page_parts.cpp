#include "report/page_parts.hpp"

#include "draw/svg.hpp"
#include "report/page_style.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string_view>
#include <utility>

namespace matrigrate::report {

namespace {

std::string replaced(std::string text, std::string_view what, std::string_view with) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
    text.replace(at, what.size(), with);
  return text;
}

/// The SVG element alone, with its ids set apart from those of the other pictures of the page.
std::string inlined(const draw::Figure& figure, std::string_view prefix) {
  const std::size_t begin = figure.svg.find("<svg");
  if (begin == std::string::npos) throw std::invalid_argument(fmt::format("figure '{}' is no SVG", figure.name));
  std::string svg = replaced(figure.svg.substr(begin), " id=\"", fmt::format(" id=\"{}", prefix));
  svg = replaced(std::move(svg), "url(#", fmt::format("url(#{}", prefix));
  return replaced(std::move(svg), "href=\"#", fmt::format("href=\"#{}", prefix));
}

} // namespace

std::string page_head(const std::string& title) {
  return fmt::format("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                     "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
                     "<title>{0}</title>\n<style>{1}</style>\n</head>\n<body>\n<h1>{0}</h1>\n",
                     draw::svg::escape(title), page_style);
}

std::string figures_html(const std::vector<draw::Figure>& figures, const std::string& prefix) {
  if (figures.empty()) return {};
  std::string out = "<div class=\"figures\">\n";
  for (std::size_t f = 0; f < figures.size(); ++f)
    out +=
        fmt::format("<figure>\n{}<figcaption>{}</figcaption>\n</figure>\n",
                    inlined(figures[f], fmt::format("{}f{}-", prefix, f + 1)), draw::svg::escape(figures[f].caption));
  return out + "</div>\n";
}

std::string page_end(const std::string& provenance) {
  return fmt::format("<section>\n<h2>Provenance</h2>\n<pre>{}</pre>\n</section>\n</body>\n</html>\n",
                     draw::svg::escape(provenance));
}

} // namespace matrigrate::report
