#pragma once

#include "apps/compare_run.hpp"

#include <cstdio>
#include <string>

namespace rigor {

/// The comparison for a reader: a table with one row per run, at most `width` characters per line, then the
/// warnings of the audits, each text once. In colour if the stream to which it will be printed is a terminal.
std::string compare_table(const Comparison& comparison, int width, std::FILE* stream);

}  // namespace rigor
