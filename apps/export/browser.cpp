#include "apps/export/browser.hpp"

#include "apps/export/tools.hpp"
#include "base/failure.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

namespace matrigrate::apps {

namespace {

/// The shell connects the pipes: a browser reads commands from descriptor 3 and answers at 4.
std::vector<std::string> command(const std::string& program, const std::filesystem::path& to,
                                 const std::filesystem::path& from, const std::filesystem::path& profile) {
  std::vector<std::string> words{"sh", "-c", R"(exec 3<"$1" 4>"$2"; shift 2; exec "$@")", "sh", to, from, program};
  for (const char* option :
       {"--headless", "--remote-debugging-pipe", "--disable-gpu", "--disable-dev-shm-usage", "--no-first-run",
        "--disable-background-networking", "--disable-component-update", "--disable-default-apps",
        "--disable-extensions", "--disable-sync", "--hide-scrollbars", "--mute-audio",
        "--disable-background-timer-throttling", "--disable-renderer-backgrounding"})
    words.emplace_back(option);
  if (::geteuid() == 0) words.emplace_back("--no-sandbox"); // it refuses to run as root with one
  words.push_back(fmt::format("--user-data-dir={}", profile.string()));
  words.emplace_back("about:blank");
  return words;
}

Child started(const std::vector<std::string>& words, const std::filesystem::path& log) {
  const int output = ::open(log.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, S_IRUSR | S_IWUSR);
  Child child(words, output >= 0 ? output : STDERR_FILENO);
  if (output >= 0) ::close(output);
  return child;
}

/// The address of a file: all but letters, digits and a few signs as %XX.
std::string address(const std::filesystem::path& file) {
  constexpr std::string_view plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789/-._~"; // also in every locale
  std::string text = "file://";
  for (const char c : std::filesystem::absolute(file).string())
    text += plain.find(c) != std::string_view::npos ? std::string(1, c)
                                                    : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  return text;
}

} // namespace

std::string installed_browser() {
  if (const char* named = std::getenv("CHROMIUM"); named != nullptr && *named != '\0') {
    if (is_installed(named)) return named;
    throw InputOutputError(
        fmt::format("CHROMIUM is {}, which is not a program; unset CHROMIUM, or set it to a browser", named));
  }
  for (const char* name : {"chromium", "chromium-browser", "google-chrome"})
    if (is_installed(name)) return name;
  return {};
}

Browser::Browser(const std::string& program, const std::filesystem::path& folder)
    : m_log(folder / "browser.log"), m_to(folder / "to_browser"), m_from(folder / "from_browser"),
      m_child(started(command(program, m_to.path(), m_from.path(), folder / "profile"), m_log)) {}

Browser::~Browser() {
  try {
    send("Browser.close", nlohmann::json::object(), "");
    for (int i = 0; i < 500 && !m_child.ended(); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      if (i > 300) m_child.pass_on(SIGTERM);
    }
  } catch (...) { // it has ended
  }
}

void Browser::fail() {
  std::ifstream log(m_log);
  std::string last;
  for (std::string line; std::getline(log, line);)
    if (!line.empty()) last = line;
  throw InputOutputError(
      fmt::format("the browser ended{}", last.empty() ? std::string(" without a message") : "; it said: " + last));
}

int Browser::send(const std::string& method, nlohmann::json parameters, const std::string& session) {
  nlohmann::json message{{"id", ++m_sent}, {"method", method}, {"params", std::move(parameters)}};
  if (!session.empty()) message["sessionId"] = session;
  std::string text = message.dump();
  text += '\0'; // ends a message
  if (!m_to.write(text, m_child)) fail();
  return m_sent;
}

nlohmann::json Browser::receive() {
  std::size_t searched = 0;
  std::size_t end = 0;
  while ((end = m_text.find('\0', searched)) == std::string::npos) {
    searched = m_text.size();
    if (!m_from.read(m_text, m_child)) fail();
  }
  nlohmann::json message = nlohmann::json::parse(m_text.begin(), m_text.begin() + static_cast<std::ptrdiff_t>(end));
  m_text.erase(0, end + 1);
  return message;
}

nlohmann::json Browser::result_of(int message) {
  while (!m_answers.contains(message)) {
    nlohmann::json received = receive();
    if (received.value("method", "") == "Page.loadEventFired") ++m_loaded;
    if (!received.contains("id")) continue;
    const int id = received.at("id").get<int>(); // before it is moved
    m_answers[id] = std::move(received);
  }
  const nlohmann::json reply = std::move(m_answers.extract(message).mapped());
  if (reply.contains("error"))
    throw InputOutputError(fmt::format("the browser refuses a command: {}", reply.at("error").value("message", "")));
  return reply.at("result");
}

nlohmann::json Browser::call(const std::string& method, nlohmann::json parameters, const std::string& session) {
  return result_of(send(method, std::move(parameters), session));
}

Browser::Page Browser::open(const std::filesystem::path& file, int width, int height) {
  const nlohmann::json target = call("Target.createTarget", {{"url", "about:blank"}, {"newWindow", true}});
  const nlohmann::json attached =
      call("Target.attachToTarget", {{"targetId", target.at("targetId")}, {"flatten", true}});
  const Page page{attached.at("sessionId").get<std::string>()};
  call("Page.enable", nlohmann::json::object(), page.session);
  call("Emulation.setDeviceMetricsOverride",
       {{"width", width}, {"height", height}, {"deviceScaleFactor", 1}, {"mobile", false}}, page.session);
  const nlohmann::json light{{"name", "prefers-color-scheme"}, {"value", "light"}};
  const nlohmann::json still{{"name", "prefers-reduced-motion"}, {"value", "reduce"}}; // it does not play by itself
  call("Emulation.setEmulatedMedia", {{"features", nlohmann::json::array({light, still})}}, page.session);
  m_loaded = 0;
  call("Page.navigate", {{"url", address(file)}}, page.session);
  while (m_loaded == 0) {
    nlohmann::json received = receive();
    if (received.value("method", "") == "Page.loadEventFired") ++m_loaded;
  }
  return page;
}

Browser::Question Browser::ask(const Page& page, const std::string& expression) {
  return send("Runtime.evaluate", {{"expression", expression}, {"awaitPromise", true}, {"returnByValue", true}},
              page.session);
}

nlohmann::json Browser::answer(Question question) {
  const nlohmann::json result = result_of(question);
  if (result.contains("exceptionDetails")) {
    const nlohmann::json& thrown = result.at("exceptionDetails");
    const nlohmann::json exception = thrown.value("exception", nlohmann::json::object());
    throw InputOutputError(
        fmt::format("the page of the run: {}", exception.value("description", thrown.value("text", ""))));
  }
  return result.at("result").value("value", nlohmann::json());
}

} // namespace matrigrate::apps
