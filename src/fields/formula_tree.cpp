#include "fields/formula_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <optional>
#include <span>

namespace matrigrate::fields {

namespace {

/// A word of a formula, in the spelling of this program.
struct Word {
  enum class Kind { number, name, sign, end };

  Kind kind = Kind::end;
  std::string text;   ///< "0.5", "F", "<=", "("
  std::size_t at = 0; ///< its first character, from 1
  bool follows_blank = false;
};

/// What stands for what.
struct Spelling {
  std::string_view typed;
  std::string_view here;
};

/// Also as text processors set them.
constexpr Spelling signs[]{{"**", "^"},      {"==", "=="},     {"!=", "!="},     {"<=", "<="},     {">=", ">="},
                           {"&&", "&&"},     {"||", "||"},     {"+", "+"},       {"-", "-"},       {"*", "*"},
                           {"/", "/"},       {"^", "^"},       {"<", "<"},       {">", ">"},       {"!", "!"},
                           {"?", "?"},       {":", ":"},       {"(", "("},       {")", ")"},       {",", ","},
                           {"\u2212", "-"},  {"\u2013", "-"},  {"\u2010", "-"},  {"\u2011", "-"},  {"\u00b7", "*"},
                           {"\u22c5", "*"},  {"\u2219", "*"},  {"\u00d7", "*"},  {"\u2217", "*"},  {"\u00f7", "/"},
                           {"\u2215", "/"},  {"\u2044", "/"},  {"\u2264", "<="}, {"\u2265", ">="}, {"\u2260", "!="},
                           {"\u2227", "&&"}, {"\u2228", "||"}, {"\u00ac", "!"}};

constexpr std::array blanks{" ", "\t", "\n", "\r", "\u00a0", "\u2009", "\u202f", "\u2002", "\u2003", "\u200a"};

constexpr Spelling superscripts[]{{"\u2070", "0"}, {"\u00b9", "1"}, {"\u00b2", "2"}, {"\u00b3", "3"},
                                  {"\u2074", "4"}, {"\u2075", "5"}, {"\u2076", "6"}, {"\u2077", "7"},
                                  {"\u2078", "8"}, {"\u2079", "9"}, {"\u207b", "-"}};

/// Signs that no formula has, and what to write.
constexpr Spelling strangers[]{{"<>", "write != for unequal"},
                               {"%", "write mod(a, b) for the rest of a/b, which has the sign of b, and 0.5 for 50 %"},
                               {"&", "write && for and"},
                               {"|", "write || for or"},
                               {"=", "= would set a value; write == to compare"},
                               {"[", "write parentheses ( )"},
                               {"]", "write parentheses ( )"},
                               {"{", "write parentheses ( )"},
                               {"}", "write parentheses ( )"},
                               {";", "a formula has one value; a comma stands between the arguments of a function"},
                               {"~", "write ! for not"},
                               {"\u221a", "write sqrt( )"},
                               {"\u221e", "a formula has no infinity"}};

constexpr Spelling other_names[]{{"pi", "_pi"},        {"PI", "_pi"},      {"\u03c0", "_pi"},  {"true", "1"},
                                 {"True", "1"},        {"false", "0"},     {"False", "0"},     {"fabs", "abs"},
                                 {"ceiling", "ceil"},  {"arcsin", "asin"}, {"arccos", "acos"}, {"arctan", "atan"},
                                 {"arctan2", "atan2"}, {"fmin", "min"},    {"fmax", "max"},    {"power", "pow"},
                                 {"ifelse", "if"},     {"iif", "if"},      {"where", "if"}};

constexpr Spelling ways[]{{"e", "write exp(a) for e^a, _e for the number"},
                          {"heaviside", "write a > 0 ? 1 : 0"},
                          {"step", "write a > 0 ? 1 : 0"},
                          {"sqr", "write a^2"},
                          {"square", "write a^2"},
                          {"round", "write floor(a + 0.5)"},
                          {"trunc", "write floor(a) or ceil(a)"},
                          {"int", "write floor(a) or ceil(a)"},
                          {"fmod", "write mod(a, b), which has the sign of b"},
                          {"rem", "write mod(a, b), which has the sign of b"},
                          {"lg", "write log10(a)"},
                          {"LOG", "write log10(a) of the decimal logarithm, ln(a) of the natural one"},
                          {"cot", "write 1/tan(a)"},
                          {"sec", "write 1/cos(a)"},
                          {"csc", "write 1/sin(a)"},
                          {"xor", "write (a) != (b) of two comparisons"},
                          {"mean", "write avg(a, b)"},
                          {"rand", "a formula has no random numbers"},
                          {"random", "a formula has no random numbers"},
                          {"else", "write c ? a : b"},
                          {"then", "write c ? a : b"}};

bool is_decimal(char c) { return c >= '0' && c <= '9'; }
bool is_ascii_letter(char c) { return c == '_' || std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool begins_character(char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U; }

/// Reads a text from left to right.
class Scanner {
public:
  explicit Scanner(std::string_view text) : m_text(text) {}

  /// The words of the text, and one of kind end.
  /// @throws FormulaFault at a character that belongs to no formula
  std::vector<Word> words() {
    while (true) {
      const bool blank = skip_blanks();
      if (m_text.empty()) break;
      const std::size_t before = m_words.size();
      next();
      m_words[before].follows_blank = blank;
    }
    m_words.push_back({Word::Kind::end, {}, m_at, false});
    return std::move(m_words);
  }

private:
  /// Takes a piece of this many bytes.
  std::string take(std::size_t bytes) {
    const std::string_view piece = m_text.substr(0, bytes);
    m_at += static_cast<std::size_t>(std::ranges::count_if(piece, begins_character));
    m_text.remove_prefix(piece.size());
    return std::string(piece);
  }

  bool skip_blanks() {
    bool any = false;
    for (auto blank = blanks.begin(); blank != blanks.end();)
      if (m_text.starts_with(*blank)) {
        take(std::string_view(*blank).size());
        any = true;
        blank = blanks.begin();
      } else {
        ++blank;
      }
    return any;
  }

  std::size_t bytes_of_character() const {
    std::size_t bytes = 1;
    while (bytes < m_text.size() && !begins_character(m_text[bytes])) ++bytes;
    return bytes;
  }

  const Spelling* found(std::span<const Spelling> spellings) const {
    const auto it = std::ranges::find_if(spellings, [&](const Spelling& s) { return m_text.starts_with(s.typed); });
    return it == spellings.end() ? nullptr : &*it;
  }

  void add(Word::Kind kind, std::string text, std::size_t at) { m_words.push_back({kind, std::move(text), at, false}); }

  void next() {
    const std::size_t at = m_at;
    const char c = m_text.front();
    if (is_decimal(c) || (c == '.' && m_text.size() > 1 && is_decimal(m_text[1])))
      return add(Word::Kind::number, take(bytes_of_number()), at);
    if (found(superscripts) != nullptr) return power(at);
    if (m_text.starts_with("<>")) refuse(*found(strangers));
    if (const Spelling* sign = found(signs)) {
      take(sign->typed.size());
      return add(Word::Kind::sign, std::string(sign->here), at);
    }
    if (const Spelling* stranger = found(strangers)) refuse(*stranger);
    if (const std::size_t bytes = bytes_of_name(); bytes > 0) return add(Word::Kind::name, take(bytes), at);
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      throw FormulaFault(m_at, fmt::format("a control character, U+{:04X}, is no text", static_cast<unsigned char>(c)));
    throw FormulaFault(m_at, fmt::format("{} belongs to no formula", m_text.substr(0, bytes_of_character())));
  }

  [[noreturn]] void refuse(const Spelling& stranger) const { throw FormulaFault(m_at, std::string(stranger.here)); }

  std::size_t bytes_of_number() const {
    double number = 0.0; // an e without digits behind it is no exponent
    const char* const end = std::from_chars(m_text.data(), m_text.data() + m_text.size(), number).ptr;
    return static_cast<std::size_t>(end - m_text.data());
  }

  /// Letters of any alphabet, digits, and points between letters, as in np.exp.
  std::size_t bytes_of_name() const {
    std::size_t k = 0;
    while (k < m_text.size()) {
      const char c = m_text[k];
      const Scanner rest{m_text.substr(k)};
      const bool other = static_cast<unsigned char>(c) >= 0x80 && rest.found(signs) == nullptr
                         && rest.found(strangers) == nullptr && rest.found(superscripts) == nullptr
                         && std::ranges::none_of(blanks, [&](const char* b) { return rest.m_text.starts_with(b); });
      const bool point = k > 0 && c == '.' && k + 1 < m_text.size() && is_ascii_letter(m_text[k + 1]);
      if (!is_ascii_letter(c) && !other && !point && (k == 0 || !is_decimal(c))) return k;
      k += other ? rest.bytes_of_character() : 1;
    }
    return k;
  }

  /// x² as x^2.
  void power(std::size_t at) {
    add(Word::Kind::sign, "^", at);
    std::string number;
    while (const Spelling* digit = found(superscripts)) {
      take(digit->typed.size());
      if (digit->here != "-")
        number += digit->here;
      else if (number.empty() && m_words.back().text == "^")
        add(Word::Kind::sign, "-", at);
    }
    if (number.empty()) throw FormulaFault(at, "a raised minus needs a raised digit; write ^-1");
    add(Word::Kind::number, number, at);
  }

  std::string_view m_text;
  std::size_t m_at = 1;
  std::vector<Word> m_words;
};

/// How to write what other programs know by a name; empty if nothing is known of it.
std::string_view way_to_write(std::string_view name) {
  const auto* way = std::ranges::find(ways, name, &Spelling::typed);
  return way == std::end(ways) ? std::string_view() : way->here;
}

/// The name here of what other programs call otherwise: "asin" of arcsin and np.arcsin, "_pi" of pi; else the name
/// itself.
std::string name_here(std::string_view name) {
  for (const std::string_view library : {"np.", "numpy.", "math.", "Math."})
    if (name.starts_with(library)) name.remove_prefix(library.size());
  const auto* other = std::ranges::find(other_names, name, &Spelling::typed);
  return std::string(other == std::end(other_names) ? name : other->here);
}

// How tightly signs bind; those of a row from the left, except ^.
constexpr int of_choice = 0;
constexpr int of_comparison = 3;
constexpr int of_sign = 5; // as * and /: -a^2 is -(a^2)
constexpr int of_power = 6;
constexpr int of_operand = 7;

struct Infix {
  std::string_view text;
  int binds;
};

constexpr std::array infixes{Infix{"||", 1}, Infix{"&&", 2}, Infix{"==", 3},      Infix{"!=", 3}, Infix{"<=", 3},
                             Infix{">=", 3}, Infix{"<", 3},  Infix{">", 3},       Infix{"+", 4},  Infix{"-", 4},
                             Infix{"*", 5},  Infix{"/", 5},  Infix{"^", of_power}};

/// 0 of no infix.
int binds(std::string_view sign) {
  const auto infix = std::ranges::find(infixes, sign, &Infix::text);
  return infix == infixes.end() ? 0 : infix->binds;
}

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

template <class... Parts>
Part made(Part::Kind kind, std::string text, std::size_t at, Parts... of) {
  Part part{kind, std::move(text), at, {}};
  (part.parts.push_back(std::move(of)), ...);
  return part;
}

/// Reads words by recursive descent.
class Parser {
public:
  Parser(std::string_view text, const FormulaNames& names) : m_words(Scanner(text).words()), m_names(names) {}

  FormulaTree tree() {
    Part whole = choice();
    if (!at_end()) refuse_what_follows();
    return {std::move(whole), std::move(m_chained)};
  }

private:
  const Word& word() const { return m_words[m_next]; }
  bool at_end() const { return word().kind == Word::Kind::end; }
  bool is_sign(std::string_view text) const { return word().kind == Word::Kind::sign && word().text == text; }

  /// Whether the word is one of a language, such as "and", that is no name here.
  bool is_keyword(std::string_view text) const {
    return word().kind == Word::Kind::name && lower(word().text) == text && !m_names.is_number(word().text);
  }

  bool take(std::string_view sign) {
    if (!is_sign(sign)) return false;
    ++m_next;
    return true;
  }

  [[noreturn]] static void refuse(const Word& at, const std::string& why) { throw FormulaFault(at.at, why); }

  std::string shown() const { return at_end() ? "the end of the formula" : word().text; }

  /// The sign of two operands that comes next, if there is one.
  std::optional<std::string> infix() const {
    if (is_keyword("and")) return "&&";
    if (is_keyword("or")) return "||";
    if (word().kind == Word::Kind::sign && binds(word().text) > 0) return word().text;
    return std::nullopt;
  }

  Part choice() {
    Part first = infix_of(1);
    if (!is_sign("?")) return first;
    ++m_next;
    const std::size_t at = first.at;
    Part second = choice();
    if (!take(":")) refuse(word(), fmt::format("a choice is c ? a : b, and here is {} in place of :", shown()));
    return made(Part::Kind::choice, "?", at, std::move(first), std::move(second), choice());
  }

  Part infix_of(int least) {
    constexpr int deepest = 200; // few enough for the stack of any thread, in a browser and under a sanitizer too
    if (++m_depth > deepest) refuse(word(), fmt::format("it is nested deeper than {} times", deepest));
    Part left = operand();
    bool comparison = false; // left is one, without parentheses
    while (const std::optional<std::string> sign = infix()) {
      const int of = binds(*sign);
      if (of < least) break;
      const Word at = word();
      ++m_next;
      Part right = infix_of(of == of_power ? of_power : of + 1);
      if (of == of_comparison && comparison && m_chained.empty()) m_chained = chained(left, at, *sign, right);
      comparison = of == of_comparison;
      const std::size_t begin = left.at;
      left = made(Part::Kind::infix, *sign, begin, std::move(left), std::move(right));
    }
    --m_depth;
    return left;
  }

  /// Why -5 < y < 5 is not what it says.
  static std::string chained(const Part& left, const Word& at, const std::string& sign, const Part& right) {
    const std::string second = written(right);
    return fmt::format(
        "at character {}: {} {} would compare 0 or 1 with {}, since {} is 0 or 1; compare twice: {} && {} {} {}", at.at,
        sign, second, second, written(left), written(left), written(left.parts[1]), sign, second);
  }

  Part operand() {
    const Word at = word();
    if (at.kind == Word::Kind::sign && (at.text == "-" || at.text == "+" || at.text == "!")) {
      ++m_next;
      Part of = infix_of(of_power);
      return at.text == "+" ? of : made(Part::Kind::prefix, at.text, at.at, std::move(of));
    }
    if (is_keyword("not")) {
      ++m_next;
      return made(Part::Kind::prefix, "!", at.at, infix_of(of_comparison));
    }
    if (take("(")) return in_parentheses(at);
    if (at.kind == Word::Kind::number) {
      ++m_next;
      return {Part::Kind::number, at.text, at.at, {}};
    }
    if (at.kind == Word::Kind::name) return name();
    refuse(at, at.kind == Word::Kind::end ? "the formula ends where a value is expected"
                                          : fmt::format("a value is expected, and here is {}", shown()));
  }

  Part in_parentheses(const Word& at) {
    Part part = choice();
    if (is_sign(",")) refuse_comma();
    if (at_end()) refuse(at, "the parenthesis that opens here is never closed");
    if (!take(")")) refuse_what_follows();
    part.at = at.at;
    return part;
  }

  Part name() {
    Word at = word();
    ++m_next;
    const bool called = is_sign("(");
    if (m_names.is_number(at.text) && !(called && m_names.arguments_of(at.text) != 0)) {
      return {Part::Kind::name, at.text, at.at, {}};
    }
    std::string here = name_here(at.text);
    if (called && m_names.arguments_of(here) == 0 && lower(here) != "log") here = name_here(lower(here));
    if (called && (here == "and" || here == "or")) return joined(at, here == "and" ? "&&" : "||");
    if (called && here == "if") return chosen(at, {1, 0, 2});
    if (called && here == "piecewise") return chosen(at, {0, 1, 2});
    if (called && here == "pow") return power(at);
    if (called && m_names.arguments_of(here) != 0) return call(at, here);
    if (here == "0" || here == "1") return {Part::Kind::number, here, at.at, {}};
    if (!called && here != at.text && m_names.is_number(here)) return {Part::Kind::name, here, at.at, {}};
    if (m_names.arguments_of(here) != 0) refuse(at, fmt::format("{} is a function; write {}( )", here, here));
    if (const std::string_view way = way_to_write(here); !way.empty())
      refuse(at, fmt::format("there is no {}; {}", at.text, way));
    throw FormulaFault(at.at, fmt::format("there is no {}", at.text), at.text);
  }

  /// The arguments of a function, with their parentheses.
  std::vector<Part> arguments(const Word& of) {
    const Word open = word();
    if (!take("(")) refuse(of, fmt::format("{} needs its arguments in parentheses", of.text));
    std::vector<Part> all;
    if (take(")")) return all;
    do all.push_back(choice());
    while (take(","));
    if (at_end()) refuse(open, "the parenthesis that opens here is never closed");
    if (!take(")")) refuse_what_follows();
    return all;
  }

  Part call(const Word& at, const std::string& function) {
    Part part{Part::Kind::call, function, at.at, arguments(at)};
    const int takes = m_names.arguments_of(function);
    if (takes < 0 ? part.parts.empty() : part.parts.size() != static_cast<std::size_t>(takes))
      refuse(at, fmt::format("{} takes {}, and here are {}", function,
                             takes < 0    ? "one value or more"
                             : takes == 1 ? "one value"
                                          : fmt::format("{} values", takes),
                             part.parts.size()));
    return part;
  }

  /// and(a, b, ...).
  Part joined(const Word& at, const std::string& sign) {
    std::vector<Part> of = arguments(at);
    if (of.size() < 2) refuse(at, fmt::format("write a {} b", sign));
    Part all = std::move(of.front());
    for (std::size_t k = 1; k < of.size(); ++k)
      all = made(Part::Kind::infix, sign, at.at, std::move(all), std::move(of[k]));
    return all;
  }

  Part power(const Word& at) {
    std::vector<Part> of = arguments(at);
    if (of.size() != 2) refuse(at, "write a^b");
    return {Part::Kind::infix, "^", at.at, std::move(of)};
  }

  /// if(c, a, b), and piecewise(a, c, b) with more pairs.
  /// @param order  where value, condition and what is otherwise stand among three
  Part chosen(const Word& at, const std::array<std::size_t, 3>& order) {
    std::vector<Part> of = arguments(at);
    const bool pairs = order[0] == 0;
    if (pairs ? of.size() < 3 || of.size() % 2 == 0 : of.size() != 3)
      refuse(at, "write c ? a : b, which is a where c holds and b otherwise");
    Part all = std::move(of.back());
    for (std::size_t k = of.size() - 1; k >= 2; k -= 2)
      all = made(Part::Kind::choice, "?", at.at, std::move(of[k - 2 + order[1]]), std::move(of[k - 2 + order[0]]),
                 std::move(all));
    return all;
  }

  /// "200.5" of the comma in "x + 200,5"; empty if it does not stand between digits.
  std::string with_point() const {
    if (m_next == 0 || m_next + 1 >= m_words.size()) return {};
    const Word& before = m_words[m_next - 1];
    const Word& after = m_words[m_next + 1];
    const bool digits = before.kind == Word::Kind::number && after.kind == Word::Kind::number;
    return digits && !word().follows_blank && !after.follows_blank ? fmt::format("{}.{}", before.text, after.text) : "";
  }

  [[noreturn]] void refuse_comma() const {
    const std::string number = with_point();
    refuse(word(), fmt::format("a comma stands outside of a function; {}",
                               number.empty() ? "a formula has one value"
                                              : fmt::format("write {} with a decimal point", number)));
  }

  /// A value is complete, and goes on.
  [[noreturn]] void refuse_what_follows() const {
    const Word& last = m_words[m_next - 1];
    if (is_sign(",")) refuse_comma();
    if (is_sign(")")) refuse(word(), "no parenthesis is open here");
    if (is_sign(":")) refuse(word(), "there is no ? before; a choice is c ? a : b");
    if (is_keyword("if")) refuse(word(), "write c ? a : b, which is a where c holds and b otherwise");
    if (is_sign("(") && last.kind == Word::Kind::name)
      refuse(word(), fmt::format("{} is no function; write {}*( )", last.text, last.text));
    if (word().kind == Word::Kind::sign && word().text != "(")
      refuse(word(), fmt::format("{} is not expected here", word().text));
    refuse(word(), fmt::format("between {} and {} a sign is missing; write {}*{} for their product", last.text,
                               word().text, last.text == ")" ? "( )" : last.text, is_sign("(") ? "( )" : word().text));
  }

  std::vector<Word> m_words;
  const FormulaNames& m_names;
  std::size_t m_next = 0;
  std::string m_chained;
  int m_depth = 0; // of operations within operations
};

int binds(const Part& part) {
  switch (part.kind) {
  case Part::Kind::choice:
    return of_choice;
  case Part::Kind::prefix:
    return of_sign;
  case Part::Kind::infix:
    return binds(part.text);
  default:
    return of_operand;
  }
}

/// Whether a value is 0 or 1.
bool is_truth(const Part& part) {
  return is_comparison(part) || (part.kind == Part::Kind::prefix && part.text == "!")
         || (part.kind == Part::Kind::infix && (part.text == "&&" || part.text == "||"));
}

std::string to_text(const Part& part, bool evaluated);

/// With parentheses if it binds less.
std::string operand_text(const Part& part, int least, bool evaluated) {
  const std::string text = to_text(part, evaluated);
  const bool as_comparison = evaluated && part.kind == Part::Kind::prefix && part.text == "!"; // has parentheses
  return binds(part) < least && !as_comparison ? fmt::format("({})", text) : text;
}

std::string infix_text(const Part& part, bool evaluated) {
  const int of = binds(part.text);
  const Part& left = part.parts[0];
  const Part& right = part.parts[1];
  const bool logic = part.text == "&&" || part.text == "||";
  const auto side = [&](const Part& of_part, int least) {
    if (logic && evaluated && !is_truth(of_part))
      return fmt::format("({} != 0)", operand_text(of_part, of_comparison + 1, true));
    const bool sign = of_part.kind == Part::Kind::prefix && &of_part == &right; // 2^-3, 1 - -x
    return operand_text(of_part, sign ? of_choice : least, evaluated);
  };
  const bool wide = of < of_sign;
  return fmt::format("{}{}{}{}{}", side(left, of == of_power || of == of_comparison ? of + 1 : of), wide ? " " : "",
                     part.text, wide ? " " : "", side(right, of == of_power ? of : of + 1));
}

std::string to_text(const Part& part, bool evaluated) {
  const auto of = [&](std::size_t k, int least) { return operand_text(part.parts[k], least, evaluated); };
  switch (part.kind) {
  case Part::Kind::choice:
    return fmt::format("{} ? {} : {}", of(0, of_choice + 1), of(1, of_choice), of(2, of_choice));
  case Part::Kind::prefix:
    if (evaluated && part.text == "!") return fmt::format("({} == 0)", of(0, of_comparison + 1));
    return part.text + of(0, of_power);
  case Part::Kind::infix:
    return infix_text(part, evaluated);
  case Part::Kind::call: {
    std::string text = part.text + "(";
    for (std::size_t k = 0; k < part.parts.size(); ++k) text += (k == 0 ? "" : ", ") + of(k, of_choice);
    return text + ")";
  }
  default:
    return part.text;
  }
}

} // namespace

FormulaTree formula_tree(std::string_view text, const FormulaNames& names) { return Parser(text, names).tree(); }

std::string written(const Part& part) { return to_text(part, false); }

std::string for_evaluation(const Part& part) { return to_text(part, true); }

bool is_comparison(const Part& part) { return part.kind == Part::Kind::infix && binds(part.text) == of_comparison; }

} // namespace matrigrate::fields
