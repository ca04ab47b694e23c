// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/app_error.h>
#include <pcl/apps/frame_truth.h>
#include <pcl/apps/pcd_file.h>
#include <pcl/conversions.h>
#include <pcl/filters/camera_pose.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <system_error>

namespace fs = std::filesystem;

namespace pcl {
namespace rgbd_planes {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* shape_names[] = {"box", "cylinder", "sphere"};

TrueObject::Shape
shapeOf (const std::string& name)
{
  const auto* found =
      std::find (std::begin (shape_names), std::end (shape_names), name);
  if (found == std::end (shape_names))
    throw AppError ("unknown shape '" + name + "'");
  return static_cast<TrueObject::Shape> (found - shape_names);
}

template <int Size>
Json
toJson (const Eigen::Matrix<float, Size, 1>& vector)
{
  return std::vector<float> (vector.data(), vector.data() + Size);
}

template <int Size>
Eigen::Matrix<float, Size, 1>
toVector (const Json& json)
{
  Eigen::Matrix<float, Size, 1> vector;
  for (int i = 0; i < Size; ++i)
    json.at (static_cast<std::size_t> (i)).get_to (vector[i]);
  return vector;
}

Eigen::Affine3f
toPose (const Json& json)
{
  Eigen::Affine3f pose = Eigen::Affine3f::Identity();
  for (int row = 0; row < 3; ++row)
    pose.matrix().row (row) = toVector<4> (json.at (static_cast<std::size_t> (row)));
  if (!isRigid (pose))
    throw AppError ("a pose is no turn and shift");
  return pose;
}

Eigen::Vector4f
toPlane (const Json& json)
{
  constexpr float unit_tolerance = 1e-3f;
  const auto plane = toVector<4> (json);
  if (!plane.allFinite() ||
      !(std::fabs (plane.head<3>().norm() - 1.f) < unit_tolerance))
    throw AppError ("the normal of a plane is not of length 1");
  return plane;
}

TrueObject
toObject (const Json& json)
{
  const Json& id = json.at ("id");
  if (!id.is_number_unsigned() || id == 0 ||
      id > std::numeric_limits<std::uint32_t>::max())
    throw AppError ("the id of an object is no whole number from 1 on");
  const auto size = toVector<3> (json.at ("size_m"));
  if (!size.allFinite() || !(size.minCoeff() > 0.f))
    throw AppError ("a size of an object is not more than 0");
  return {id, shapeOf (json.at ("shape")), size, toPose (json.at ("pose"))};
}

void
readScene (const fs::path& file, Frame& frame)
{
  std::ifstream stream (file);
  if (!stream)
    throw cannotOpen (file.string());
  try {
    const Json json = Json::parse (stream);
    frame.camera_to_base = toPose (json.at ("camera_to_base"));
    for (const Json& plane : json.at ("planes"))
      frame.true_planes.push_back (toPlane (plane));
    for (const Json& object : json.at ("objects"))
      frame.true_objects.push_back (toObject (object));
  }
  catch (const std::exception& error) {
    throw AppError (file.string() + ": not the truth about a frame: " + error.what() +
                    "; write it again with pcl_simulate_rgbd, or move it away");
  }
}

pcl::PointCloud<TruthPoint>::Ptr
readPixels (const fs::path& file)
{
  const PcdFile pcd =
      readPcdFile (file, {"x", "y", "z", "normal_x", "normal_y", "normal_z"});
  for (const char* name : {"label", "object", "obstacle", "edge"}) {
    const auto* field = findField (pcd.cloud, name);
    if (!field || field->datatype != pcl::PCLPointField::UINT32)
      throw AppError (file.string() + ": has no field '" + name +
                      "' of unsigned 32-bit integers; write it again with "
                      "pcl_simulate_rgbd");
  }
  auto truth = pcl::make_shared<pcl::PointCloud<TruthPoint>>();
  pcl::fromPCLPointCloud2 (pcd.cloud, *truth);
  return truth;
}

} // namespace

std::vector<fs::path>
truthFiles (const fs::path& frame)
{
  const fs::path start = fs::path (frame).replace_extension() += "_truth";
  const fs::path scene = fs::path (start) += ".json";
  std::error_code too_long; // as the name of the frame may be without this ending
  if (!fs::exists (scene, too_long))
    return {};
  return {scene, fs::path (start) += ".pcd"};
}

Json
poseJson (const Eigen::Affine3f& pose)
{
  Json rows;
  for (int row = 0; row < 3; ++row)
    rows.push_back (toJson<4> (pose.matrix().row (row).transpose()));
  return rows;
}

std::string
encodeSceneTruth (const SimulatedFrame& frame)
{
  Json planes = Json::array(), objects = Json::array();
  for (const auto& plane : frame.planes)
    planes.push_back (toJson<4> (plane));
  for (const auto& object : frame.objects)
    objects.push_back ({{"id", object.id},
                        {"shape", shape_names[static_cast<int> (object.shape)]},
                        {"size_m", toJson<3> (object.size)},
                        {"pose", poseJson (object.pose)}});
  const Json json = {{"camera_to_base", poseJson (frame.camera_to_base)},
                     {"planes", planes},
                     {"objects", objects}};
  return json.dump (2) + '\n';
}

void
readTruth (const fs::path& file, Frame& frame)
{
  const auto files = truthFiles (file);
  if (files.empty())
    return;
  readScene (files[0], frame);
  frame.truth = readPixels (files[1]);
  const bool is_of_scene = std::all_of (
      frame.truth->begin(), frame.truth->end(), [&] (const TruthPoint& point) {
        return point.label <= frame.true_planes.size();
      });
  if (!is_of_scene || frame.truth->width != frame.cloud->width ||
      frame.truth->height != frame.cloud->height)
    throw AppError (files[1].string() +
                    ": the truth about another frame; write all files again with "
                    "pcl_simulate_rgbd");
}

} // namespace rgbd_planes
} // namespace pcl
