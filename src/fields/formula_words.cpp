#include "fields/formula_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace matrigrate::fields {

namespace {

/// What stands for what.
struct Spelling {
  std::string_view typed;
  std::string_view here;
};

constexpr std::array signs{
    Spelling{"**", "^"}, Spelling{"==", "=="}, Spelling{"!=", "!="}, Spelling{"<=", "<="}, Spelling{">=", ">="},
    Spelling{"&&", "&&"}, Spelling{"||", "||"}, Spelling{"+", "+"}, Spelling{"-", "-"}, Spelling{"*", "*"},
    Spelling{"/", "/"}, Spelling{"^", "^"}, Spelling{"<", "<"}, Spelling{">", ">"}, Spelling{"!", "!"},
    Spelling{"?", "?"}, Spelling{":", ":"}, Spelling{"(", "("}, Spelling{")", ")"}, Spelling{",", ","},
    // as text processors set them
    Spelling{"\u2212", "-"}, Spelling{"\u2013", "-"}, Spelling{"\u2010", "-"}, Spelling{"\u2011", "-"},
    Spelling{"\u00b7", "*"}, Spelling{"\u22c5", "*"}, Spelling{"\u2219", "*"}, Spelling{"\u00d7", "*"},
    Spelling{"\u2217", "*"}, Spelling{"\u00f7", "/"}, Spelling{"\u2215", "/"}, Spelling{"\u2044", "/"},
    Spelling{"\u2264", "<="}, Spelling{"\u2265", ">="}, Spelling{"\u2260", "!="}, Spelling{"\u2227", "&&"},
    Spelling{"\u2228", "||"}, Spelling{"\u00ac", "!"}};

constexpr std::array blanks{" ", "\t", "\n", "\r", "\u00a0", "\u2009", "\u202f", "\u2002", "\u2003", "\u200a"};

constexpr std::array superscripts{Spelling{"\u2070", "0"}, Spelling{"\u00b9", "1"}, Spelling{"\u00b2", "2"},
                                  Spelling{"\u00b3", "3"}, Spelling{"\u2074", "4"}, Spelling{"\u2075", "5"},
                                  Spelling{"\u2076", "6"}, Spelling{"\u2077", "7"}, Spelling{"\u2078", "8"},
                                  Spelling{"\u2079", "9"}, Spelling{"\u207b", "-"}};

/// Signs that no formula has, and what to write.
constexpr std::array strangers{
    Spelling{"<>", "write != for unequal"},
    Spelling{"%", "write mod(a, b) for the rest of a/b, which has the sign of b, and 0.5 for 50 %"},
    Spelling{"&", "write && for and"},
    Spelling{"|", "write || for or"},
    Spelling{"=", "= would set a value; write == to compare"},
    Spelling{"[", "write parentheses ( )"},
    Spelling{"]", "write parentheses ( )"},
    Spelling{"{", "write parentheses ( )"},
    Spelling{"}", "write parentheses ( )"},
    Spelling{";", "a formula has one value; a comma stands between the arguments of a function"},
    Spelling{"~", "write ! for not"},
    Spelling{"\u221a", "write sqrt( )"},
    Spelling{"\u221e", "a formula has no infinity"}};

constexpr std::array other_names{
    Spelling{"pi", "_pi"},        Spelling{"PI", "_pi"},      Spelling{"\u03c0", "_pi"},  Spelling{"true", "1"},
    Spelling{"True", "1"},        Spelling{"false", "0"},     Spelling{"False", "0"},     Spelling{"fabs", "abs"},
    Spelling{"ceiling", "ceil"},  Spelling{"arcsin", "asin"}, Spelling{"arccos", "acos"}, Spelling{"arctan", "atan"},
    Spelling{"arctan2", "atan2"}, Spelling{"fmin", "min"},    Spelling{"fmax", "max"},    Spelling{"power", "pow"},
    Spelling{"ifelse", "if"},     Spelling{"iif", "if"},      Spelling{"where", "if"}};

constexpr std::array ways{Spelling{"e", "write exp(a) for e^a, _e for the number"},
                          Spelling{"heaviside", "write a > 0 ? 1 : 0"},
                          Spelling{"step", "write a > 0 ? 1 : 0"},
                          Spelling{"sqr", "write a^2"},
                          Spelling{"square", "write a^2"},
                          Spelling{"round", "write floor(a + 0.5)"},
                          Spelling{"trunc", "write floor(a) or ceil(a)"},
                          Spelling{"int", "write floor(a) or ceil(a)"},
                          Spelling{"fmod", "write mod(a, b), which has the sign of b"},
                          Spelling{"rem", "write mod(a, b), which has the sign of b"},
                          Spelling{"lg", "write log10(a)"},
                          Spelling{"LOG", "write log10(a) of the decimal logarithm, ln(a) of the natural one"},
                          Spelling{"cot", "write 1/tan(a)"},
                          Spelling{"sec", "write 1/cos(a)"},
                          Spelling{"csc", "write 1/sin(a)"},
                          Spelling{"xor", "write (a) != (b) of two comparisons"},
                          Spelling{"mean", "write avg(a, b)"},
                          Spelling{"rand", "a formula has no random numbers"},
                          Spelling{"random", "a formula has no random numbers"},
                          Spelling{"else", "write c ? a : b"},
                          Spelling{"then", "write c ? a : b"}};

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

  template <class Spellings>
  const Spelling* found(const Spellings& spellings) const {
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
  const auto way = std::ranges::find(ways, name, &Spelling::typed);
  return way == ways.end() ? std::string_view() : way->here;
}

std::string name_here(std::string_view name) {
  for (const std::string_view library : {"np.", "numpy.", "math.", "Math."})
    if (name.starts_with(library)) name.remove_prefix(library.size());
  const auto other = std::ranges::find(other_names, name, &Spelling::typed);
  return std::string(other == other_names.end() ? name : other->here);
}

} // namespace matrigrate::fields
