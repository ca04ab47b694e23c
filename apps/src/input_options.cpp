// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/app_error.h>
#include <pcl/apps/input_options.h>
#include <pcl/apps/parse_number.h>
#include <pcl/common/angles.h>
#include <pcl/filters/camera_pose.h>
#include <pcl/simulation/simulate.h>

#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <boost/program_options/value_semantic.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace po = boost::program_options;

namespace pcl {
namespace rgbd_planes {

namespace {

/** Finite numbers between commas, after which there may be spaces; \a names says how many, and
 * what. */
std::vector<float>
parseNumbers (const std::string& option,
              const std::string& text,
              const std::string& names)
{
  std::vector<float> values;
  std::istringstream stream (text + ',');
  for (std::string value; std::getline (stream, value, ',');)
    values.push_back (
        parseNumber<float> (option + ": a value", boost::trim_left_copy (value)));
  const auto commas = std::count (names.begin(), names.end(), ',');
  if (values.size() != static_cast<std::size_t> (commas) + 1)
    throw AppError (option + ": '" + text + "' must be " + std::to_string (commas + 1) +
                    " numbers, " + names);
  for (const float value : values)
    if (!std::isfinite (value))
      throw AppError (option + ": '" + text + "' must be finite numbers");
  return values;
}

Intrinsics
parseIntrinsics (const std::string& text)
{
  const auto values = parseNumbers ("--intrinsics", text, "fx,fy,cx,cy");
  if (values[0] <= 0.f || values[1] <= 0.f)
    throw AppError ("--intrinsics: the focal lengths in '" + text +
                    "' must be more than 0 pixels");
  return {values[0], values[1], values[2], values[3]};
}

float
parseDepthScale (const std::string& text)
{
  const float scale = parseNumber<float> ("--depth-scale", text);
  if (!std::isfinite (scale) || scale <= 0.f)
    throw AppError ("--depth-scale: '" + text +
                    "' must be more than 0 units per metre");
  return scale;
}

} // namespace

std::string
wrap (const std::string& text, std::size_t columns, std::size_t indent)
{
  const std::string margin (indent, ' ');
  std::string lines, line = margin, word;
  for (std::istringstream words (text); words >> word;) {
    if (line != margin && line.size() + 1 + word.size() > columns) {
      lines += line + '\n';
      line = margin;
    }
    line += (line == margin ? "" : " ") + word;
  }
  return lines + line;
}

std::string
inputHelp ()
{
  return R"(INPUT is one of
  FILE.pcd          an organized cloud, metres, in the frame of the camera: z forward, y down
  FILE.png          a 16-bit depth image, with --intrinsics and --depth-scale; 0 and 65535 are
                    missing depth
  FOLDER            of .pcd files, but for NAME_truth.pcd and NAME_view.pcd beside NAME.pcd or
                    NAME.png, or else, or with --intrinsics, of depth images; other .png files
                    between them are left out
  FOLDER            of a TUM RGB-D recording (it has a depth.txt)
  sim:SCENE[:SEED[:CAMERA]]
)" +
         wrap ("a simulated frame; SCENE is one of " +
                   boost::join (sceneNames(), ", ") +
                   "; SEED is 1 or what you say; frames with the same number CAMERA "
                   "share the smooth error of depth that a camera has",
               help_width,
               20) +
         R"(
  FILE.oni          a recording of OpenNI 2
  live:[DEVICE]     a camera that OpenNI 2 knows: any, #2 for the second, or its URI
)";
}

const char base_transform_help[] =
    "where the body of the camera (x forward, y left, z up, as ROS has its "
    "camera_link, not the optical frame) is in the frame of the robot, whose z = 0 is "
    "the floor; "
    "metres and degrees: 0,0,1.2,0,30,0 is 1.2 m high and looks down by 30; without, "
    "that of a simulated camera, or else the largest plane that faces up in the image "
    "is taken for the floor, or for a table, and if none does, the largest one, even a "
    "wall: give it for obstacles";

po::options_description
inputOptionsDescription ()
{
  po::options_description description ("Input", help_width);
  description.add_options() (
      "intrinsics",
      po::value<std::string>()->value_name ("fx,fy,cx,cy"),
      "camera of depth images: focal lengths and principal point, in pixels of the "
      "full images, also with --resolution; TUM RGB-D folders have a default") (
      "depth-scale",
      po::value<std::string>()->value_name ("UNITS_PER_M"),
      "what depth images hold at 1 m; 5000 for TUM RGB-D folders") (
      "resolution",
      po::value<std::string>()
          ->value_name ("vga|qvga|qqvga")
          ->default_value ("vga", "vga; evaluations: all"),
      "take every 1st, 2nd or 4th pixel of every 1st, 2nd or 4th row: that is what the "
      "names say of frames of any size, also in tables") (
      "frames",
      po::value<std::string>()->value_name ("N"),
      "stop after N frames of each INPUT; without, a live camera gives one, but plays "
      "on in a window");
  return description;
}

