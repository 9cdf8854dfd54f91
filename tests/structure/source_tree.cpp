#include "source_tree.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace matrigrate::structure {

namespace {

std::string read(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + path.string());
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// Calls visit(line number, line) for each line.
template <class Visit>
void each_line(const std::string& text, const Visit& visit) {
  std::istringstream in(text);
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) visit(number, line);
}

std::string at(const Source& source, int line, const std::string& message) {
  return (source.wing.empty() ? "" : source.wing + '/') + source.path + ':' + std::to_string(line) + ": " + message;
}

/// Length of the comment or literal at the start of `text`, 0 if there is none there.
std::size_t skipped_length(std::string_view text) {
  const auto until = [&](std::string_view end, std::size_t from) {
    const std::size_t found = text.find(end, from);
    return found == std::string_view::npos ? text.size() : found + end.size();
  };
  if (text.starts_with("//")) return std::min(text.find('\n'), text.size());
  if (text.starts_with("/*")) return until("*/", 2);
  if (text.starts_with("R\"")) {
    const std::size_t open = std::min(text.find('(', 2), text.size());
    return until(')' + std::string(text.substr(2, open - 2)) + '"', open);
  }
  if (!text.starts_with('"') && !text.starts_with('\'')) return 0;
  std::size_t end = 1;
  while (end < text.size() && text[end] != text[0] && text[end] != '\n') end += text[end] == '\\' ? 2 : 1;
  return std::min(end + 1, text.size());
}

} // namespace

std::map<std::string, std::filesystem::path> libraries(const std::filesystem::path& src) {
  std::map<std::string, std::filesystem::path> found;
  for (const std::string& wing : wings(src))
    for (const auto& [name, named] : declared_folders(read(src / wing / "CMakeLists.txt"))) {
      const std::filesystem::path folder = name == wing ? src / wing : src / wing / name;
      if (!std::filesystem::is_directory(folder))
        throw std::runtime_error(wing + " declares the folder '" + name + "'");
      found.emplace(name, folder);
    }
  return found;
}

std::vector<Source> sources(const std::filesystem::path& src) {
  const auto known = libraries(src);
  std::vector<Source> found;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(src)) {
    if (entry.path().extension() != ".hpp" && entry.path().extension() != ".cpp") continue;
    std::filesystem::path library = entry.path().parent_path();
    const auto is_library = [&](const std::filesystem::path& folder) {
      const auto named = known.find(folder.filename());
      return named != known.end() && named->second == folder;
    };
    while (library != src && !is_library(library)) library = library.parent_path();
    const std::filesystem::path root = library == src ? src : library.parent_path();
    const std::string wing = std::filesystem::relative(entry.path(), src).begin()->string();
    found.push_back(
        {std::filesystem::relative(entry.path(), root).generic_string(), read(entry.path()), root == src ? "" : wing});
  }
  std::sort(found.begin(), found.end(), [](const Source& a, const Source& b) { return a.path < b.path; });
  return found;
}

Findings long_functions(const Source& source, int most_lines) {
  Findings findings;
  std::istringstream in(source.text);
  std::string line;
  int start = 0; // the line of the last declaration at the left edge; 0: none since the last brace
  for (int number = 1; std::getline(in, line); ++number) {
    if (line == "}") {
      const int length = number - start + 1;
      if (start > 0 && length > most_lines)
        findings.push_back(source.path + ':' + std::to_string(start) + ": a function of " + std::to_string(length)
                           + " lines");
      start = 0;
    } else if (!line.empty() && std::string_view(" }#/").find(line[0]) == std::string_view::npos
               && !line.starts_with("template")) {
      start = number;
    }
  }
  return findings;
}

Graph declared_folders(std::string_view cmake) {
  const std::string text = std::regex_replace(std::string(cmake), std::regex("#[^\n]*"), "");
  const std::regex call(R"(matrigrate_folder\s*\(\s*(\w+)([^)]*)\))");
  const std::regex target(R"(\bmatrigrate_(\w+))");
  Graph declared;
  for (auto i = std::sregex_iterator(text.begin(), text.end(), call); i != std::sregex_iterator(); ++i) {
    const std::string depends = (*i)[2];
    std::set<std::string>& named = declared[(*i)[1]];
    for (auto k = std::sregex_iterator(depends.begin(), depends.end(), target); k != std::sregex_iterator(); ++k)
      named.insert((*k)[1]);
  }
  return declared;
}

