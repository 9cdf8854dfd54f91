#include "tracks/table.hpp"

#include "parameters/document.hpp"
#include "tracks/layouts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace matrigrate::tracks {

namespace {

constexpr std::string_view both_signs = ".,";

bool is_digits(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

/// A number with a sign, as an example.
struct Example {
  std::string text;
  std::size_t line = 0;

  bool there() const { return line > 0; }
};

/// What the numbers of a column, or of all, say of the point and of the comma.
struct Evidence {
  std::array<Example, 2> decimal, thousands; ///< what is certain
  std::array<Example, 2> either;             ///< three digits stand behind it
  std::array<std::size_t, 2> many{};         ///< of these
  std::array<bool, 2> ends_in_zero{};        ///< one of these, which no decimals do beside numbers without any
  bool bare = false;                         ///< whether others have no sign, and at most three digits
  bool long_bare = false;                    ///< or more

  void add(const std::string& field, std::size_t line) {
    const auto keep = [&](Example& example) {
      if (!example.there()) example = {.text = field, .line = line};
    };
    std::string_view text = trimmed(field);
    if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
    const std::size_t first = text.find_first_of(both_signs), last = text.find_last_of(both_signs);
    if (first == std::string_view::npos) {
      if (is_digits(text)) (text.size() > 3 ? long_bare : bare) = true;
      return;
    }
    const std::size_t sign = both_signs.find(text[first]);
    const std::string_view before = text.substr(0, first), behind = text.substr(first + 1);
    if (first != last) {
      if (!has_thousands_sign(text)) return;
      keep(thousands.at(sign));
      if (text[last] != text[first]) keep(decimal.at(1 - sign));
    } else if (is_digits(before) && before.size() <= 3 && before[0] != '0' && is_digits(behind) && behind.size() == 3) {
      keep(either.at(sign));
      ++many.at(sign);
      ends_in_zero.at(sign) = ends_in_zero.at(sign) || behind.back() == '0';
    } else if (sheet_number(text, sign == 1)) {
      keep(decimal.at(sign));
    }
  }
};

/// Decides on signs with three digits behind them each time.
void decide(const std::vector<Evidence>& columns, char separator, Evidence& all, Findings& findings) {
  const auto open = [&](const Evidence& column, std::size_t s) {
    return column.either.at(s).there() && !all.decimal.at(s).there() && !all.thousands.at(s).there();
  };
  for (const std::size_t s : {std::size_t{0}, std::size_t{1}}) {
    if (s == 0 && separator == ',') continue; // who writes commas between columns writes points in numbers
    for (const Evidence& column : columns) {
      if (!open(column, s) || !column.bare || column.long_bare) continue;
      if (column.ends_in_zero.at(s) || column.many.at(s) >= 3)
        all.thousands.at(s) = column.either.at(s);
      else
        findings.fault(column.either.at(s).line,
                       "{} may be a thousand or have decimals: write numbers without signs between their thousands",
                       column.either.at(s).text);
    }
  }
  for (const Evidence& column : columns)
    for (const std::size_t s : {std::size_t{0}, std::size_t{1}})
      if (open(column, s)) all.decimal.at(s) = column.either.at(s);
}

} // namespace

NumberSigns number_signs(const Table& table, Findings& findings) {
  Evidence all;
  std::vector<Evidence> columns;
  for (const Table::Column c : {table.x, table.y, table.t, table.frame}) {
    Evidence& own = columns.emplace_back();
    for (const SheetRow& row : table.rows)
      if (c) own.add(row.field(c), row.line);
    for (const std::size_t s : {std::size_t{0}, std::size_t{1}}) {
      if (own.decimal.at(s).there() && !all.decimal.at(s).there()) all.decimal.at(s) = own.decimal.at(s);
      if (own.thousands.at(s).there() && !all.thousands.at(s).there()) all.thousands.at(s) = own.thousands.at(s);
    }
  }
  decide(columns, table.separator, all, findings);
  const auto& [points, commas] = all.decimal;
  if (points.there() && commas.there())
    findings.fault(commas.line, "has numbers with a comma, {}, and others with a point, {}: write points alone",
                   commas.text, points.text);
  NumberSigns signs{.decimal = commas.there() ? ',' : '.', .thousands = '\0'};
  for (const std::size_t s : {std::size_t{0}, std::size_t{1}}) {
    const Example& example = all.thousands.at(s);
    if (!example.there()) continue;
    if (all.decimal.at(s).there())
      findings.fault(example.line, "has {} between thousands, {}, which are decimal signs in {}: write points alone",
                     s == 0 ? "points" : "commas", example.text, all.decimal.at(s).text);
    signs = {.decimal = both_signs[1 - s], .thousands = both_signs[s]};
  }
  if (!findings.good()) return signs;
  const Example& example = signs.thousands != '\0' ? all.thousands.at(both_signs.find(signs.thousands)) : commas;
  if (!example.there()) return signs;
  const double value = number_of(example.text, signs).value_or(std::numeric_limits<double>::quiet_NaN());
  findings.note("{} {}: {} is {}", signs.thousands == '.' ? "points" : "commas",
                signs.thousands == '\0' ? "are read as decimal signs" : "separate thousands", example.text, value);
  return signs;
}

std::optional<double> number_of(std::string_view field, const NumberSigns& signs) {
  std::string text(trimmed(field));
  if (has_thousands_sign(text)) {
    std::erase_if(text, [&](char c) { return c == '\'' || c == ' ' || c == signs.thousands; });
  }
  return sheet_number(text, signs.decimal == ',');
}

namespace {

/// Takes a whole number of at most nine digits off the start of a text.
std::optional<int> take_number(std::string_view& text) {
  int number = 0;
  const char* const end = text.data() + std::min<std::size_t>(text.size(), 9);
  const auto [at, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || text.starts_with('-')) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(at - text.data()));
  return number;
}

bool take(std::string_view& text, std::string_view what) {
  if (!text.starts_with(what)) return false;
  text.remove_prefix(what.size());
  return true;
}

struct ClockTime {
  double s = 0.0;
  int days = 0;          ///< of a date, since 1970, or in front of the time
  bool dated = false;    ///< whether it has a date
  bool either = false;   ///< whether the date may be read in two ways: 5/3/2024
  int parts = 0;         ///< that colons separate
  bool fraction = false; ///< of the last part
};

/// A date at the start of a text: 2024-05-03, 2024/5/3, 3.5.2024, 5/13/2024.
bool take_date(std::string_view& text, ClockTime& time) {
  std::string_view rest = text;
  const auto first = take_number(rest);
  const char sign = rest.empty() ? '\0' : rest[0];
  if (!first || (sign != '-' && sign != '/' && sign != '.')) return false;
  rest.remove_prefix(1);
  const auto second = take_number(rest);
  if (!second || !take(rest, {&sign, 1})) return false;
  const auto third = take_number(rest);
  if (!third || !(rest.empty() || take(rest, " ") || take(rest, "t"))) return false;
  int year = *first, month = *second, day = *third;
  if (year < 1000) {
    year = *third;
    const bool american = sign == '/' && *second > 12;
    day = american ? *second : *first;
    month = american ? *first : *second;
    time.either = sign == '/' && *first <= 12 && *second <= 12 && *first != *second;
  }
  const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day))};
  if (year < 1900 || year > 2200 || !date.ok()) return false;
  time.days = static_cast<int>(std::chrono::sys_days(date).time_since_epoch().count());
  time.dated = true;
  text = trimmed(rest);
  return true;
}

