#pragma once

#include "rigor/study/study.hpp"

#include <string>
#include <string_view>

namespace rigor {

/// What makes the runs of a study's page replay.
struct StudyPageForm {
  /// Folder with a page for each run, seen from this page; empty: there is none.
  std::string kept;
  /// Of a page that a server gives out: its Content-Security-Policy and the address of the script. Empty: the
  /// page is a file of its own.
  std::string policy, script;
};

/// A page with the answer, its tables and figures, and the runs to choose from; it needs nothing else.
std::string study_page(const Study& study, const StudyPageForm& form);

/// The script of the page (viewer/dist/study.js).
std::string_view study_script();
/// Its SHA-256 in hexadecimal digits.
std::string_view study_script_sha256();

}  // namespace rigor
