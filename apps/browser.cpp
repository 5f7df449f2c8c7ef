#include "apps/browser.hpp"

#include "apps/terminal.hpp"
#include "rigor/io/files/file_error.hpp"
#include "rigor/io/files/output_file.hpp"
#include "rigor/view/plot/markup_text.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <system_error>

#include <spawn.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace rigor {

namespace {

constexpr const char* hint = "open the address yourself";

bool has_display() {
  return std::getenv("DISPLAY") != nullptr || std::getenv("WAYLAND_DISPLAY") != nullptr;
}

}  // namespace

Browser::~Browser() {
  std::error_code ignored;
  if (!folder_.empty()) std::filesystem::remove_all(folder_, ignored);
}

/// A page in a new folder of this user alone (mkdtemp: 0700), readable by this user alone.
std::filesystem::path Browser::write_page(const std::string& url) {
  std::string name = (std::filesystem::temp_directory_path() / "rigor-view-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw write_error(name, errno);
  folder_ = name;
  std::filesystem::path page = folder_ / "open.html";
  const mode_t mask = ::umask(0077);
  const auto restore = [mask] { ::umask(mask); };
  try {
    write_atomically(page, fmt::format("<!doctype html>\n<meta charset=\"utf-8\">\n<title>Rigor</title>\n"
                                       "<meta name=\"referrer\" content=\"no-referrer\">\n"
                                       "<meta http-equiv=\"refresh\" content=\"0; url={}\">\n",
                                       markup_text(url)));
  } catch (...) {
    restore();
    throw;
  }
  restore();
  return page;
}

void Browser::open(const std::string& url) {
  if (!has_display()) return print_warning(fmt::format("there is no display to open a browser on; {}", hint));
  std::string program = "xdg-open", page = write_page(url).string();
  char* const arguments[] = {program.data(), page.data(), nullptr};
  if (::posix_spawnp(&opener_, program.c_str(), nullptr, nullptr, arguments, environ) == 0) return;
  opener_ = -1;
  print_warning(fmt::format("there is no xdg-open to open a browser; {}", hint));
}

void Browser::look_after() {
  int status = 0;
  if (opener_ < 0 || ::waitpid(opener_, &status, WNOHANG) != opener_) return;
  opener_ = -1;
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    print_warning(fmt::format("xdg-open could not open a browser; {}", hint));
}

}  // namespace rigor
