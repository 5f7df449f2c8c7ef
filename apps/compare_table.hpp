#pragma once

#include "apps/compare_run.hpp"

#include <cstdio>
#include <string>

namespace rigor {

/// The comparison for a reader: a table with a row a run, at most `width` characters a line, then what the
/// audits warn of, each text once. Colours if the stream, where it will be printed, is a terminal.
std::string compare_table(const Comparison& comparison, int width, std::FILE* stream);

}  // namespace rigor
