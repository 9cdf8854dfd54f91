#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

/// Texts that name a file. Test: tests/unit/fields/file_words_test.cpp
namespace matrigrate::fields {

/// The words of a text that names a file: collagen.png pixel=0.5. A name reaches up to its ending, and may have spaces;
/// one that has more of a kind ("a.png of b.png", "a b=c.png"), or another ending, stands in quotes, in which a
/// backslash takes the next character as it is: "a \"b\".png" column='E (Pa)'.
struct FileWords {
  std::filesystem::path name;
  std::map<std::string, std::string> options;

  bool picture() const; ///< otherwise CSV

  /// Empty if the option is not given.
  std::string word(const std::string& key) const;

  /// @throws std::invalid_argument if it is no finite number
  std::optional<double> number(const std::string& key) const;

  /// A number, or a percentage as a share of 1.
  struct Amount {
    double value = 0.0;
    bool percent = false;
  };
  /// @throws std::invalid_argument if it is no finite number, or no percentage from 0 to 100
  std::optional<Amount> amount(const std::string& key) const;

  /// A number of pages or channels, from 1.
  /// @throws std::invalid_argument if it is none
  std::optional<std::size_t> count(const std::string& key) const;

  /// The same words for another path of the file, with its fingerprint; file_words() reads them back.
  std::string text(const std::filesystem::path& file, const std::string& hash) const;
};

/// @return nothing for a text that names no file: a formula
/// @throws std::invalid_argument if the file is of a kind that cannot be read, or an option is unknown or given twice
std::optional<FileWords> file_words(const std::string& text);

} // namespace matrigrate::fields
