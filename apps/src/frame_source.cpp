// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/app_error.h>
#include <pcl/apps/depth_camera.h>
#include <pcl/apps/frame_files.h>
#include <pcl/apps/frame_slot.h>
#include <pcl/apps/frame_source.h>
#include <pcl/apps/frame_truth.h>
#include <pcl/apps/interruption.h>
#include <pcl/apps/live_grabber.h>
#include <pcl/apps/organized_pcd.h>
#include <pcl/apps/parse_number.h>
#include <pcl/apps/tum_list.h>
#include <pcl/simulation/simulate.h>
#include <pcl/simulation/subsample.h>

#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/split.hpp>

#include <algorithm>
#include <memory>
#include <set>
#include <system_error>

namespace fs = std::filesystem;

namespace pcl {
namespace rgbd_planes {

namespace {

constexpr char simulated[] = "sim:";

struct PngFiles {
  std::vector<fs::path> depth_images;
  std::vector<fs::path> pictures;
};

PngFiles
listPngFiles (const fs::path& folder)
{
  auto files = listFrames (folder, ".png");
  // A pipe can be read only once.
  const auto pictures =
      std::stable_partition (files.begin(), files.end(), [] (const auto& file) {
        return !fs::is_regular_file (file) || !isOtherPng (file);
      });
  return {{files.begin(), pictures}, {pictures, files.end()}};
}

void
refuseDepthOptions (const InputOptions& options, const std::string& input)
{
  if (options.intrinsics || options.units_per_metre)
    throw AppError (input +
                    ": --intrinsics and --depth-scale are for depth images; leave "
                    "them out");
}

} // namespace

FrameSource::FrameSource (const InputOptions& options) : options_ (options)
{
  const std::string& input = options_.input;
  std::error_code error; // of names that are too long, for instance
  const fs::file_status status = fs::status (input, error);
  if (boost::starts_with (input, simulated))
    addSimulated (input.substr (sizeof (simulated) - 1));
  else if (const auto device = liveDevice (input))
    addLive (*device);
  else if (fs::is_directory (status))
    addFolder (input);
  else if (fs::exists (status))
    addFile (input);
  else if (error == std::errc::permission_denied)
    throw AppError (input + ": " + error.message());
  else
    throw AppError (
        input + ": no such file or folder; INPUT is a .pcd file, a depth .png, "
                "a folder of either, a TUM RGB-D folder, sim:SCENE[:SEED[:CAMERA]], "
                "an .oni file or live:[DEVICE]");

  std::set<std::string> names;
  for (const auto& frame : frames_)
    if (!names.insert (frame.name).second)
      throw AppError (input + ": more than one frame is named '" + frame.name +
                      "'; give each its own name");
  frames_.resize (std::min (frames_.size(), options_.max_frames));
}

std::set<fs::path>
FrameSource::folders() const
{
  std::set<fs::path> folders;
  std::error_code error; // of URIs of cameras
  for (const auto& file : files_)
    if (fs::exists (file, error))
      folders.insert (file.parent_path() / ".");
  return folders;
}

void
FrameSource::refusePipes() const
{
  std::error_code error; // of URIs of cameras
  for (const auto& file : files_)
    if (fs::is_fifo (file, error))
      throw AppError (file.string() +
                      ": a pipe can be read only once, and this reads all frames more "
                      "than once; give a file");
}

Frame
FrameSource::read (std::size_t i) const
{
  const StoredFrame& stored = frames_[i];
  Frame frame;
  frame.name = stored.name;
  try {
    stored.read (frame);
  }
  catch (...) {
    stopIfInterrupted();
    throw;
  }
  if (frame.cloud->width < 2 || frame.cloud->height < 2)
    throw AppError (options_.input + ": frame " + frame.name + " is " +
                    std::to_string (frame.cloud->width) + " x " +
                    std::to_string (frame.cloud->height) +
                    "; give images with at least 2 x 2 pixels");
  if (options_.step == 1)
    return frame;
  *frame.cloud = subsample (*frame.cloud, options_.step);
  if (frame.truth)
    *frame.truth = subsample (*frame.truth, options_.step);
  frame.labels.points = subsample (frame.labels.points, options_.step);
  if (frame.cloud->width < 2 || frame.cloud->height < 2)
    throw AppError (options_.input + ": frame " + frame.name +
                    " is too small for this --resolution; use --resolution vga");
  return frame;
}

void
FrameSource::addSimulated (const std::string& description)
{
  std::vector<std::string> parts; // scene, seed, camera
  boost::split (parts, description, [] (char c) { return c == ':'; });
  const std::string& scene = parts[0];
  const auto& names = sceneNames();
  if (std::find (names.begin(), names.end(), scene) == names.end()) {
    throw AppError (options_.input + ": unknown scene '" + scene + "'; known are " +
                    boost::join (names, ", "));
  }
  if (parts.size() > 3)
    throw AppError (options_.input + ": more than SCENE:SEED:CAMERA; leave out what "
                                     "follows the camera");
  const auto number = [&] (std::size_t part, const char* name) {
    return parseNumber<unsigned> (options_.input + ": the " + name, parts[part]);
  };
  const unsigned seed = parts.size() > 1 ? number (1, "seed") : 1;
  std::optional<unsigned> camera;
  if (parts.size() > 2)
    camera = number (2, "camera");
  refuseDepthOptions (options_, options_.input);
  frames_.push_back ({scene + '_' + std::to_string (seed) +
                          (camera ? '_' + std::to_string (*camera) : std::string()),
                      [scene, seed, camera] (Frame& frame) {
                        SimulatedFrame simulated_frame =
                            simulate (scene, seed, Sensor::kinect, camera);
                        frame.cloud = simulated_frame.cloud;
                        frame.truth = simulated_frame.truth;
                        frame.true_planes = simulated_frame.planes;
                        frame.true_objects = simulated_frame.objects;
                        frame.camera_to_base = simulated_frame.camera_to_base;
                      }});
}

void
FrameSource::addLive (const std::string& device)
{
  refuseDepthOptions (options_, options_.input);
  files_.emplace_back (device); // it may be a recording
  struct Feed {
    FrameSlot slot;
    std::unique_ptr<pcl::Grabber> grabber;
  };
  const auto camera = std::make_shared<Feed>();
  camera->grabber = openLiveGrabber (device);
  camera->slot.connect (*camera->grabber);
  camera->grabber->start();
  const auto read = [camera, input = options_.input] (Frame& frame) {
    constexpr std::chrono::seconds patience (5);
    const auto newest = camera->slot.take (patience);
    if (!newest)
      throw AppError (input +
                      ": no frame came for 5 s; check the camera or the recording");
    frame.cloud = newest->cloud;
  };
  constexpr auto all = std::numeric_limits<std::size_t>::max();
  const std::size_t frames = options_.max_frames == all ? 1 : options_.max_frames;
  for (std::size_t i = 1; i <= frames; ++i)
    frames_.push_back ({"live_" + std::to_string (i), read});
}

void
FrameSource::addFolder (const fs::path& folder)
{
  if (fs::exists (folder / "depth.txt"))
    return addTumFolder (folder);
  const auto clouds = listFrames (folder, ".pcd");
  const auto [images, pictures] = listPngFiles (folder);
  const bool asks_for_images = options_.intrinsics || options_.units_per_metre;
  const bool takes_images = !images.empty() && (clouds.empty() || asks_for_images);
  const auto tell = [&] (std::size_t count, const char* what) {
    if (count > 0)
      printNotice (folder.string() + ": " + std::to_string (count) + ' ' + what);
  };
  if (takes_images) {
    tell (clouds.size(),
          ".pcd files are left out, for there is a camera of depth images");
    tell (pictures.size(), ".png files are no depth images and left out");
  }
  else
    tell (
        images.size(),
        "depth images are left out, for there are .pcd files; --intrinsics takes them");
  // Of pictures alone, the first one says what is wrong.
  const auto& files = takes_images ? images : clouds.empty() ? pictures : clouds;
  if (files.empty())
    throw AppError (folder.string() +
                    ": no .pcd, no .png and no depth.txt in this folder" +
                    (fs::is_directory (folder / "depth")
                         ? "; did you mean " + (folder / "depth").string() + "?"
                         : "; give the folder that holds the frames"));
  for (const auto& file : files)
    addFile (file);
}

void
FrameSource::addTumFolder (const fs::path& folder)
{
  const fs::path list = folder / "depth.txt";
  const auto [images, freiburg3] = readTumList (list);

  // The calibrations the benchmark recommends for its registered depth images.
  const Intrinsics tum_camera = freiburg3 ? Intrinsics{535.4f, 539.2f, 320.1f, 247.6f}
                                          : Intrinsics{525.f, 525.f, 319.5f, 239.5f};
  const bool guessed = !options_.intrinsics;
  options_.intrinsics = options_.intrinsics.value_or (tum_camera);
  options_.units_per_metre = options_.units_per_metre.value_or (5000.f);
  const DepthCamera camera{
      *options_.intrinsics, *options_.units_per_metre, guessed, camera_doubt_is_told_};
  files_ = otherTumFiles (folder);
  files_.push_back (list);
  for (const auto& [time, path] : images) {
    files_.push_back (path);
    frames_.push_back ({path.stem(),
                        [path = path, camera] (Frame& frame) {
                          frame.cloud = readDepthImage (path, camera);
                        },
                        time});
  }
}

void
FrameSource::addFile (const fs::path& file)
{
  files_.push_back (file);
  if (hasExtension (file, ".pcd")) {
    refuseDepthOptions (options_, file);
    for (const auto& truth : truthFiles (file))
      files_.push_back (truth);
    frames_.push_back ({file.stem(), [file] (Frame& frame) {
                          frame.cloud = readOrganizedPcd (file, &frame.labels);
                          readTruth (file, frame);
                        }});
    return;
  }
  if (!hasExtension (file, ".png"))
    throw AppError (file.string() + ": neither a .pcd nor a .png file" +
                    (file.filename() == "depth.txt" ? "; give its folder"
                                                    : "; give one, or a recording"));
  if (!options_.intrinsics)
    throw AppError (file.string() +
                    ": a depth image needs its camera: add --intrinsics "
                    "fx,fy,cx,cy (pixels)");
  if (!options_.units_per_metre)
    throw AppError (file.string() + ": a depth image needs its unit: add --depth-scale "
                                    "UNITS_PER_M (1000 for millimetres)");
  const DepthCamera camera{
      *options_.intrinsics, *options_.units_per_metre, false, camera_doubt_is_told_};
  frames_.push_back ({file.stem(), [=] (Frame& frame) {
                        frame.cloud = readDepthImage (file, camera);
                      }});
}

} // namespace rgbd_planes
} // namespace pcl
