// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/PCLPointCloud2.h>

#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief What is in a PCD file. */
struct PcdFile {
  pcl::PCLPointCloud2 cloud;
  Eigen::Vector4f origin;
  Eigen::Quaternionf orientation;
  int version = 0;
  int data_type = 0; /**< 0 is text, 1 binary, 2 compressed */
  unsigned data_begin = 0;
};

/** \brief The field of this name, or null. */
const pcl::PCLPointField*
findField (const pcl::PCLPointCloud2& cloud, const std::string& name);

/** \brief Reads an organized cloud with some fields of 32-bit floats. PCL's reader trusts what
 * it reads; here whatever is damaged, and what is missing, is an AppError. */
PcdFile
readPcdFile (const std::string& file, const std::vector<std::string>& floats);

} // namespace rgbd_planes
} // namespace pcl