Graph declared_edges(const std::filesystem::path& src) {
  Graph edges;
  for (const std::string& wing : wings(src)) edges.merge(declared_folders(read(src / wing / "CMakeLists.txt")));
  return edges;
}

std::vector<std::string> wings(const std::filesystem::path& src) {
  const std::string text = read(src / "CMakeLists.txt");
  const std::regex call(R"(add_subdirectory\((\w+)\))");
  std::vector<std::string> found;
  for (auto i = std::sregex_iterator(text.begin(), text.end(), call); i != std::sregex_iterator(); ++i)
    found.push_back((*i)[1]);
  return found;
}

Graph closure(const Graph& edges) {
  Graph reach = edges;
  for (bool grown = true; grown;) {
    grown = false;
    for (auto& [folder, reached] : reach)
      for (const std::string& next : std::set<std::string>(reached))
        if (const auto further = reach.find(next); further != reach.end())
          for (const std::string& last : std::set<std::string>(further->second))
            grown = reached.insert(last).second || grown;
  }
  return reach;
}

std::string code_only(std::string_view text, bool keep_strings) {
  std::string code(text);
  for (std::size_t i = 0; i < text.size();) {
    // The quotation mark in 10'000 separates digits.
    const bool separator = text[i] == '\'' && i > 0 && std::isalnum(static_cast<unsigned char>(text[i - 1])) != 0;
    const std::size_t length = separator ? 0 : skipped_length(text.substr(i));
    const bool comment = text[i] == '/';
    if (length > 0 && (comment || !keep_strings))
      for (std::size_t k = i; k < i + length; ++k)
        if (code[k] != '\n' && (comment || (k > i && k + 1 < i + length))) code[k] = ' ';
    i += std::max<std::size_t>(length, 1);
  }
  return code;
}