InputOptions
readInputOptions (const std::string& input, const po::variables_map& values)
{
  InputOptions options;
  options.input = input;
  if (values.count ("intrinsics"))
    options.intrinsics = parseIntrinsics (values["intrinsics"].as<std::string>());
  if (values.count ("depth-scale"))
    options.units_per_metre = parseDepthScale (values["depth-scale"].as<std::string>());
  options.step = parseResolution (values["resolution"].as<std::string>());
  if (values.count ("frames"))
    options.max_frames = parseCount ("--frames", values["frames"].as<std::string>());
  return options;
}

Eigen::Affine3f
parseBaseTransform (const std::string& text)
{
  const auto v = parseNumbers ("--base-transform", text, "x,y,z,roll,pitch,yaw");
  const auto turn = [] (float degrees, const Eigen::Vector3f& axis) {
    return Eigen::AngleAxisf (pcl::deg2rad (degrees), axis).toRotationMatrix();
  };
  Eigen::Affine3f transform = Eigen::Affine3f::Identity();
  transform.translation() << v[0], v[1], v[2];
  transform.linear() =
      turn (v[5], Eigen::Vector3f::UnitZ()) * turn (v[4], Eigen::Vector3f::UnitY()) *
      turn (v[3], Eigen::Vector3f::UnitX()) * defaultCameraToBase().linear();
  return transform;
}

std::array<float, 2>
parseCoefficients (const std::string& option,
                   const std::string& text,
                   const std::string& names)
{
  const auto values = parseNumbers (option, text, names);
  const float sum = values[0] + values[1];
  if (values[0] < 0.f || values[1] < 0.f || sum == 0.f || !std::isfinite (sum))
    throw AppError (option + ": '" + text + "' must be two numbers, " + names +
                    ": 0 or more, and not both 0");
  return {values[0], values[1]};
}

void
addDepthNoiseOption (po::options_description& options)
{
  options.add_options() (
      "depth-noise",
      po::value<std::string>()->value_name ("SENSOR|CONSTANT,QUADRATIC[,SCATTER]"),
      "the sensor whose noise and range to expect, points beyond are left out: "
      "kinect_v1, if not said, any range; structured_light, up to 3.5 m: Xtion, "
      "Carmine and Astra, which are kinect_v1 where more is in view; time_of_flight, "
      "up to 5.5 m: Kinect v2 and Azure Kinect; active_stereo, up to 5 m: RealSense "
      "D4xx; frames that have more noise count as having it. Or the standard deviation "
      "in metres, at any range: 0.001,0.002 is 1 mm + 2 mm z^2; then, if need be, "
      "how many times as far as a Kinect's the normals scatter, 2.5 of stereo cameras");
}

DepthNoise
readDepthNoise (const po::variables_map& values)
{
  if (!values.count ("depth-noise"))
    return DepthNoise::kinectV1();
  if (values.count ("corrected"))
    throw AppError ("--depth-noise: the noise of corrected points is that of a Kinect "
                    "v1; leave out --depth-noise or --corrected");
  const auto& text = values["depth-noise"].as<std::string>();
  const std::map<std::string, DepthNoise> sensors{
      {"kinect_v1", DepthNoise::kinectV1()},
      {"structured_light", DepthNoise::structuredLight()},
      {"time_of_flight", DepthNoise::timeOfFlight()},
      {"active_stereo", DepthNoise::activeStereo()}};
  if (const auto known = sensors.find (text); known != sensors.end())
    return known->second;
  if (text.find (',') == std::string::npos)
    throw AppError ("--depth-noise: '" + text +
                    "' must be kinect_v1, structured_light, time_of_flight, "
                    "active_stereo or CONSTANT,QUADRATIC[,SCATTER]");
  const auto third = text.find (',', text.find (',') + 1);
  const auto [constant, quadratic] =
      parseCoefficients ("--depth-noise", text.substr (0, third), "CONSTANT,QUADRATIC");
  DepthNoise noise{constant, quadratic};
  if (third != std::string::npos)
    noise.normal_scatter = parseNumber<float> (
        "--depth-noise: the scatter", boost::trim_left_copy (text.substr (third + 1)));
  if (!(noise.normal_scatter >= 1.f &&
        noise.normal_scatter <= DepthNoise::max_normal_scatter))
    throw AppError ("--depth-noise: the scatter of normals in '" + text +
                    "' must be 1 to 5 times that of a Kinect");
  return noise;
}

std::uint32_t
parseResolution (const std::string& text)
{
  for (const std::uint32_t step : {1u, 2u, 4u})
    if (text == resolutionName (step))
      return step;
  throw AppError ("--resolution: '" + text + "' must be vga, qvga or qqvga");
}

std::string
resolutionName (std::uint32_t step)
{
  return step == 1 ? "vga" : step == 2 ? "qvga" : "qqvga";
}

unsigned
parseCount (const std::string& option, const std::string& text)
{
  const auto count = parseNumber<unsigned> (option, text);
  if (count == 0)
    throw AppError (option + ": must be 1 or more");
  return count;
}

} // namespace rgbd_planes
} // namespace pcl