/// The parts that colons separate, at the start of a text; the last may have decimals.
std::vector<double> take_parts(std::string_view& text, ClockTime& time) {
  std::vector<double> parts;
  do {
    const auto whole = take_number(text);
    if (!whole) return {};
    parts.push_back(*whole);
  } while (parts.size() < 3 && take(text, ":"));
  if (!text.empty() && (text[0] == '.' || text[0] == ',')) {
    const std::size_t end = std::min(text.find_first_not_of("0123456789", 1), text.size());
    parts.back() += sheet_number("0." + std::string(text.substr(1, end - 1)), false).value_or(0.0);
    text.remove_prefix(end);
    time.fraction = true;
  }
  return parts;
}

std::optional<ClockTime> parse_clock(std::string_view field, bool hours) {
  const std::string whole = lower(trimmed(field));
  std::string_view text = whole;
  ClockTime time;
  if (!take_date(text, time)) {
    std::string_view rest = text;
    if (const auto days = take_number(rest); days && (take(rest, " days") || take(rest, " day"))) {
      time.days = *days;
      take(rest, ",");
      text = trimmed(rest);
    }
  }
  time.s = 86400.0 * time.days;
  if (text.empty()) return time.dated || time.days > 0 ? std::optional(time) : std::nullopt;
  std::vector<double> parts = take_parts(text, time);
  if (parts.size() < 2) return std::nullopt;
  time.parts = static_cast<int>(parts.size());
  if (parts.size() == 2) parts.insert(hours || time.dated ? parts.end() : parts.begin(), 0.0);
  text = trimmed(text);
  if (const bool noon = take(text, "pm"); noon || take(text, "am"))
    parts[0] += (noon ? 12.0 : 0.0) - (parts[0] == 12.0 ? 12.0 : 0.0);
  if (take(text, "+") || (time.dated && take(text, "-"))) // the zone, which is that of all
    text.remove_prefix(std::min(text.find_first_not_of("0123456789:"), text.size()));
  if (!text.empty() && text != "z" && text != "utc") return std::nullopt;
  if (parts[1] >= 60.0 + 1e-9 || parts[2] >= 61.0) return std::nullopt;
  time.s += 3600.0 * parts[0] + 60.0 * parts[1] + parts[2];
  return time;
}

} // namespace

