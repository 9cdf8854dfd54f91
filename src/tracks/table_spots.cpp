#include "parameters/document.hpp"
#include "statistics/sample.hpp"
#include "tracks/layouts.hpp"
#include "tracks/spots.hpp"
#include "tracks/table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace matrigrate::tracks {

namespace {

constexpr double half_a_day = 43200.0; ///< [s]

/// Whether a text is a truth value, and which.
std::optional<bool> truth(std::string_view field) {
  const std::string word = lower(trimmed(field));
  if (word == "true" || word == "1" || word == "yes" || word == "t" || word == "1.0") return true;
  if (word == "false" || word == "0" || word == "no" || word == "f" || word == "0.0" || word.empty()) return false;
  return std::nullopt;
}

/// An id without the ".0" that it gets where ids are read as numbers, and without the apostrophe that guards it from
/// being computed by a spreadsheet.
std::string id_text(std::string_view field) {
  if (field.size() > 1 && field[0] == '\'' && std::string_view("=+-@").find(field[1]) != std::string_view::npos)
    field.remove_prefix(1);
  const std::string_view whole = field.substr(0, field.ends_with(".0") ? field.size() - 2 : 0);
  const std::size_t sign = whole.starts_with('-') ? 1 : 0;
  const bool number = whole.size() > sign && whole.find_first_not_of("0123456789", sign) == std::string_view::npos;
  return std::string(number ? whole : field);
}

/// Reads the rows of a table.
class SpotReader {
public:
  SpotReader(const Table& table, const TrackOptions& options, Findings& findings)
      : m_table(table), m_options(options), m_findings(findings), m_signs(number_signs(table, findings)),
        m_clock(clock_of(table, findings)) {
    for (std::size_t k = 0; k < table.parts; ++k) m_parts.push_back(std::to_string(k + 1));
  }

  Spots& spots() { return m_spots; }

  void read() {
    if (!m_findings.good()) return; // of signs
    const std::vector<std::size_t> movies = group_columns();
    std::map<std::string, std::set<std::string>> groups;  // in which an id occurs
    std::vector<std::pair<std::string, std::string>> ids; // group and id of each row that has a track
    std::vector<const SheetRow*> rows;
    for (const SheetRow& row : m_table.rows) {
      if (!is_whole(row)) continue;
      const std::string id = id_text(row.fields[*m_table.track]);
      if (is_no_track(id)) {
        ++m_loose;
        m_no_tracks.insert(id.empty() ? "empty" : id);
        continue;
      }
      std::string group;
      for (const std::size_t c : movies) group += field(row, c) + "/";
      groups[id].insert(group);
      ids.emplace_back(std::move(group), id);
      rows.push_back(&row);
    }
    const bool repeat = std::ranges::any_of(groups, [](const auto& one) { return one.second.size() > 1; });
    for (std::size_t i = 0; i < rows.size(); ++i) add(*rows[i], repeat ? ids[i].first + ids[i].second : ids[i].second);
    put_in_order();
    look_at_twins();
    tell(repeat, movies);
    finish(repeat ? movies : std::vector<std::size_t>{});
  }

