#include "rigor/bulk/gyroscopic/gyroscopic_terms.hpp"

#include "rigor/bulk/gyroscopic/gyroscopic_groups.hpp"

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
    : target_(target), principals_(static_cast<std::size_t>(model.body_count())) {
  for (int i = 0; i < model.body_count(); ++i) {
    const Body& body = model.body(i);
    Principal& principal = principals_[static_cast<std::size_t>(i)];
    const bool is_round = body.moments[0] == body.moments[1] && body.moments[1] == body.moments[2];
    if (body.motion != MotionType::dynamic || is_round) continue;
    const std::optional<int> axis = axis_of_revolution(body);
    principal.kind = axis ? Kind::revolution : Kind::other;
    principal.first = axis.value_or(0);
    for (int k = 0; k < 3; ++k) {
      principal.moments[k] = static_cast<float>(body.moments[(principal.first + k) % 3]);
    }
  }
  const auto is_round = [](const Principal& principal) { return principal.kind == Kind::round; };
  if (std::all_of(principals_.begin(), principals_.end(), is_round)) principals_ = std::vector<Principal>();
}

void GyroscopicTerms::prepare(const BulkBodies& bodies, const std::vector<int>& who,
                              const Executor& executor) {
  if (principals_.empty()) return;
  if (who != who_) {
    who_ = who;
    groups_.clear();
    add(Kind::revolution);
    add(Kind::other);
  }
  executor.for_ranges(static_cast<int>(groups_.size()), 64, [&](int begin, int end) {
    for (int g = begin; g < end; ++g) set_axes(bodies, groups_[static_cast<std::size_t>(g)]);
  });
}

/// Groups of the bodies of one kind.
void GyroscopicTerms::add(Kind kind) {
  std::size_t lane = kLaneCount;
  for (const int body : who_) {
    const Principal& principal = principals_[static_cast<std::size_t>(body)];
    if (principal.kind != kind) continue;
    if (lane == kLaneCount) {
      lane = 0;
      Group& group = groups_.emplace_back();
      group.bodies.fill(-1);
      group.is_of_revolution = kind == Kind::revolution;
      group.start = GyroscopicState{};
      for (FloatLanes& moment : group.start.moments) moment = float_lanes(1);
    }
    Group& group = groups_.back();
    group.bodies[lane] = body;
    for (int k = 0; k < 3; ++k) group.start.moments[k][static_cast<int>(lane)] = principal.moments[k];
    group.start.spin[static_cast<int>(lane)] = principal.moments[0] / principal.moments[1] - 1;
    ++lane;
  }
}

void GyroscopicTerms::set_axes(const BulkBodies& bodies, Group& group) const {
  for (std::size_t lane = 0; lane < kLaneCount && group.bodies[lane] >= 0; ++lane) {
    const std::size_t body = static_cast<std::size_t>(group.bodies[lane]);
    const Mat3 R_WB = bodies.q[body].toRotationMatrix();
    for (int k = 0; k < 2; ++k)
      set_lane(R_WB.col((principals_[body].first + k) % 3), lane, group.start.axes[k]);
  }
}

void GyroscopicTerms::find_changes(float h, const BulkBodies& bodies, const Executor& executor,
                                   std::vector<std::array<float, kLaneCount>>& turns) const {
  turns.resize(bodies.x.size());
  executor.for_ranges(static_cast<int>(groups_.size()), 64, [&](int begin, int end) {
    const MotionRecord nothing;
    std::array<float, kLaneCount> nowhere{};
    for (int g = begin; g < end; ++g) {
      const Group& group = groups_[static_cast<std::size_t>(g)];
      GyroscopicRecords at;
      for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
        const std::size_t body = static_cast<std::size_t>(group.bodies[lane]);
        const bool is_used = group.bodies[lane] >= 0;
        at.records[lane] = is_used ? bodies.motion[body].v : nothing.v;
        at.changes[lane] = is_used ? turns[body].data() : nowhere.data();
      }
      target_ == LaneTarget::avx2 ? avx2_lanes::find_group(group.start, group.is_of_revolution, h, at)
                                  : portable_lanes::find_group(group.start, group.is_of_revolution, h, at);
    }
  });
}

}  // namespace rigor
