// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#if __cplusplus < 201703L
#error "pcl_rgbd_planes needs C++17: compile with -std=c++17, also in CMAKE_CXX_FLAGS"
#endif

#include <Eigen/Core>

/** PCL's own PCL_EXPORTS is empty on Linux, so that consumers built with hidden
 * visibility would not find the instantiations in the library. */
#define PCL_RGBD_PLANES_EXPORTS __attribute__ ((visibility ("default")))

namespace pcl {
namespace rgbd_planes {

/** \brief The library has it for the number of bytes that Eigen aligned memory to when it was
 * compiled. Programs for which Eigen does otherwise, as with -march=native on processors with
 * AVX, would crash: they need this function, and do not link. */
template <int Bytes>
PCL_RGBD_PLANES_EXPORTS void
compilePclAndThisWithTheSameMarch ();

namespace {
__attribute__ ((used)) void (*const eigen_aligns_alike)() =
    &compilePclAndThisWithTheSameMarch<EIGEN_MAX_ALIGN_BYTES>;
}

} // namespace rgbd_planes
} // namespace pcl
