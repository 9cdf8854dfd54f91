#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
class ParseError;
} // namespace CLI

/// What is wrong with a command line. Test: tests/apps/usage_test.cpp
namespace matrigrate::apps {

/// In the help of the program and of its groups of verbs.
/// @param rare  verbs that stand last, under a title of their own
void call_subcommands_verbs(CLI::App& app, const std::vector<std::string>& rare);

/// @throws UsageError naming the verbs there are, if the command line has none or an unknown one
void require_verb(const CLI::App& app, int argc, char** argv);

/// In one line: the unknown option with the nearest one, the arguments that are too many in the order typed, or what
/// the parser says.
std::string usage_fault(const CLI::App& app, const CLI::ParseError& error);

} // namespace matrigrate::apps
