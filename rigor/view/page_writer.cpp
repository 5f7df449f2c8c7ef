#include "rigor/view/page_writer.hpp"

#include "rigor/io/output_file.hpp"

#include <fmt/format.h>

#include <utility>

namespace rigor {

namespace {

/// Text as it stands between tags.
std::string html_text(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '&':
        result += "&amp;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

// The policy lets the page run what is in it and reach nothing outside.
constexpr std::string_view head =
    "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
    "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'unsafe-inline'; "
    "style-src 'unsafe-inline'; img-src data: blob:\">\n"
    "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
    "<meta name=\"generator\" content=\"Rigor\">\n";
constexpr std::string_view no_script =
    "<noscript>This page shows a simulation; it needs JavaScript, and nothing from the network.</noscript>\n";

}  // namespace

void write_page(const std::filesystem::path& path, std::string_view title,
                const std::vector<std::vector<PageBlock>>& runs) {
  OutputFile file(path);
  file.append(head);
  file.append(fmt::format("<title>{}</title>\n<script>\n", html_text(title)));
  file.append(viewer_script());
  file.append("</script>\n</head>\n<body>\n");
  file.append(no_script);
  // The number of blocks comes first, so that a page that was cut off knows.
  std::size_t count = 0;
  for (const std::vector<PageBlock>& blocks : runs) count += blocks.size();
  file.append(fmt::format("<meta name=\"rigor-blocks\" content=\"{}\">\n", count));
  for (std::size_t i = 0; i < runs.size(); ++i) {
    for (const PageBlock& block : runs[i]) {
      file.append(block_html(block, static_cast<int>(i)));
      file.flush();
    }
  }
  file.append("</body>\n</html>\n");
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
