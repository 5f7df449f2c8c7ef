#pragma once

#include "rigor/view/3d/sample_grid.hpp"

#include <span>
#include <vector>

namespace rigor {

/// Rectangle of the picture and the nearest that anything in it comes.
struct PictureBox {
  double left, right, top, bottom;  ///< [px].
  double nearness;                  ///< [1/m].
};

/// Tells what is hidden before it is drawn, when things are drawn from near to far: by the farthest sample
/// of each tile of 16 × 16 pixels, looked up again only when something was drawn there.
class Occlusion {
 public:
  Occlusion(std::span<const SampleGrid> grids, int width, int height);

  /// Whether all samples of the box see something nearer, or the box is outside the picture.
  bool hides(const PictureBox& box);
  /// Notes that something was drawn in the box.
  void add(const PictureBox& box);

 private:
  static constexpr int tile = 16;
  struct Tiles {
    int left, right, top, bottom;  ///< The right and bottom ones are not included.
  };
  Tiles tiles_of(const PictureBox& box) const;
  float farthest(int column, int row);

  std::span<const SampleGrid> grids_;
  int width_, height_, columns_, rows_;
  std::vector<float> farthest_;  ///< Nearness of each tile's farthest sample.
  std::vector<char> is_outdated_;
};

}  // namespace rigor
