#include "apps/study_view.hpp"

#include "apps/announcement.hpp"
#include "rigor/core/broken_promise.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/study/answer/run_page.hpp"
#include "rigor/study/answer/study_page.hpp"
#include "rigor/view/plot/markup_text.hpp"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <string>
#include <string_view>

namespace rigor {

namespace {

/// The run of "/run/12"; nothing if the path is another one.
std::optional<std::uint64_t> run_of_path(std::string_view path) {
  constexpr std::string_view before = "/run/";
  if (!path.starts_with(before)) return std::nullopt;
  path.remove_prefix(before.size());
  std::uint64_t run = 0;
  const auto [end, error] = std::from_chars(path.data(), path.data() + path.size(), run);
  if (error != std::errc() || end != path.data() + path.size()) return std::nullopt;
  return run;
}

/// A page that says why there is no replay.
std::string refusal_page(std::uint64_t run, const std::string& policy, const std::string& reason) {
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n<meta "
      "http-equiv=\"Content-Security-Policy\" "
      "content=\"{}\">\n<title>run {}</title></head>\n<body><h1>Run {} has no "
      "replay</h1><p>{}</p></body></html>\n",
      markup_text(policy), run, run, markup_text(reason));
}

std::string replay_page(const Study& study, std::uint64_t run, const std::string& policy,
                        const std::function<bool()>& interrupt) {
  try {
    return run_page(study, study.known_task(run), {policy, "/viewer.js"}, interrupt);
  } catch (const InputError& error) {
    return refusal_page(run, policy, error.messages().front());
  } catch (const BrokenPromise& error) {
    return refusal_page(run, policy, error.what());
  } catch (const Interrupted&) {
    return refusal_page(run, policy, "The server ends.");
  }
}

}  // namespace

void serve_study(const StudyOptions& options, const Study& study, const std::function<bool()>& should_end) {
  constexpr std::string_view script_path = "/study.js";
  Browser browser;
  LiveServer server(options.port);
  const LivePages pages{[&](std::string_view path, const std::string& policy) -> std::optional<std::string> {
                          if (path == "/") return study_page(study, {{}, policy, std::string(script_path)});
                          const std::optional<std::uint64_t> run = run_of_path(path);
                          if (!run || *run >= study.run_count()) return std::nullopt;
                          return replay_page(study, *run, policy, should_end);
                        },
                        [&](std::string_view path) {
                          return path == script_path ? std::optional(study_script()) : std::nullopt;
                        }};
  announce(server, browser, options.opens_browser);
  server.serve(pages, [&] {
    browser.look_after();
    return should_end();
  });
}

}  // namespace rigor
