#pragma once
#pragma GCC system_header // it adds to namespace std

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <iterator>
#include <string>
#include <system_error>
#include <type_traits>
#include <utility>

/// What Emscripten 3.1.6's standard library lacks of C++20, as far as the core uses it: algorithms on ranges, bit_cast
/// and from_chars of decimals. Included before every source of the WebAssembly build, and by nothing else.
namespace std { // NOLINT(cert-dcl58-cpp)

template <class To, class From>
To bit_cast(const From& from) noexcept {
  static_assert(sizeof(To) == sizeof(From));
  To to;
  memcpy(&to, &from, sizeof to);
  return to;
}

/// As that of the standard: no blanks, no plus, no hexadecimal digits; correctly rounded, as strtod of musl is.
template <class Number, enable_if_t<is_floating_point_v<Number>, int> = 0>
from_chars_result from_chars(const char* first, const char* last, Number& value) {
  const string text(first, last);
  const size_t sign = text.starts_with('-') ? 1 : 0;
  const bool number = text.size() > sign
                      && (isdigit(text[sign]) != 0 || text[sign] == '.' || text[sign] == 'i' || text[sign] == 'n'
                          || text[sign] == 'I' || text[sign] == 'N');
  if (!number) return {first, errc::invalid_argument};
  const size_t hexadecimal = text.find_first_of("xX"); // "0x" reads as 0
  const string readable = text.substr(0, hexadecimal);
  char* end = nullptr;
  errno = 0;
  Number read;
  if constexpr (is_same_v<Number, long double>)
    read = strtold(readable.c_str(), &end);
  else
    read = static_cast<Number>(strtod(readable.c_str(), &end));
  if (end == readable.c_str()) return {first, errc::invalid_argument};
  const char* stop = first + (end - readable.c_str());
  if (errno == ERANGE) return {stop, errc::result_out_of_range};
  value = read;
  return {stop, errc()};
}

namespace ranges {

namespace gaps {
/// What `sort` and others compare: the projections of both.
template <class Compare, class Projection>
auto by(Compare& compare, Projection& projection) {
  return [&](const auto& a, const auto& b) -> bool {
    return invoke(compare, invoke(projection, a), invoke(projection, b));
  };
}
} // namespace gaps

template <class Range, class Test>
auto find_if(Range&& range, Test test) {
  auto at = std::begin(range);
  for (const auto end = std::end(range); at != end; ++at)
    if (invoke(test, *at)) break;
  return at;
}

template <class Range, class Value, class Projection = identity>
auto find(Range&& range, const Value& value, Projection projection = {}) {
  return ranges::find_if(range, [&](const auto& one) { return invoke(projection, one) == value; });
}

template <class Range, class Test>
bool any_of(Range&& range, Test test) {
  for (auto&& one : range)
    if (invoke(test, one)) return true;
  return false;
}

template <class Range, class Test>
bool all_of(Range&& range, Test test) {
  return !ranges::any_of(range, [&](auto&& one) { return !invoke(test, one); });
}

template <class Range, class Test>
bool none_of(Range&& range, Test test) {
  return !ranges::any_of(range, test);
}

template <class Range, class Test>
ptrdiff_t count_if(Range&& range, Test test) {
  ptrdiff_t n = 0;
  for (auto&& one : range) n += invoke(test, one) ? 1 : 0;
  return n;
}

template <class Range, class Value>
ptrdiff_t count(Range&& range, const Value& value) {
  return std::count(range.begin(), range.end(), value);
}

template <class Range>
auto adjacent_find(Range&& range) {
  return std::adjacent_find(range.begin(), range.end());
}

template <class Range, class Out, class Make>
void transform(Range&& range, Out out, Make make) {
  std::transform(range.begin(), range.end(), out, make);
}

template <class Range, class Out>
void copy(Range&& range, Out out) {
  std::copy(range.begin(), range.end(), out);
}

template <class Range, class Out, class Test>
void copy_if(Range&& range, Out out, Test test) {
  std::copy_if(range.begin(), range.end(), out, test);
}

template <class Range, class Value>
void fill(Range&& range, const Value& value) {
  std::fill(range.begin(), range.end(), value);
}

template <class A, class B, class Same = std::equal_to<>, class OfA = identity, class OfB = identity>
bool equal(A&& a, B&& b, Same same = {}, OfA of_a = {}, OfB of_b = {}) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](const auto& one, const auto& other) -> bool {
    return invoke(same, invoke(of_a, one), invoke(of_b, other));
  });
}

template <class Range, class Compare = std::less<>, class Projection = identity>
void sort(Range&& range, Compare compare = {}, Projection projection = {}) {
  std::sort(range.begin(), range.end(), gaps::by(compare, projection));
}

template <class Range, class Compare = std::less<>, class Projection = identity>
void stable_sort(Range&& range, Compare compare = {}, Projection projection = {}) {
  std::stable_sort(range.begin(), range.end(), gaps::by(compare, projection));
}

template <class Range, class Value, class Compare = std::less<>, class Projection = identity>
auto lower_bound(Range&& range, const Value& value, Compare compare = {}, Projection projection = {}) {
  return std::lower_bound(range.begin(), range.end(), value, [&](const auto& one, const Value& than) {
    return invoke(compare, invoke(projection, one), than);
  });
}

template <class Range, class Value, class Compare = std::less<>, class Projection = identity>
auto upper_bound(Range&& range, const Value& value, Compare compare = {}, Projection projection = {}) {
  return std::upper_bound(range.begin(), range.end(), value, [&](const Value& than, const auto& one) {
    return invoke(compare, than, invoke(projection, one));
  });
}

template <class Range, class Value>
void replace(Range&& range, const Value& old, const Value& with) {
  std::replace(range.begin(), range.end(), old, with);
}

template <class Range, class Compare = std::less<>, class Projection = identity>
auto min_element(Range&& range, Compare compare = {}, Projection projection = {}) {
  return std::min_element(range.begin(), range.end(), gaps::by(compare, projection));
}

template <class Range, class Compare = std::less<>, class Projection = identity>
auto max_element(Range&& range, Compare compare = {}, Projection projection = {}) {
  return std::max_element(range.begin(), range.end(), gaps::by(compare, projection));
}

template <class Range>
auto max(Range&& range) {
  return *std::max_element(range.begin(), range.end());
}

template <class Range>
auto min(Range&& range) {
  return *std::min_element(range.begin(), range.end());
}

template <class Range>
auto minmax(Range&& range) {
  const auto [least, largest] = std::minmax_element(range.begin(), range.end());
  return pair{*least, *largest};
}

template <class A, class B, class Out>
void set_union(A&& a, B&& b, Out out) {
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), out);
}

template <class A, class B, class Out>
void set_difference(A&& a, B&& b, Out out) {
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), out);
}

} // namespace ranges
} // namespace std