  /// Columns that tell movies apart whatever their names: where their values change along tracks, all tracks leap, and
  /// each time has one value. Or the file that was joined, if an id is in two places at one time within several.
  std::vector<std::size_t> movie_columns() {
    std::vector<std::size_t> found;
    if (!m_options.columns.group.empty() || !m_findings.good()) return found;
    const std::vector<std::size_t> ends = ends_of_steps();
    std::vector<double> gaps;
    for (const std::size_t i : ends) gaps.push_back(time_of(m_spots.spots[i]) - time_of(m_spots.spots[i - 1]));
    const double interval = gaps.empty() ? 1.0 : statistics::quantile(gaps, 0.5);
    std::vector<Step> steps;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const Spot &a = m_spots.spots[ends[i] - 1], &b = m_spots.spots[ends[i]];
      steps.push_back({.dx = b.x - a.x, .dy = b.y - a.y, .gap = std::max(1.0, gaps[i] / interval)});
    }
    const double usual = usual_step(steps);
    std::set<std::size_t> told; // steps that lead to another movie
    for (const std::size_t c : free_columns()) {
      std::vector<std::size_t> changes;
      std::vector<Step> changing;
      for (std::size_t i = 0; i < ends.size() && 4 * changes.size() <= ends.size(); ++i)
        if (field(*m_spots.spots[ends[i] - 1].row, c) != field(*m_spots.spots[ends[i]].row, c)) {
          changes.push_back(i);
          changing.push_back(steps[i]);
        }
      if (4 * changes.size() > ends.size() || std::ranges::includes(told, changes)
          || together(changing, usual, true) != Together::leaps || !is_of_time(c))
        continue;
      found.push_back(c);
      told.insert(changes.begin(), changes.end());
    }
    if (found.empty()) look_at_collisions(found);
    return found;
  }

private:
  bool is_part(Table::Column column) const {
    return m_table.parts > 1 && !m_table.header.empty() && column == m_table.header.size();
  }

  double time_of(const Spot& spot) const { return m_table.frame ? spot.frame : spot.t; }

  /// Spots in the order of tracks and times. Rows that say the same of one track at one time count once.
  void put_in_order() {
    const auto key = [this](const Spot& s) { return std::tuple(s.track, time_of(s), s.t, s.x, s.y); };
    std::ranges::stable_sort(m_spots.spots, {}, key);
    std::vector<Spot>& spots = m_spots.spots;
    const auto doubles =
        std::unique(spots.begin(), spots.end(), [&](const Spot& a, const Spot& b) { return key(a) == key(b); });
    if (doubles == spots.end()) return;
    const auto many = spots.end() - doubles;
    m_findings.note(many == 1 ? "1 row stands there twice, and counts once"
                              : fmt::format("{} rows stand there twice, and count once", many));
    spots.erase(doubles, spots.end());
  }

  /// Spots to which a step leads.
  std::vector<std::size_t> ends_of_steps() const {
    std::vector<std::size_t> ends;
    for (std::size_t i = 1; i < m_spots.spots.size(); ++i)
      if (const Spot& a = m_spots.spots[i - 1], &b = m_spots.spots[i]; a.track == b.track && time_of(b) > time_of(a))
        ends.push_back(i);
    return ends;
  }

  /// Columns that nothing is read from.
  std::vector<std::size_t> free_columns() const {
    std::vector<std::size_t> columns;
    const std::array used{m_table.track, m_table.t,       m_table.frame,    m_table.x,   m_table.y,
                          m_table.z,     m_table.made_up, m_table.measured, m_table.unit};
    for (std::size_t c = 0; c < m_table.header.size() + (m_table.parts > 1 ? 1 : 0); ++c)
      if (std::ranges::find(used, Table::Column(c)) == used.end()) columns.push_back(c);
    return columns;
  }

  /// Whether each time has one value of a column.
  bool is_of_time(std::size_t column) const {
    std::map<double, const std::string*> values;
    return std::ranges::all_of(m_spots.spots, [&](const Spot& spot) {
      const std::string& value = field(*spot.row, column);
      return *values.emplace(time_of(spot), &value).first->second == value;
    });
  }

  /// If an id is in two places at one time: the column that tells them apart.
  void look_at_collisions(std::vector<std::size_t>& found) {
    const auto place = [this](const Spot& s) { return std::pair(s.track, time_of(s)); };
    if (std::ranges::adjacent_find(m_spots.spots, {}, place) == m_spots.spots.end()) return;
    for (const std::size_t c : free_columns()) {
      std::set<std::tuple<std::size_t, std::string_view, double>> apart;
      std::set<std::pair<std::size_t, std::string_view>> tracks;
      const bool tells = std::ranges::all_of(m_spots.spots, [&](const Spot& spot) {
        const std::string& value = field(*spot.row, c);
        tracks.emplace(spot.track, value);
        return apart.emplace(spot.track, value, time_of(spot)).second;
      });
      if (!tells || 3 * tracks.size() > m_spots.spots.size()) continue;
      if (is_part(c))
        found.push_back(c);
      else
        m_spots.apart = m_table.name(c);
      return;
    }
  }