Clock clock_of(const Table& table, Findings& findings) {
  Clock clock;
  if (!table.t) return clock;
  bool two = false, three = false, fraction = false, dated = false, either = false;
  std::set<int> days;
  double first = std::numeric_limits<double>::infinity();
  for (const SheetRow& row : table.rows) {
    const std::string& field = row.field(table.t);
    const auto time = parse_clock(field, true);
    if (!time && !clock.runs && !says_nothing(field)) return clock; // numbers
    if (!time) continue;
    clock.runs = true;
    two = two || (time->parts == 2 && !time->dated);
    three = three || time->parts == 3;
    fraction = fraction || (time->parts == 2 && time->fraction);
    dated = dated || time->dated;
    either = either || time->either;
    days.insert(time->days);
    first = std::min(first, time->s);
  }
  if (dated) clock.origin = first;
  if (dated && either && days.size() > 1)
    findings.fault(0, "{}: dates with / may be read in two ways: write 2024-05-03", table.name(table.t));
  if (!two) return clock;
  const std::string title = lower(table.name(table.t));
  const bool by_title = title.find("m:s") != std::string::npos || title.find("mm:ss") != std::string::npos
                        || title.find("min:s") != std::string::npos;
  clock.hours = !(fraction || three || by_title);
  if (clock.hours && title.find("h:m") == std::string::npos && title.find("hh:mm") == std::string::npos)
    findings.fault(0, "{}: times of two parts may be h:min or min:s: write all three, h:min:s", table.name(table.t));
  return clock;
}

std::optional<double> clock_time(std::string_view field, const Clock& clock) {
  const auto time = parse_clock(field, clock.hours);
  return time ? std::optional(time->s - clock.origin) : std::nullopt;
}

} // namespace matrigrate::tracks
