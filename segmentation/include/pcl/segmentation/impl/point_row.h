// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/impl/organized_view.h>
#include <pcl/features/rgbd_planes_exports.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief A row of an image, each coordinate in an array of its own, so that loops over
 * them fill vectors. NaN stands before the first point, and fills up the last block. */
class PCL_RGBD_PLANES_EXPORTS PointRow {
public:
  static constexpr std::size_t block_size = 16;

  /** \param[in] selected not 0 for the points to load, one for each point of the image;
   * others become NaN; null for all
   */
  void
  load (const OrganizedPoints& points, int row, const std::uint8_t* selected = nullptr);

  /** \brief Loads points \a begin to \a end - 1 of a row; the others are of no use. */
  void
  load (const OrganizedPoints& points, int row, std::size_t begin, std::size_t end);

  std::size_t
  blocks () const
  {
    return (columns_.size() + block_size - 1) / block_size;
  }

  /** \brief The number of points, with those that fill up the last block. */
  std::size_t
  size () const
  {
    return blocks() * block_size;
  }

  const float*
  x () const
  {
    return coordinates_[0].data() + block_size;
  }

  const float*
  y () const
  {
    return coordinates_[1].data() + block_size;
  }

  const float*
  z () const
  {
    return coordinates_[2].data() + block_size;
  }

private:
  void
  resize (std::size_t width);

  std::array<std::vector<float>, 3> coordinates_;
  std::vector<std::int32_t> columns_;
};

} // namespace rgbd_planes
} // namespace pcl
