#include "rigor/bulk/lanes/fused_floats.hpp"

namespace rigor {

void fuse_floats(const FloatLanes& a, const FloatLanes& b, const FloatLanes& c, FloatLanes& sum) {
  for (int i = 0; i < kLaneCount; ++i) sum[i] = __builtin_fmaf(a[i], b[i], c[i]);
}

}  // namespace rigor