  const std::string& field(const SheetRow& row, Table::Column column) const {
    return is_part(column) ? m_parts.at(row.part) : row.field(column);
  }

  /// A row has as many fields as the header; empty ones at its end do not count.
  bool is_whole(const SheetRow& row) {
    const std::size_t wanted = m_table.header.empty() ? m_table.rows.front().fields.size() : m_table.header.size();
    std::size_t least = wanted;
    while (least > 0 && !m_table.header.empty() && m_table.header[least - 1].empty()) --least;
    std::size_t fields = row.fields.size();
    while (fields > wanted && row.fields[fields - 1].empty()) --fields;
    if (row.open_quote) {
      m_findings.fault(row.line, "has a quote that is not closed");
    } else if (fields < least || fields > wanted) {
      const bool commas = m_table.separator == ',' && fields > wanted;
      m_findings.fault(row.line, "has {} fields, the header {}{}", fields, wanted,
                       commas ? ": if commas are decimal signs, save it with semicolons or tabs between columns, or "
                                "with points in numbers"
                              : "");
    } else {
      return has_columns(row);
    }
    return false;
  }

  /// Of a table without header the caller may name columns that are not there.
  bool has_columns(const SheetRow& row) {
    std::vector<Table::Column> used{m_table.track, m_table.t,       m_table.frame,   m_table.x,
                                    m_table.y,     m_table.made_up, m_table.measured};
    used.insert(used.end(), m_table.group.begin(), m_table.group.end());
    for (const Table::Column c : used)
      if (c && *c >= row.fields.size() && !is_part(c)) {
        m_findings.fault(row.line, "has {} fields; there is no column {}", row.fields.size(), *c + 1);
        return false;
      }
    return true;
  }

  /// The columns that tell movies apart. One whose every value stands at one time alone names pictures, not movies.
  std::vector<std::size_t> group_columns() const {
    std::vector<std::size_t> columns;
    const Table::Column time = m_table.frame ? m_table.frame : m_table.t;
    for (const std::size_t c : m_table.group) {
      std::map<std::string, std::string> first;
      bool one_time = true;
      for (const SheetRow& row : m_table.rows) {
        const auto [at, added] = first.emplace(field(row, c), field(row, time));
        one_time = one_time && at->second == field(row, time);
      }
      if (first.size() > 1 && !one_time) columns.push_back(c);
    }
    return columns;
  }

  std::optional<double> value(const SheetRow& row, Table::Column column) const {
    const std::string& text = field(row, column);
    return m_clock.runs && column == m_table.t ? clock_time(text, m_clock) : number_of(text, m_signs);
  }

  std::optional<double> number(const SheetRow& row, Table::Column column) {
    const auto found = value(row, column);
    if (!found)
      m_findings.fault(row.line, "{}: \"{}\" is no {}{}", m_table.name(column), excerpt(field(row, column)),
                       m_clock.runs && column == m_table.t ? "time of the clock, as others are" : "finite number",
                       has_thousands_sign(field(row, column)) ? ": leave out what separates its thousands" : "");
    return found;
  }

  /// A second column of the same meaning: a note if it says the same, a fault if it does not.
  void look_at_twins() {
    const ColumnNames& own = m_options.columns;
    const std::tuple<const char*, const std::string*, Table::Column> roles[] = {{"t", &own.t, m_table.t},
                                                                                {"frame", &own.frame, m_table.frame},
                                                                                {"x", &own.x, m_table.x},
                                                                                {"y", &own.y, m_table.y}};
    for (const auto& [key, named, column] : roles) {
      if (!column || !named->empty() || m_table.header.empty()) continue;
      const ColumnTitle title = column_title(m_table.name(column));
      for (std::size_t c = 0; c < m_table.header.size(); ++c) {
        const ColumnTitle other = column_title(m_table.header[c]);
        const auto size = time_unit(title.unit), other_size = time_unit(other.unit);
        const bool time = column == m_table.t && size && other_size && names_time(other.name);
        if (c == *column || !(time || (title.name == other.name && title.unit == other.unit))) continue;
        compare(key, *column, c, time ? *other_size / *size : 1.0);
      }
    }
  }

