#pragma once

#include "rigor/view/3d/sample_grid.hpp"

#include <span>
#include <vector>

namespace rigor {

/// A rectangle of the picture and the largest nearness of anything in it.
struct PictureBox {
  double left, right, top, bottom;  ///< [px].
  double nearness;                  ///< [1/m].
};

/// Occlusion culling: tells whether a shape is hidden before it is drawn, given that shapes come from near to
/// far. It compares the shape with the farthest sample of each tile of 16 × 16 pixels, which is computed
/// again only after something was drawn there.
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
