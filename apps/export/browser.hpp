#pragma once

#include "apps/export/named_pipe.hpp"
#include "base/process.hpp"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>

namespace matrigrate::apps {

/// The browser to call: $CHROMIUM, or the first of chromium, chromium-browser and google-chrome that is installed;
/// empty if there is none.
std::string installed_browser();

/// A browser without a window, driven by the DevTools protocol over two pipes. It has a profile of its own and gets no
/// network from the pages of reports.
class Browser {
public:
  /// A page that is open.
  struct Page {
    std::string session;
  };
  /// A question that has been asked.
  using Question = int;

  /// @param folder  for pipes, profile and log
  /// @throws InputOutputError if it cannot be started
  Browser(const std::string& program, const std::filesystem::path& folder);
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;
  ~Browser();

  /// Opens a file and waits until it is loaded.
  /// @param width, height  of the window [pixel]
  Page open(const std::filesystem::path& file, int width, int height);

  /// Begins to evaluate an expression of JavaScript in a page.
  Question ask(const Page& page, const std::string& expression);

  /// Waits for the value of the expression, or of what it promises. Each answer is given once.
  /// @throws InputOutputError with the message of the page's exception, or of the browser's end
  nlohmann::json answer(Question question);

private:
  int send(const std::string& method, nlohmann::json parameters, const std::string& session);
  nlohmann::json result_of(int message);
  nlohmann::json call(const std::string& method, nlohmann::json parameters, const std::string& session = {});
  nlohmann::json receive();
  [[noreturn]] void fail();

  std::filesystem::path m_log;
  NamedPipe m_to, m_from;
  Child m_child;
  std::string m_text; ///< received and not yet read
  int m_sent = 0;
  std::map<int, nlohmann::json> m_answers; ///< received and not yet asked for
  std::size_t m_loaded = 0;                ///< pages that said so
};

} // namespace matrigrate::apps