  /// @param scale  of the other column, in the unit of the first
  void compare(const char* key, std::size_t column, std::size_t other, double scale) {
    constexpr double same = 0.05; // of the range
    std::optional<std::pair<double, double>> first;
    double range = 0.0, worst = 0.0;
    const SheetRow* where = nullptr;
    for (const SheetRow& row : m_table.rows) {
      const auto a = value(row, column), b = number_of(field(row, other), m_signs);
      if (!a || !b) continue;
      if (!first) first = {*a, scale * *b};
      range = std::max(range, std::abs(*a - first->first));
      if (const double off = std::abs((*a - first->first) - (scale * *b - first->second)); off > worst) {
        worst = off;
        where = &row;
      }
    }
    const std::string name = m_table.name(column), second = m_table.name(other);
    const std::string both = name == second ? name + " stands there twice" : name + " and " + second;
    if (where != nullptr && worst > same * range)
      m_findings.fault(
          where->line, "{}{} contradict each other, {} and {}: name the right one, {}", both,
          name == second ? ", and the two" : "", field(*where, column), field(*where, other),
          m_options.say("columns", fmt::format("{}={}", key, name == second ? std::to_string(column + 1) : name)));
    else if (first)
      m_findings.note("{}{} say the same", both, name == second ? "; both" : "");
  }

  /// @return false if a tracker has made the position of this row up
  bool is_seen(const SheetRow& row) {
    for (const auto& [column, seen] : {std::pair(m_table.made_up, false), std::pair(m_table.measured, true)}) {
      if (!column) continue;
      const auto value = truth(field(row, column));
      if (!value)
        m_findings.fault(row.line, "{}: \"{}\" is neither true nor false", m_table.name(column),
                         excerpt(field(row, column)));
      if (value.value_or(seen) != seen) return false;
    }
    return true;
  }

  void add(const SheetRow& row, const std::string& name) {
    if (!is_seen(row)) {
      ++m_spots.made_up;
      return;
    }
    if (says_nothing(field(row, m_table.x)) || says_nothing(field(row, m_table.y))) {
      ++m_spots.nowhere;
      return;
    }
    const auto x = number(row, m_table.x), y = number(row, m_table.y);
    const auto t = m_table.t ? number(row, m_table.t) : 0.0;
    const auto frame = m_table.frame ? number(row, m_table.frame) : 0.0;
    if (frame && *frame != std::round(*frame))
      m_findings.fault(row.line, "{}: {} is no whole number, as frames have", m_table.name(m_table.frame), *frame);
    find_unit(row);
    if (m_table.z) m_heights.insert(field(row, m_table.z));
    if (!x || !y || !t || !frame) return;
    const auto [own, added] = m_numbers.emplace(name, m_spots.names.size());
    if (added) {
      m_spots.names.push_back(name);
      m_last.push_back(*t);
    }
    if (m_clock.runs && m_clock.origin == 0.0 && *t < m_last[own->second] - half_a_day)
      m_findings.fault(row.line, "{}: times of the clock go over midnight: write them with the date",
                       m_table.name(m_table.t));
    m_last[own->second] = *t;
    const std::string& time = field(row, m_table.t);
    if (const std::size_t sign = time.find(m_signs.decimal); sign != std::string::npos)
      m_decimals = std::max(m_decimals, time.size() - sign - 1);
    m_spots.spots.push_back(
        {.track = own->second, .t = *t, .frame = *frame, .x = *x, .y = *y, .line = row.line, .row = &row});
  }

  /// Imaris and this program state units in each row.
  void find_unit(const SheetRow& row) {
    for (const auto& [column, own] :
         {std::pair(m_table.unit, &m_spots.length_unit), std::pair(m_table.time_unit, &m_spots.time_unit)}) {
      if (!column) continue;
      const std::string& unit = field(row, column);
      if (own->empty()) *own = unit;
      if (unit != *own) m_findings.fault(row.line, "is in {}, rows before it in {}", excerpt(unit), excerpt(*own));
    }
  }

