#include "fields/formula_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <span>

namespace matrigrate::fields {

namespace {

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
    std::size_t k = 0;
    const auto digits = [&] {
      while (k < m_text.size() && is_decimal(m_text[k])) ++k;
    };
    digits();
    if (k < m_text.size() && m_text[k] == '.') {
      ++k;
      digits();
    }
    std::size_t exponent = k + 1;
    if (k < m_text.size() && (m_text[k] == 'e' || m_text[k] == 'E')) {
      if (exponent < m_text.size() && (m_text[exponent] == '+' || m_text[exponent] == '-')) ++exponent;
      if (exponent < m_text.size() && is_decimal(m_text[exponent])) {
        k = exponent;
        digits();
      }
    }
    return k;
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

} // namespace

std::vector<Word> formula_words(std::string_view text) { return Scanner(text).words(); }

std::string_view way_to_write(std::string_view name) {
  const auto* way = std::ranges::find(ways, name, &Spelling::typed);
  return way == std::end(ways) ? std::string_view() : way->here;
}

std::string name_here(std::string_view name) {
  for (const std::string_view library : {"np.", "numpy.", "math.", "Math."})
    if (name.starts_with(library)) name.remove_prefix(library.size());
  const auto* other = std::ranges::find(other_names, name, &Spelling::typed);
  return std::string(other == std::end(other_names) ? name : other->here);
}

} // namespace matrigrate::fields
