#pragma once

#include "rigor/io/files/output_file.hpp"
#include "rigor/io/trajectory/trajectory_writer.hpp"

namespace rigor {

/// Trajectory and audit as one JSON object {"rigor", "scene", "bodies", "joints" if there are any,
/// "trajectory": [one object per output time, on one line], "audit"} (docs/output.md). The object is complete
/// when the file is closed; from a file that was not closed, the lines before can be recovered.
class JsonWriter : public TrajectoryWriter {
 public:
  JsonWriter(const std::filesystem::path& path, const TrajectoryHeader& header);
  void write(const TrajectorySample& sample, std::span<const MotionEvent> events) override;
  void close(const Audit& audit) override;

 private:
  OutputFile file_;
  FlushTimer flush_timer_;
  std::vector<std::size_t> coordinate_counts_;  ///< Number of coordinates of each joint.
  bool is_first_ = true;
};

}  // namespace rigor
