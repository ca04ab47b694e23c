// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/memory.h>
#include <pcl/types.h>

namespace pcl {
namespace rgbd_planes {

/** \brief A filter of PCL whose copies work on their own: they would share the indices that PCL
 * makes up for whole clouds, and the removed ones, and change them under each other's feet in
 * several threads. */
template <typename Base>
class PCL_RGBD_PLANES_EXPORTS OwnIndices : public Base {
public:
  using Base::Base;

  OwnIndices() = default;
  ~OwnIndices() override = default;

  OwnIndices (const OwnIndices& other) : Base (other) { separate(); }

  OwnIndices&
  operator= (const OwnIndices& other)
  {
    Base::operator= (other);
    separate();
    return *this;
  }

private:
  void
  separate ()
  {
    if (this->fake_indices_)
      this->indices_.reset(); // made up anew
    this->removed_indices_ = pcl::make_shared<Indices> (*this->removed_indices_);
  }
};

} // namespace rgbd_planes
} // namespace pcl
