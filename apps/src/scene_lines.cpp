// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/scene_lines.h>

namespace pcl {
namespace rgbd_planes {

std::vector<ColouredLine>
boxLines (const pcl::SupportedObject& object)
{
  const pcl::RGB white (255, 255, 255), red (255, 40, 40);
  const auto corner = [&] (int k) -> Eigen::Vector3f {
    const Eigen::Vector3f signs (
        k & 1 ? 0.5f : -0.5f, k & 2 ? 0.5f : -0.5f, k & 4 ? 0.5f : -0.5f);
    return object.box_center + object.box_axes * signs.cwiseProduct (object.box_size);
  };
  std::vector<ColouredLine> edges;
  for (int k = 0; k < 8; ++k)
    for (const int bit : {1, 2, 4})
      if (!(k & bit))
        edges.push_back (
            {object.graspable ? white : red, {corner (k), corner (k | bit)}});
  return edges;
}

ColouredLine
hullLine (const pcl::SupportPlane& support, const pcl::RGB& colour)
{
  ColouredLine line{colour, support.hull};
  if (!line.points.empty())
    line.points.push_back (line.points.front());
  return line;
}

} // namespace rgbd_planes
} // namespace pcl
