// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/features/impl/organized_cloud_view.h>

namespace pcl {
namespace rgbd_planes {

void
selectPoints (const pcl::Indices* indices,
              std::size_t size,
              std::vector<std::uint8_t>& selected)
{
  selected.assign (indices ? size : 0, 0);
  if (indices)
    for (const pcl::index_t index : *indices)
      selected[static_cast<std::size_t> (index)] = 1;
}

} // namespace rgbd_planes
} // namespace pcl
