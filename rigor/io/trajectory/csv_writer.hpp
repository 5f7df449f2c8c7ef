#pragma once

#include "rigor/io/files/output_file.hpp"
#include "rigor/io/trajectory/trajectory_writer.hpp"

namespace rigor {

/// Trajectory as a table: a header row with units, then one row per output time (docs/output.md). Fields with
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
  std::vector<std::size_t> coordinate_counts_;  ///< Number of coordinates of each joint.
};

/// A field of a CSV row, in quotes if necessary.
std::string csv_field(const std::string& text);

/// Titles of the columns, such as "ball.position.x [m]", in order.
std::vector<std::string> csv_columns(const TrajectoryHeader& header);

}  // namespace rigor
