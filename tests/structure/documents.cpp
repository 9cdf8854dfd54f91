#include "documents.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace matrigrate::structure {

namespace {

/// Names of sources that the program or its build writes.
const std::set<std::string> written{"submit.sh", "build_info.hpp", "shipped_studies.cpp", "shipped_pages.cpp"};

std::string content_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + path.string());
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

template <class Visit>
void each_text_line(std::string_view text, const Visit& visit) {
  std::istringstream in{std::string(text)};
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) visit(number, line);
}

template <class Visit>
void each_match(const std::string& text, const std::regex& pattern, const Visit& visit) {
  for (auto i = std::sregex_iterator(text.begin(), text.end(), pattern); i != std::sregex_iterator(); ++i) visit(*i);
}

/// Whether a name with asterisks fits another.
bool fits(std::string_view pattern, std::string_view name) {
  if (pattern.empty()) return name.empty();
  if (pattern[0] != '*') return !name.empty() && pattern[0] == name[0] && fits(pattern.substr(1), name.substr(1));
  for (std::size_t i = 0; i <= name.size(); ++i)
    if (fits(pattern.substr(1), name.substr(i))) return true;
  return false;
}

bool exists(const std::string& path, const Tree& tree) {
  const std::string plain = path.ends_with('/') ? path.substr(0, path.size() - 1) : path;
  if (plain.find('*') == std::string::npos) return tree.contains(plain) || tree.contains(plain + '/');
  return std::ranges::any_of(tree, [&](const std::string& known) { return fits(plain, known); });
}

/// Whether a name without folders is that of some file.
bool is_name_of_a_file(const std::string& name, const Tree& tree) {
  return std::ranges::any_of(tree, [&](const std::string& known) {
    return fits(name, std::string_view(known).substr(known.rfind('/') + 1)); // npos + 1 is 0
  });
}

std::string normal(const std::string& path) { return std::filesystem::path(path).lexically_normal().generic_string(); }

std::string folder_of(const std::string& path) { return path.substr(0, path.rfind('/') + 1); }

/// The paths in a line that are in no folder where the page or source may mean them.
std::vector<std::string> missing(const std::string& line, const std::string& own_folder, const Tree& tree) {
  static const std::regex word(R"([\w.*/+-]*[\w*/])");
  static const std::regex ours(
      R"((?:src|apps|tests|docs|tools|cmake|scenarios|studies|benchmarks|examples|viewer)/.*)");
  static const std::regex source(R"(.*[\w*]\.(?:hpp|cpp|ts|cmake|sh|md))");
  std::vector<std::string> found;
  static const std::regex address(R"(\w+://\S+)");
  const std::string text = std::regex_replace(line, address, "");
  each_match(text, word, [&](const std::smatch& match) {
    const std::string path = match.str();
    const bool is_source = std::regex_match(path, source);
    if (path.starts_with('/') || (!is_source && !std::regex_match(path, ours)) || written.contains(path)) return;
    const bool named = path.find('/') == std::string::npos && is_name_of_a_file(path, tree);
    const bool there = std::ranges::any_of(
        std::vector<std::string>{"", "src/", "src/model/", "src/run/", "src/study/", own_folder, folder_of(own_folder)},
        [&](const std::string& folder) { return exists(normal(folder + path), tree); });
    if (!named && !there) found.push_back(path);
  });
  return found;
}

std::string at(const std::string& path, int line, const std::string& message) {
  return path + ':' + std::to_string(line) + ": " + message;
}

} // namespace

Tree tree(const std::filesystem::path& root) {
  Tree found;
  for (auto i = std::filesystem::recursive_directory_iterator(root);
       i != std::filesystem::recursive_directory_iterator(); ++i) {
    const std::string name = i->path().filename();
    if (name.starts_with('.') || name == "build" || name == "node_modules") {
      i.disable_recursion_pending();
      continue;
    }
    found.insert(std::filesystem::relative(i->path(), root).generic_string() + (i->is_directory() ? "/" : ""));
  }
  return found;
}

std::vector<Document> documents(const std::filesystem::path& root, const Tree& tree) {
  std::vector<Document> found;
  for (const std::string& path : tree)
    if (path.ends_with(".md")) found.push_back({path, content_of(root / path)});
  return found;
}

