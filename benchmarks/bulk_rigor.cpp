// The many-body path on the scenes of many bodies.

#include "bulk_engines.hpp"

#include "rigor/bulk/bulk_world.hpp"

namespace rigor::bench {

namespace {

class BulkWorldEngine : public BulkEngine {
 public:
  BulkWorldEngine(std::shared_ptr<const Model> model, const BulkSettings& settings)
      : start_(make_initial_state(*model)), world_(std::move(model), settings) {
    world_.read(start_);
  }
  void step(double h) override { report_ = world_.step(h); }
  State state() const override {
    State state = start_;
    world_.write(state);
    return state;
  }
  BulkCounts counts() const override {
    return {report_.pair_count, report_.manifold_count, report_.point_count};
  }

 private:
  State start_;
  BulkStepReport report_;
  BulkWorld world_;
};

}  // namespace

std::unique_ptr<BulkEngine> make_bulk_world_engine(std::shared_ptr<const Model> model,
                                                   const BulkEngineOptions& options) {
  BulkSettings settings;
  settings.threads = options.threads;
  settings.measures = options.measures;
  if (options.substeps > 0) settings.substeps = options.substeps;
  return std::make_unique<BulkWorldEngine>(std::move(model), settings);
}

}  // namespace rigor::bench
