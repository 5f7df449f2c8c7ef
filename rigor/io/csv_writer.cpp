#include "rigor/io/csv_writer.hpp"

#include <fmt/format.h>

#include <iterator>

namespace rigor {

namespace {

constexpr std::size_t most_pending_bytes = std::size_t{1} << 20;

void append_numbers(const double* values, std::size_t count, std::string& row) {
  for (std::size_t i = 0; i < count; ++i) fmt::format_to(std::back_inserter(row), ",{:.17g}", values[i]);
}

}  // namespace

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string field = "\"";
  for (const char c : text) field.append(c == '"' ? 2 : 1, c);
  return field + '"';
}

std::vector<std::string> csv_columns(const std::vector<std::string>& bodies) {
  std::vector<std::string> columns = {"time [s]"};
  for (const std::string& body : bodies) {
    for (const char* axis : {"x", "y", "z"}) columns.push_back(body + ".position." + axis + " [m]");
    for (const char* part : {"w", "x", "y", "z"}) columns.push_back(body + ".orientation." + part);
    for (const char* axis : {"x", "y", "z"}) columns.push_back(body + ".velocity." + axis + " [m/s]");
    for (const char* axis : {"x", "y", "z"})
      columns.push_back(body + ".angular_velocity." + axis + " [rad/s]");
  }
  for (const char* kind : {"kinetic", "potential", "elastic"})
    columns.push_back(std::string(kind) + "_energy [J]");
  return columns;
}

CsvWriter::CsvWriter(const std::filesystem::path& path, const TrajectoryHeader& header) : file_(path) {
  std::string row;
  for (const std::string& column : csv_columns(header.bodies)) {
    if (!row.empty()) row += ',';
    row += csv_field(column);
  }
  file_.append(row + "\n");
  file_.flush();
}

void CsvWriter::write(const TrajectorySample& sample, std::span<const MotionEvent>) {
  std::string row = fmt::format("{:.17g}", sample.time);
  for (std::size_t i = 0; i < sample.position.size() / 3; ++i) {
    append_numbers(&sample.position[3 * i], 3, row);
    append_numbers(&sample.orientation[4 * i], 4, row);
    append_numbers(&sample.velocity[3 * i], 3, row);
    append_numbers(&sample.angular_velocity[3 * i], 3, row);
  }
  const double energies[] = {sample.energy.kinetic, sample.energy.potential, sample.energy.elastic};
  append_numbers(energies, 3, row);
  // Only whole rows are flushed.
  file_.append(row + "\n");
  if (flush_timer_.is_due() || file_.pending() > most_pending_bytes) file_.flush();
}

void CsvWriter::close(const Audit&) {
  file_.close();
}

}  // namespace rigor
