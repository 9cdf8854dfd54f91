#pragma once

#include "source_tree.hpp"

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>

/// What documents and comments say about files: links, anchors, paths, packages.
namespace matrigrate::structure {

/// The files of the project by their paths from its root; folders too, with a slash at their end. Hidden files, build/
/// and node_modules/ are left out.
using Tree = std::set<std::string>;
Tree tree(const std::filesystem::path& root);

/// A page of Markdown.
struct Document {
  std::string path; ///< from the root of the project: "docs/studies.md"
  std::string text;
};

/// All pages of the tree. @throws std::runtime_error if one cannot be read
std::vector<Document> documents(const std::filesystem::path& root, const Tree& tree);

/// The anchors of a page: its headings, as GitHub turns them into names.
std::set<std::string> anchors(std::string_view markdown);

/// Links, to files or within them, that lead nowhere. Links to other hosts are not followed.
Findings dead_links(const Document& document, const std::vector<Document>& all, const Tree& tree);

/// Paths that a page names, in code or in text, and that do not exist: those that begin with one of the project's
/// folders, and names of sources. An asterisk stands for any characters.
Findings missing_files(const Document& document, const Tree& tree);

/// The same of the comments of a C++ source; its path is from the root of the project.
Findings missing_files_in_comments(const Source& source, const Tree& tree);

/// Verbs and options that a page gives in a command `matrigrate ...` and that the program does not have.
/// @param known  as in the sources: add_subcommand("run", ...), add_option("-o,--output", ...)
Findings unknown_commands(const Document& document, const std::set<std::string>& known);

/// The verbs and options that are declared in the text of a source.
std::set<std::string> declared_commands(const std::string& source);

/// The code spans in the first column of the tables of a section: `name` in "| `name` | reason |".
std::set<std::string> listed(std::string_view markdown, const std::string& heading);

/// The packages in a list of tools/setup.sh: NAME="\npackage: reason\n...".
std::set<std::string> packages(std::string_view shell, const std::string& list);

} // namespace matrigrate::structure
