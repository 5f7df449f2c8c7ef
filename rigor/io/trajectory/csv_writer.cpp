#include "rigor/io/trajectory/csv_writer.hpp"

#include "rigor/core/quoted.hpp"

#include <fmt/format.h>

#include <iterator>

namespace rigor {

namespace {

void append_numbers(const double* values, std::size_t count, std::string& row) {
  for (std::size_t i = 0; i < count; ++i) fmt::format_to(std::back_inserter(row), ",{:.17g}", values[i]);
}

void append_body_columns(const std::string& body, std::vector<std::string>& columns) {
  for (const char* axis : {"x", "y", "z"}) columns.push_back(body + ".position." + axis + " [m]");
  for (const char* part : {"w", "x", "y", "z"}) columns.push_back(body + ".orientation." + part);
  for (const char* axis : {"x", "y", "z"}) columns.push_back(body + ".velocity." + axis + " [m/s]");
  for (const char* axis : {"x", "y", "z"}) columns.push_back(body + ".angular_velocity." + axis + " [rad/s]");
}

void append_joint_columns(const TrajectoryJoint& joint, const TrajectoryHeader& header,
                          std::vector<std::string>& columns) {
  const std::size_t count = joint.units.size();
  const auto index = [&](std::size_t k) { return count > 1 ? fmt::format("[{}]", k) : std::string(); };
  for (std::size_t k = 0; k < count; ++k)
    columns.push_back(fmt::format("{}.coordinate{} [{}]", joint.name, index(k), joint.units[k]));
  for (std::size_t k = 0; k < count; ++k)
    columns.push_back(fmt::format("{}.rate{} [{}/s]", joint.name, index(k), joint.units[k]));
  for (std::size_t k = 0; header.has_efforts && k < count; ++k)
    columns.push_back(fmt::format("{}.effort{} [{}]", joint.name, index(k), effort_unit(joint.units[k])));
  if (!header.has_joint_forces) return;
  for (const char* axis : {"x", "y", "z"}) columns.push_back(joint.name + ".force." + axis + " [N]");
  for (const char* axis : {"x", "y", "z"}) columns.push_back(joint.name + ".torque." + axis + " [N m]");
}

}  // namespace

std::string csv_field(const std::string& given) {
  std::string text = escaped_text(given);
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string field = "\"";
  for (const char c : text) field.append(c == '"' ? 2 : 1, c);
  return field + '"';
}

std::vector<std::string> csv_columns(const TrajectoryHeader& header) {
  std::vector<std::string> columns = {"time [s]"};
  for (const std::string& body : header.bodies) append_body_columns(body, columns);
  for (const TrajectoryJoint& joint : header.joints) append_joint_columns(joint, header, columns);
  for (const char* kind : {"kinetic", "potential", "elastic"})
    columns.push_back(std::string(kind) + "_energy [J]");
  return columns;
}

CsvWriter::CsvWriter(const std::filesystem::path& path, const TrajectoryHeader& header) : file_(path) {
  std::string row;
  for (const std::string& column : csv_columns(header)) {
    if (!row.empty()) row += ',';
    row += csv_field(column);
  }
  file_.append(row + "\n");
  file_.flush();
  for (const TrajectoryJoint& joint : header.joints) coordinate_counts_.push_back(joint.units.size());
}

void CsvWriter::write(const TrajectorySample& sample, std::span<const MotionEvent>) {
  std::string row = fmt::format("{:.17g}", sample.time);
  for (std::size_t i = 0; i < sample.position.size() / 3; ++i) {
    append_numbers(&sample.position[3 * i], 3, row);
    append_numbers(&sample.orientation[4 * i], 4, row);
    append_numbers(&sample.velocity[3 * i], 3, row);
    append_numbers(&sample.angular_velocity[3 * i], 3, row);
  }
  std::size_t first = 0;
  for (std::size_t joint = 0; joint < coordinate_counts_.size(); ++joint) {
    append_numbers(sample.joint_coordinate.data() + first, coordinate_counts_[joint], row);
    append_numbers(sample.joint_rate.data() + first, coordinate_counts_[joint], row);
    if (!sample.joint_effort.empty())
      append_numbers(sample.joint_effort.data() + first, coordinate_counts_[joint], row);
    first += coordinate_counts_[joint];
    if (sample.joint_force.empty()) continue;
    append_numbers(&sample.joint_force[3 * joint], 3, row);
    append_numbers(&sample.joint_torque[3 * joint], 3, row);
  }
  const double energies[] = {sample.energy.kinetic, sample.energy.potential, sample.energy.elastic};
  append_numbers(energies, 3, row);
  // Only whole rows are flushed.
  file_.append(row + "\n");
  if (flush_timer_.is_due() || file_.pending() > kMostPendingBytes) file_.flush();
}

void CsvWriter::close(const Audit&) {
  file_.close();
}

}  // namespace rigor
