#include "rigor/view/page/page_writer.hpp"

#include "rigor/core/interrupt.hpp"
#include "rigor/io/files/output_file.hpp"
#include "rigor/view/plot/markup_text.hpp"

#include <fmt/format.h>

#include <system_error>
#include <utility>

namespace rigor {

namespace {

int digit_value(char digit) {
  return digit <= '9' ? digit - '0' : digit - 'a' + 10;
}

std::string own_policy() {
  return script_policy(viewer_script_sha256());
}

/// The viewer in the page. Its text is what the policy names: not even a line may be added.
std::string inline_viewer() {
  return std::string("<script>").append(viewer_script()).append("</script>\n");
}

constexpr std::string_view no_script =
    "<noscript>This page shows a simulation; it needs JavaScript, and nothing from the network.</noscript>\n";

/// The head of the page up to the viewer's script.
std::string head(std::string_view title, std::string_view content_policy) {
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"generator\" content=\"Rigor\">\n<title>{}</title>\n",
      markup_text(content_policy), markup_text(title));
}

/// Passes the body, with all blocks, to `append`, piece by piece.
template <typename Append>
void append_body(const std::vector<std::vector<PageBlock>>& runs, Append append) {
  append("<body>\n");
  append(no_script);
  // The number of blocks comes first, so that the viewer notices a page that was cut off.
  std::size_t count = 0;
  for (const std::vector<PageBlock>& blocks : runs) count += blocks.size();
  append(fmt::format("<meta name=\"rigor-blocks\" content=\"{}\">\n", count));
  for (std::size_t i = 0; i < runs.size(); ++i) {
    for (const PageBlock& block : runs[i]) {
      poll_interrupt();
      append(block_html(block, static_cast<int>(i)));
    }
  }
  append("</body>\n</html>\n");
}

}  // namespace

std::string script_policy(std::string_view sha256) {
  // Scripts are named by the base64 of their hash.
  std::string hash;
  for (std::size_t i = 0; i + 1 < sha256.size(); i += 2)
    hash += static_cast<char>(16 * digit_value(sha256[i]) + digit_value(sha256[i + 1]));
  return fmt::format(
      "default-src 'none'; script-src 'sha256-{}'; img-src data: blob:; base-uri 'none'; "
      "form-action 'none'",
      base64(hash));
}

std::string page_text(std::string_view title, const std::vector<std::vector<PageBlock>>& runs,
                      const ServedPage& served) {
  std::string text = head(title, served.policy.empty() ? own_policy() : served.policy);
  if (!served.mark.empty())
    text += fmt::format("<meta name=\"rigor-live\" content=\"{}\">\n", markup_text(served.mark));
  if (served.script.empty()) {
    text += inline_viewer();
  } else {
    text += fmt::format("<script src=\"{}\"></script>\n", markup_text(served.script));
  }
  text += "</head>\n";
  append_body(runs, [&text](std::string_view part) { text += part; });
  return text;
}

void write_page(const std::filesystem::path& path, std::string_view title,
                const std::vector<std::vector<PageBlock>>& runs) {
  OutputFile file(path);
  file.append(head(title, own_policy()));
  file.append(inline_viewer());
  file.append("</head>\n");
  try {
    append_body(runs, [&file](std::string_view part) {
      file.append(part);
      file.flush();
    });
  } catch (const Interrupted&) {
    // Half a page shows nothing.
    std::error_code ignored;
    if (std::filesystem::is_regular_file(path, ignored)) std::filesystem::remove(path, ignored);
    throw;
  }
  file.close();
}

PageWriter::PageWriter(std::filesystem::path path, const Scene& scene)
    : path_(std::move(path)), scene_(scene) {
  check_can_write(path_);
}

void PageWriter::write(const State& state, const AdvanceReport& since, const Energy& energy) {
  if (!run_) run_.emplace(scene_, state);
  run_->add(state, since, energy);
}

void PageWriter::close(const Audit& audit) {
  if (!run_) return;
  write_page(path_, scene_.name + " · Rigor", {run_->finish(audit)});
}

}  // namespace rigor
