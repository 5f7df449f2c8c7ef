#pragma once

#include "apps/options.hpp"
#include "rigor/study/study.hpp"

#include <functional>

namespace rigor {

/// Serves the page of a study on this machine until it is asked to end: a click on a run carries it out once
/// more and shows its replay.
void serve_study(const StudyOptions& options, const Study& study, const std::function<bool()>& should_end);

}  // namespace rigor
