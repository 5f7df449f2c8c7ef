#pragma once

#include <sys/types.h>
#include <filesystem>
#include <string>

namespace rigor {

/// Opens an address in the user's browser without waiting for it. Command lines are for all users to read,
/// and the address holds a secret: the browser is given a page that only this user can read and that leads on
/// to it. The page goes with this object.
class Browser {
 public:
  Browser() = default;
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;
  ~Browser();

  /// Starts the opener of the desktop, or warns that it cannot.
  void open(const std::string& url);
  /// Warns if the opener has ended without success; to be called now and then.
  void look_after();

 private:
  std::filesystem::path write_page(const std::string& url);

  std::filesystem::path folder_;
  pid_t opener_ = -1;
};

}  // namespace rigor