Findings forbidden_includes(const Source& source, const Graph& allowed) {
  static const std::regex include(R"rx(^\s*#\s*include\s*"(?:([\w]+)/)?([^"]*)")rx");
  Findings findings;
  each_line(code_only(source.text, true), [&](int number, const std::string& line) {
    std::smatch match;
    if (!std::regex_search(line, match, include)) return;
    const std::string folder = match[1];
    if (!match[1].matched) {
      // build_info.hpp is written by the build.
      if (match[2] != "build_info.hpp")
        findings.push_back(
            at(source, number, "name the header by the path from the folder above its library: " + line));
      return;
    }
    const auto own = allowed.find(source.folder());
    if (folder != source.folder() && (own == allowed.end() || !own->second.contains(folder)))
      findings.push_back(at(source, number, source.folder() + " may not include " + folder));
  });
  return findings;
}

Graph reached_includes(const std::vector<Source>& all) {
  static const std::regex include(R"rx(^\s*#\s*include\s*(?:"([^"]*)"|(<[^>]*>)))rx");
  Graph headers, sources;
  for (const Source& source : all) {
    std::set<std::string>& of_file = (source.path.ends_with(".hpp") ? headers : sources)[source.path];
    each_line(code_only(source.text, true), [&](int, const std::string& line) {
      std::smatch match;
      if (line.starts_with('#') && std::regex_search(line, match, include))
        of_file.insert(match[1].matched ? match[1] : match[2]);
    });
  }
  Graph reached = closure(headers);
  for (const auto& [source, named] : sources) { // nothing includes a source
    std::set<std::string>& of_source = reached[source] = named;
    for (const std::string& header : named)
      if (const auto further = reached.find(header); further != reached.end())
        of_source.insert(further->second.begin(), further->second.end());
  }
  return reached;
}

Findings undeclared_names(const Source& source, const Graph& reached) {
  struct Library {
    std::string header;
    std::regex names;
  };
  static const auto standard = [](const std::string& name, const std::string& names) {
    return Library{'<' + name + '>', std::regex("\\bstd::(?:" + names + ")\\b")};
  };
  static const std::vector<Library> libraries{
      standard("algorithm", "m(?:in|ax)|clamp|copy|fill|sort|ranges::\\w+"),
      standard("array", "array"),
      standard("chrono", "chrono"),
      standard("cmath", "sqrt|exp|expm1|log10|abs|hypot|floor|nearbyint|isfinite|isnan"),
      standard("cstddef", "size_t|ptrdiff_t"),
      standard("cstdint", "u?int(?:8|16|32|64)_t"),
      standard("cstring", "mem(?:cpy|cmp)"),
      standard("filesystem", "filesystem"),
      standard("functional", "function|less|greater"),
      standard("initializer_list", "initializer_list"),
      standard("limits", "numeric_limits"),
      standard("map", "map"),
      standard("memory", "(?:unique|shared)_ptr|make_(?:unique|shared)"),
      standard("numbers", "numbers"),
      standard("optional", "optional|nullopt"),
      standard("set", "set"),
      standard("span", "span"),
      standard("stdexcept", "runtime_error|invalid_argument|out_of_range"),
      standard("string", "string"),
      standard("string_view", "string_view"),
      standard("tuple", "tuple"),
      standard("utility", "pair|move|forward|exchange"),
      standard("variant", "variant|monostate|variant_size_v"),
      standard("vector", "vector"),
      {"<fmt/format.h>", std::regex(R"(\bfmt::)")},
      {"<toml++/toml.h>", std::regex(R"(\btoml::)")}};
  const auto of_file = reached.find(source.path);
  Findings findings;
  each_line(code_only(source.text), [&](int number, const std::string& line) {
    if (line.find("::") == std::string::npos) return;
    for (const Library& library : libraries)
      if (!of_file->second.contains(library.header) && std::regex_search(line, library.names))
        findings.push_back(at(source, number, "needs #include " + library.header));
  });
  return findings;
}

Findings process_exits(const Source& source) {
  static const std::regex call(R"((?:^|[^\w.>])(exit|_exit|_Exit|abort|quick_exit|terminate)\s*\()");
  Findings findings;
  each_line(code_only(source.text), [&](int number, const std::string& line) {
    std::smatch match;
    if (std::regex_search(line, match, call)) findings.push_back(at(source, number, match[1].str() + " in a library"));
  });
  return findings;
}

Findings preprocessor_use(const Source& source) {
  static const std::regex directive(R"(^\s*#\s*(?!include\b|pragma\s+once\b)(\w+))");
  Findings findings;
  each_line(code_only(source.text), [&](int number, const std::string& line) {
    std::smatch match;
    if (std::regex_search(line, match, directive)) findings.push_back(at(source, number, '#' + match[1].str()));
  });
  return findings;
}

Findings mutable_globals(const Source& source) {
  // The formatter does not indent namespaces: what starts in the first column and reads `type name =`, `{`, `[` or `;`
  // is a variable of a namespace; after `static` or `thread_local` it is one of any scope.
  static const std::regex scope(
      R"(^[A-Za-z_:][\w:<>,*& ]*[\w>*&]\s+[*&]*(?!(?:\w+::)*operator\b)[A-Za-z_][\w:]*\s*(?:=|\{|\[|;))");
  static const std::regex fixed(
      R"(^\s*(?:static\s+|inline\s+|thread_local\s+)*(?:using|namespace|typedef|template|struct|class|enum|union|concept|friend|return|export)\b)");
  static const std::regex local(R"(^\s+(?:inline\s+)?(?:static|thread_local)\s[^(]*?[A-Za-z_]\w*\s*(?:=|\{|\[|;))");
  static const std::regex constant(R"(\bconstexpr\b|\bconst\b[^=({;*]*?[\w>]+\s*(?:=|\{|\[|;))");
  Findings findings;
  each_line(code_only(source.text), [&](int number, const std::string& line) {
    if (std::regex_search(line, fixed)) return;
    if (!std::regex_search(line, scope) && !std::regex_search(line, local)) return;
    if (!std::regex_search(line, constant)) findings.push_back(at(source, number, "mutable global: " + line));
  });
  return findings;
}

} // namespace matrigrate::structure
