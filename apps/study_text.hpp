#pragma once

#include "rigor/study/study.hpp"

#include <cstdio>
#include <string>

namespace rigor {

/// The answer as lines for a reader; in colour if the stream to which they will be printed is a terminal.
std::string study_text(const Study& study, std::FILE* stream);

/// One line of plain text, at most `width` characters: runs, a bar, what is left and the estimate so far.
/// elapsed: real time since the start [s]; resumed: runs that were known then.
std::string study_progress_text(const StudyProgress& progress, double elapsed, std::uint64_t resumed,
                                int width);

/// "12 runs at most, about 3 s of processor time each ...".
std::string cost_text(const StudyCost& cost, int workers);

}  // namespace rigor