  void tell(bool repeat, const std::vector<std::size_t>& movies) {
    if (m_loose > 0)
      m_findings.note("{} in no track (id {}) {} left out", counted(m_loose, "position"),
                      excerpt(fmt::format("{}", fmt::join(m_no_tracks, ", ")), 40), m_loose == 1 ? "is" : "are");
    if (m_heights.size() > 1) m_findings.note("z is left out: read-outs are of the projection on the plane");
    if (m_spots.made_up > 0)
      m_findings.note("{} that the tracker made up ({}) are missing positions", counted(m_spots.made_up, "position"),
                      m_table.name(m_table.made_up ? m_table.made_up : m_table.measured));
    if (m_spots.nowhere > 0)
      m_findings.note("{} without a position are missing positions", counted(m_spots.nowhere, "row"));
    if (repeat) m_findings.note("ids repeat: tracks are kept apart by {}", fmt::join(names(movies), ", "));
    if (m_table.x_unit != m_table.y_unit)
      m_findings.fault(0, "{} is in {}, {} in {}", m_table.name(m_table.x),
                       m_table.x_unit.empty() ? "no unit" : m_table.x_unit, m_table.name(m_table.y),
                       m_table.y_unit.empty() ? "no unit" : m_table.y_unit);
  }

  std::vector<std::string> names(const std::vector<std::size_t>& columns) const {
    std::vector<std::string> list;
    for (const std::size_t c : columns) list.push_back(m_table.name(c));
    return list;
  }

  void finish(const std::vector<std::size_t>& movies) {
    m_spots.layout = m_table.layout;
    m_spots.separator = m_table.separator;
    m_spots.decimal_comma = m_signs.decimal == ',';
    if (m_spots.length_unit.empty()) m_spots.length_unit = m_table.x_unit;
    if (m_table.t && !m_clock.runs) m_spots.t_digit = std::pow(10.0, -static_cast<double>(m_decimals));
    if (m_clock.runs) m_spots.time_unit = "s";
    if (m_spots.time_unit.empty()) m_spots.time_unit = m_table.t_unit;
    const auto name = [this](Table::Column column) { return m_table.name(column); };
    m_spots.columns = {.track = name(m_table.track),
                       .t = name(m_table.t),
                       .frame = name(m_table.frame),
                       .x = name(m_table.x),
                       .y = name(m_table.y),
                       .z = {},
                       .group = names(movies),
                       .made_up = name(m_table.made_up),
                       .measured = name(m_table.measured)};
  }

  const Table& m_table;
  const TrackOptions& m_options;
  Findings& m_findings;
  NumberSigns m_signs;
  Clock m_clock;
  Spots m_spots;
  std::vector<std::string> m_parts;             ///< names of the files that were joined
  std::map<std::string, std::size_t> m_numbers; ///< of tracks, by their names
  std::vector<double> m_last;                   ///< time of each track so far
  std::set<std::string> m_heights;
  std::set<std::string> m_no_tracks; ///< ids
  std::size_t m_loose = 0;
  std::size_t m_decimals = 0; ///< of times
};

} // namespace

Spots table_spots(std::string_view text, const TrackOptions& options, Findings& findings) {
  std::optional<Table> table = find_table(text, options, findings);
  if (!table) return {};
  if (table->rows.empty()) {
    findings.fault(0, "has a header, but no rows");
    return {};
  }
  for (const Table::Column c : {table->x, table->y})
    if (const std::string name = column_title(table->name(c)).name; holds_steps(name))
      findings.fault(0, "{} holds steps, and no positions", table->name(c));
  const Findings before = findings;
  SpotReader reader(*table, options, findings);
  reader.read();
  const std::vector<std::size_t> movies = reader.movie_columns();
  if (movies.empty()) return std::move(reader.spots());
  findings = before;
  table->group.insert(table->group.end(), movies.begin(), movies.end());
  SpotReader apart(*table, options, findings);
  apart.read();
  return std::move(apart.spots());
}

} // namespace matrigrate::tracks
