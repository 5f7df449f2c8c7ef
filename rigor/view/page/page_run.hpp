#pragma once

#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/sim/audit/audit.hpp"
#include "rigor/view/page/page_contacts.hpp"
#include "rigor/view/page/page_frames.hpp"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rigor {

/// One run as a page shows it, collected while it goes on: what is kept grows by the quantised motion alone,
/// a few bytes a body a frame.
class PageRun {
 public:
  /// label: its name on a page with several runs, else empty.
  PageRun(const Scene& scene, const State& start, std::string label = {});

  /// An output time with what happened since the last one.
  void add(const State& state, const AdvanceReport& since, const Energy& energy);
  /// The same where the contacts at the state are known already.
  void add(const State& state, const AdvanceReport& since, const Energy& energy,
           const std::vector<TouchingPoint>& contacts);
  /// From now on the run is one of this model, which has the same bodies; the header tells of the last one.
  void continue_with(std::shared_ptr<const Model> model) { latest_model_ = std::move(model); }
  /// Values of the series at the last output time, in the order of the header's list.
  std::vector<double> last_row() const;
  int frame_count() const { return frames_.frame_count(); }
  /// Everything, the header first (docs/page.md gives the format). The run ends with it.
  std::vector<PageBlock> finish(const Audit& audit);

  const std::string& name() const { return name_; }

 private:
  void keep(std::optional<PageBlock> chunk);
  PageBlock events_block() const;
  PageBlock series_block() const;

  std::shared_ptr<const Model> model_, latest_model_;
  Method method_;
  RunSettings run_;
  std::string name_, label_;
  PageScale scale_;
  PageFrames frames_;
  PageContacts contacts_;
  std::vector<PageBlock> chunks_;            ///< Of frames and contacts, as they were filled.
  std::vector<std::vector<double>> series_;  ///< One column a quantity.
  double work_ = 0;                          ///< Supplied so far [J].
  std::vector<MotionEvent> events_;
};

/// The row of the series for two intervals that follow each other, from the rows of each: values at its end,
/// sums of what is counted, the larger of what is the worst.
std::vector<double> joined_rows(const std::vector<double>& earlier, const std::vector<double>& later);

}  // namespace rigor
