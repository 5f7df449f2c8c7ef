#include "rigor/bulk/gyroscopic/gyroscopic_terms.hpp"

#include "rigor/bulk/gyroscopic/gyroscopic_groups.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

void set_lane(const Vec3& a, std::size_t lane, FloatVec3& to) {
  const int i = static_cast<int>(lane);
  to.x[i] = static_cast<float>(a.x());
  to.y[i] = static_cast<float>(a.y());
  to.z[i] = static_cast<float>(a.z());
}

}  // namespace

std::optional<int> axis_of_revolution(const Body& body) {
  constexpr double rounding = 1e-6;
  for (int k = 0; k < 3; ++k) {
    const double a = body.moments[(k + 1) % 3], b = body.moments[(k + 2) % 3];
    if (std::abs(a - b) <= rounding * std::max(a, b)) return k;
  }
  return std::nullopt;
}

GyroscopicTerms::GyroscopicTerms(const Model& model, LaneTarget target)
    : target_(target), principals_(at(model.body_count())) {
  for (int i = 0; i < model.body_count(); ++i) set_body(model, i);
}

void GyroscopicTerms::set_body(const Model& model, int body) {
  const Body& own = model.body(body);
  Principal& principal = principals_[at(body)];
  if (principal.kind != Kind::round) --uneven_count_;
  principal = {};
  indices_.clear();  // Groups have its moments.
  groups_.clear();
  const bool is_round = own.moments[0] == own.moments[1] && own.moments[1] == own.moments[2];
  if (own.motion != MotionType::dynamic || is_round) return;
  ++uneven_count_;
  const std::optional<int> axis = axis_of_revolution(own);
  principal.kind = axis ? Kind::revolution : Kind::other;
  principal.first = axis.value_or(0);
  // Only ratios matter. In units of a power of two near the largest moment, products of three do not
  // underflow, and every other bit is the same.
  const int unit = std::ilogb(own.moments.maxCoeff());
  for (int k = 0; k < 3; ++k) {
    principal.moments[k] = static_cast<float>(std::ldexp(own.moments[(principal.first + k) % 3], -unit));
  }
}

void GyroscopicTerms::prepare(const BulkBodies& bodies, const std::vector<int>& indices,
                              const Executor& executor) {
  if (uneven_count_ == 0) return;
  // Groups of eight bodies, kept while the bodies are the same.
  if (indices != indices_) {
    indices_ = indices;
    groups_.clear();
    add(Kind::revolution);
    add(Kind::other);
  }
  // Their principal axes where they are now.
  executor.for_ranges(static_cast<int>(groups_.size()), 64, [&](int begin, int end) {
    for (int g = begin; g < end; ++g) set_axes(bodies, groups_[at(g)]);
  });
}

/// Groups of the bodies of one kind.
void GyroscopicTerms::add(Kind kind) {
  std::size_t lane = kLaneCount;
  for (const int body : indices_) {
    const Principal& principal = principals_[at(body)];
    if (principal.kind != kind) continue;
    // A new group, whose lanes without a body have unit moments.
    if (lane == kLaneCount) {
      lane = 0;
      Group& group = groups_.emplace_back();
      group.bodies.fill(-1);
      group.is_of_revolution = kind == Kind::revolution;
      group.start = GyroscopicState{};
      for (FloatLanes& moment : group.start.moments) moment = float_lanes(1);
    }
    // The next lane.
    Group& group = groups_.back();
    group.bodies[lane] = body;
    for (int k = 0; k < 3; ++k) group.start.moments[k][static_cast<int>(lane)] = principal.moments[k];
    group.start.spin[static_cast<int>(lane)] = principal.moments[0] / principal.moments[1] - 1;
    ++lane;
  }
}

void GyroscopicTerms::set_axes(const BulkBodies& bodies, Group& group) const {
  for (std::size_t lane = 0; lane < kLaneCount && group.bodies[lane] >= 0; ++lane) {
    const std::size_t body = at(group.bodies[lane]);
    const Mat3 R_WB = bodies.q[body].toRotationMatrix();
    for (int k = 0; k < 2; ++k)
      set_lane(R_WB.col((principals_[body].first + k) % 3), lane, group.start.axes[k]);
  }
}

void GyroscopicTerms::find_changes(float h, const BulkBodies& bodies, const Executor& executor,
                                   std::vector<std::array<float, kLaneCount>>& changes,
                                   std::span<const char> wanted) const {
  changes.resize(bodies.x.size());
  executor.for_ranges(static_cast<int>(groups_.size()), 64, [&](int begin, int end) {
    // Lanes without a body read a record of zeros and write to a place that nobody reads.
    const MotionRecord nothing;
    std::array<float, kLaneCount> nowhere{};
    for (int g = begin; g < end; ++g) {
      const Group& group = groups_[at(g)];
      const auto is_wanted = [&](int body) { return body >= 0 && wanted[at(body)] != 0; };
      if (!wanted.empty() && std::none_of(group.bodies.begin(), group.bodies.end(), is_wanted)) continue;
      GyroscopicRecords records;
      for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
        const std::size_t body = at(group.bodies[lane]);
        const bool is_used = group.bodies[lane] >= 0;
        records.of_bodies[lane] = is_used ? bodies.motion[body].v : nothing.v;
        records.changes[lane] = is_used ? changes[body].data() : nowhere.data();
      }
      target_ == LaneTarget::avx2
          ? avx2_lanes::find_group(group.start, group.is_of_revolution, h, records)
          : portable_lanes::find_group(group.start, group.is_of_revolution, h, records);
    }
  });
}

}  // namespace rigor
