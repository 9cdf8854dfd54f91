#include "parameters/judge.hpp"

#include "base/failure.hpp"
#include "parameters/assign.hpp"
#include "parameters/nearest.hpp"

#include <nlohmann/json.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace matrigrate {

namespace {

using Question = nlohmann::json;

struct Answer {
  std::string fault;
  double number = 0.0;
};

const Row* any_row(std::string_view path) {
  const auto row = std::ranges::find(cell_rows(), path, &Row::path);
  return row == cell_rows().end() ? find_row(path) : &*row;
}

/// @throws Question::exception if it is of no form that judged() documents
Given typed_value(const Question& question) {
  if (const auto type = question.find("type"); type != question.end()) return {{}, type->get_ref<const std::string&>()};
  if (const auto real = question.find("real"); real != question.end())
    return {std::strtod(real->get_ref<const std::string&>().c_str(), nullptr), "a number"};
  const Question& value = question.at("value");
  if (value.is_boolean()) return {value.get<bool>(), "a flag"};
  if (value.is_number_integer()) return {value.get<std::int64_t>(), "a number"};
  if (value.is_number()) return {value.get<double>(), "a number"};
  return {value.get<std::string>(), "a string"};
}

Answer answer(const Question& question) {
  const auto& path = question.at("path").get_ref<const std::string&>();
  const bool section = question.value("section", false);
  const Row* row = any_row(path);
  if (row == nullptr || question.contains("section"))
    return {fmt::format("there is no such {}{}", section ? "section" : "parameter", parameter_hint(path))};
  Parameters p;
  std::string fault = assign(*row, typed_value(question), p);
  const auto* member = std::get_if<double& (*)(Parameters&)>(&row->member);
  if (!fault.empty() || member == nullptr) return {std::move(fault)};
  return {{}, units::number_in((*member)(p), unit_of(*row))};
}

} // namespace

std::string judged(std::string_view questions) {
  try {
    Question answers = Question::array();
    for (const Question& question : Question::parse(questions)) {
      Answer found = answer(question);
      answers.push_back({{"fault", std::move(found.fault)}, {"number", found.number}});
    }
    return answers.dump(-1, ' ', false, Question::error_handler_t::replace);
  } catch (const Question::exception& error) {
    throw ConfigurationError(
        {{"", 0, 0, "", fmt::format("this is no list of values, see `matrigrate check --help`: {}", error.what())}});
  }
}

} // namespace matrigrate
