// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/impl/region_contour.h>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Eight directions, clockwise in the image, whose rows go down. */
constexpr int east = 0, count = 8;
constexpr int step_x[count] = {1, 1, 0, -1, -1, -1, 0, 1};
constexpr int step_y[count] = {0, 1, 1, 1, 0, -1, -1, -1};
/** For each direction in which a pixel was entered, where to look first from it: next to
 * the pixel outside that was seen last. */
constexpr int first_look[count] = {7, 7, 1, 1, 3, 3, 5, 5};

class Region {
public:
  Region (const std::vector<std::uint32_t>& labels, std::size_t width, index_t start)
  : labels_ (labels)
  , width_ (static_cast<int> (width))
  , height_ (static_cast<int> (labels.size() / width))
  , label_ (labels[static_cast<std::size_t> (start)])
  {}

  /** The first direction clockwise from \a look that leads from (x, y) to a pixel of the
   * region, or \a count if there is none. */
  int
  next (int x, int y, int look) const
  {
    for (int i = 0; i < count; ++i) {
      const int direction = (look + i) % count;
      if (contains (x + step_x[direction], y + step_y[direction]))
        return direction;
    }
    return count;
  }

private:
  bool
  contains (int x, int y) const
  {
    return x >= 0 && x < width_ && y >= 0 && y < height_ &&
           labels_[static_cast<std::size_t> (y) * static_cast<std::size_t> (width_) +
                   static_cast<std::size_t> (x)] == label_;
  }

  const std::vector<std::uint32_t>& labels_;
  int width_;
  int height_;
  std::uint32_t label_;
};

} // namespace

void
traceContour (const std::vector<std::uint32_t>& labels,
              std::size_t width,
              index_t start,
              Indices& contour)
{
  const Region region (labels, width, start);
  const int columns = static_cast<int> (width);
  contour.assign (1, start);
  int x = start % columns, y = start / columns;
  // Nothing lies west, north-west, north or north-east of the first pixel.
  const int first = region.next (x, y, east);
  if (first == count)
    return;
  for (int direction = first;;) {
    x += step_x[direction];
    y += step_y[direction];
    direction = region.next (x, y, first_look[direction]);
    const index_t pixel = y * columns + x;
    // The first pixel may be passed several times, but left this way only once.
    if (pixel == start && direction == first)
      return;
    contour.push_back (pixel);
  }
}

} // namespace rgbd_planes
} // namespace pcl
