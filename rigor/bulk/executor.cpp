#include "rigor/bulk/executor.hpp"

namespace rigor {

void Executor::for_ranges(int count, int /*grain*/, const std::function<void(int, int)>& body) const {
  if (count > 0) body(0, count);
}

}  // namespace rigor
