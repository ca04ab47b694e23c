// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "table_scenes.h"

#include <pcl/segmentation/supported_object_extraction.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace table_objects {

using Eigen::Vector3f;
using table_scenes::Box;
using table_scenes::Camera;
using table_scenes::look;
using table_scenes::View;
using Extraction = pcl::SupportedObjectExtraction<pcl::PointXYZ, pcl::Normal>;
using Objects = std::vector<pcl::SupportedObject>;

inline const Box floor_slab{{3.f, 0.f, -0.1f}, {8.f, 8.f, 0.1f}};
inline const Box table{{1.2f, 0.f, 0.66f}, {0.8f, 1.f, 0.04f}};
constexpr float table_height = 0.7f;
inline const Box deep_table{{2.f, 0.f, 0.66f}, {2.f, 2.f, 0.04f}};

inline Box
onTable (float x, float y, const Vector3f& size, float yaw = 0.f)
{
  return {{x, y, table_height}, size, yaw};
}

/** Box 2 is the wall, box 6 a mug on the table. A part of the wall, that a frame in front cuts
 * out, is as high as an object. */
inline View
wallBehindATable ()
{
  const Box wall{{1.66f, 0.f, 0.f}, {0.1f, 4.f, 2.f}};
  const Box left = onTable (1.5f, 0.25f, {0.05f, 0.1f, 0.25f});
  const Box right = onTable (1.5f, -0.25f, {0.05f, 0.1f, 0.25f});
  const Box beam{{1.5f, 0.f, table_height + 0.25f}, {0.05f, 0.6f, 0.3f}};
  const Box mug = onTable (1.1f, 0.1f, {0.08f, 0.08f, 0.1f});
  return look ({floor_slab, table, wall, left, right, beam, mug});
}

inline Objects
extract (Extraction& extraction, const View& view)
{
  extraction.setCameraToBase (view.camera_to_base);
  extraction.setInputCloud (view.cloud);
  extraction.setInputNormals (view.normals);
  Objects objects (3); // what is in there must not stay
  extraction.extract (view.models, view.inliers, objects);
  return objects;
}

inline Objects
extract (const View& view)
{
  Extraction extraction;
  return extract (extraction, view);
}

/** Intersection over union of an object and the pixels of a box. */
inline double
iou (const pcl::SupportedObject& object, const View& view, int box)
{
  const auto truth = view.pixelsOf (box);
  const auto both = std::count_if (object.indices.indices.begin(),
                                   object.indices.indices.end(),
                                   [&] (auto i) { return truth.count (i) != 0; });
  return static_cast<double> (both) /
         static_cast<double> (truth.size() + object.indices.indices.size() - both);
}

/** The best of iou() over the objects. */
inline double
bestIou (const Objects& objects, const View& view, int box)
{
  double best = 0.;
  for (const auto& object : objects)
    best = std::max (best, iou (object, view, box));
  return best;
}

inline Vector3f
sorted (Vector3f size)
{
  if (size.x() > size.y())
    std::swap (size.x(), size.y());
  return size;
}

} // namespace table_objects