std::set<std::string> anchors(std::string_view markdown) {
  std::set<std::string> found;
  bool code = false;
  each_text_line(markdown, [&](int, const std::string& line) {
    if (line.starts_with("```")) code = !code;
    if (code || !line.starts_with('#')) return;
    std::string anchor;
    for (const char c : line.substr(std::min(line.find_first_not_of("# "), line.size())))
      if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_')
        anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      else if (c == ' ')
        anchor += '-';
    found.insert(anchor);
  });
  return found;
}

Findings dead_links(const Document& document, const std::vector<Document>& all, const Tree& tree) {
  static const std::regex link(R"(\]\(([^)\s]+)\))");
  Findings findings;
  each_text_line(document.text, [&](int number, const std::string& line) {
    each_match(line, link, [&](const std::smatch& match) {
      const std::string target = match[1];
      if (target.find("://") != std::string::npos) return;
      const std::string file = target.substr(0, target.find('#'));
      const std::string path = file.empty() ? document.path : normal(folder_of(document.path) + file);
      if (!exists(path, tree)) return findings.push_back(at(document.path, number, "no such file: " + target));
      if (file.size() == target.size()) return;
      const auto page = std::ranges::find(all, path, &Document::path);
      if (page == all.end() || !anchors(page->text).contains(target.substr(file.size() + 1)))
        findings.push_back(at(document.path, number, "no such heading: " + target));
    });
  });
  return findings;
}

Findings missing_files(const Document& document, const Tree& tree) {
  Findings findings;
  each_text_line(document.text, [&](int number, const std::string& line) {
    for (const std::string& path : missing(line, folder_of(document.path), tree))
      findings.push_back(at(document.path, number, "no such file: " + path));
  });
  return findings;
}

Findings missing_files_in_comments(const Source& source, const Tree& tree) {
  static const std::regex comment(R"(^\s*//(.*)$|\s///?<?\s(.*)$)");
  Findings findings;
  each_text_line(source.text, [&](int number, const std::string& line) {
    std::smatch match;
    if (!std::regex_search(line, match, comment)) return;
    for (const std::string& path : missing(match[1].str() + match[2].str(), folder_of(source.path), tree))
      findings.push_back(at(source.path, number, "no such file: " + path));
  });
  return findings;
}

Findings unknown_commands(const Document& document, const std::set<std::string>& known) {
  static const std::regex command(R"(\bmatrigrate ([a-z][^`#]*))");
  static const std::regex verb(R"(^[a-z]+)");
  static const std::regex option(R"(\s(--[a-z][a-z-]*))");
  Findings findings;
  each_text_line(document.text, [&](int number, const std::string& line) {
    each_match(line, command, [&](const std::smatch& match) {
      const std::string words = match[1].str();
      const std::string own = words.substr(0, words.find(" -- ")); // what follows is for another program
      std::vector<std::string> named;
      each_match(own, verb, [&](const std::smatch& found) { named.push_back(found.str()); });
      each_match(own, option, [&](const std::smatch& found) { named.push_back(found[1]); });
      for (const std::string& name : named)
        if (!known.contains(name)) findings.push_back(at(document.path, number, "no such verb or option: " + name));
    });
  });
  return findings;
}

std::set<std::string> declared_commands(const std::string& source) {
  static const std::regex declaration(R"re(add_(?:subcommand|option|flag)\(\s*"([^"]+)")re");
  static const std::regex name("[^,]+");
  std::set<std::string> found;
  each_match(source, declaration, [&](const std::smatch& match) {
    each_match(match[1].str(), name, [&](const std::smatch& part) { found.insert(part.str()); });
  });
  return found;
}

std::set<std::string> listed(std::string_view markdown, const std::string& heading) {
  static const std::regex name("`([^`]+)`");
  std::set<std::string> found;
  bool inside = false;
  each_text_line(markdown, [&](int, const std::string& line) {
    if (line.starts_with('#')) inside = line == heading;
    if (!inside || !line.starts_with('|')) return;
    each_match(line.substr(0, line.find('|', 1)), name, [&](const std::smatch& match) { found.insert(match[1]); });
  });
  return found;
}

std::set<std::string> packages(std::string_view shell, const std::string& list) {
  const std::size_t start = shell.find(list + "=\"");
  if (start == std::string_view::npos) return {};
  const std::string_view text = shell.substr(start + list.size() + 2);
  std::set<std::string> found;
  each_text_line(text.substr(0, text.find('"')), [&](int, const std::string& line) {
    if (line.find(':') != std::string::npos) found.insert(line.substr(0, line.find(':')));
  });
  return found;
}

} // namespace matrigrate::structure
