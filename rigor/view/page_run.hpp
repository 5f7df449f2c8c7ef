#pragma once

#include "rigor/io/scene_reader.hpp"
#include "rigor/sim/audit.hpp"
#include "rigor/view/page_contacts.hpp"
#include "rigor/view/page_frames.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rigor {

/// One run as a page shows it, collected while it goes on: what is kept grows by the quantised motion alone,
/// a few bytes a body a frame.
class PageRun {
 public:
  PageRun(const Scene& scene, const State& start);

  /// An output time with what happened since the last one.
  void add(const State& state, const AdvanceReport& since, const Energy& energy);
  /// Everything, the header first (docs/page.md gives the format). The run ends with it.
  std::vector<PageBlock> finish(const Audit& audit);

  const std::string& name() const { return name_; }

 private:
  void keep(std::optional<PageBlock> chunk);
  PageBlock events_block() const;
  PageBlock series_block() const;

  std::shared_ptr<const Model> model_;
  Method method_;
  RunSettings run_;
  std::string name_;
  PageScale scale_;
  PageFrames frames_;
  PageContacts contacts_;
  std::vector<PageBlock> chunks_;            ///< Of frames and contacts, as they were filled.
  std::vector<std::vector<double>> series_;  ///< One column a quantity.
  double work_ = 0;                          ///< Supplied so far [J].
  std::vector<MotionEvent> events_;
};

}  // namespace rigor
