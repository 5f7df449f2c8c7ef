#pragma once

#include "rigor/io/files/output_file.hpp"
#include "rigor/io/trajectory/trajectory_writer.hpp"

namespace rigor {

/// Trajectory as a table: a header row with units, then one row an output time (docs/output.md). Fields with
/// commas or quotes are quoted; lines end with LF; numbers have 17 significant digits, which restore the same
/// double.
///
/// Source: Shafranovich, Common Format and MIME Type for Comma-Separated Values (CSV) Files, RFC 4180, 2005
/// (quoting).
class CsvWriter : public TrajectoryWriter {
 public:
  CsvWriter(const std::filesystem::path& path, const TrajectoryHeader& header);
  void write(const TrajectorySample& sample, std::span<const MotionEvent> events) override;
  void close(const Audit& audit) override;

 private:
  OutputFile file_;
  FlushTimer flush_timer_;
  std::vector<std::size_t> coordinate_counts_;  ///< Of each joint.
};

/// A field of a CSV row: in quotes where it has to be.
std::string csv_field(const std::string& text);

/// The columns' titles, such as "ball.position.x [m]", in their order.
std::vector<std::string> csv_columns(const TrajectoryHeader& header);

}  // namespace rigor
