// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/features/rgbd_planes_exports.h>

namespace pcl {
namespace rgbd_planes {

template <int Bytes>
void
compilePclAndThisWithTheSameMarch ()
{}

template PCL_RGBD_PLANES_EXPORTS void
compilePclAndThisWithTheSameMarch<EIGEN_MAX_ALIGN_BYTES>();

} // namespace rgbd_planes
} // namespace pcl
