// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/depth_image.h>
#include <pcl/apps/point_labels.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/simulation/simulate.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief What the user said about the input of an application. */
struct InputOptions {
  /** A .pcd file, a folder of them, a 16-bit depth .png, a folder of them, a TUM RGB-D
   * folder (it has a depth.txt), sim:SCENE[:SEED[:CAMERA]], or live:[DEVICE], see
   * openLiveGrabber(). */
  std::string input;
  /** Needed for depth images, but for TUM RGB-D folders with frames of 640 x 480. */
  std::optional<Intrinsics> intrinsics;
  /** What a depth image holds at 1 m; TUM RGB-D folders have 5000 unless told
   * otherwise. */
  std::optional<float> units_per_metre;
  /** Every step-th pixel is taken: from VGA, 1 gives VGA, 2 QVGA and 4 QQVGA. */
  std::uint32_t step = 1;
  /** A live camera gives one frame, unless this says how many. */
  std::size_t max_frames = std::numeric_limits<std::size_t>::max();
};

struct Frame {
  /** Can be (the start of) a file name; no two frames of a source share one. */
  std::string name;
  /** Organized, in the camera frame (x right, y down, z forward), metres; NaN where
   * depth is missing, black where colour is unknown. */
  pcl::PointCloud<pcl::PointXYZRGB>::Ptr cloud;
  /** What the pixels of a simulated frame truly see, rendered now or by pcl_simulate_rgbd; null
   * for others. */
  pcl::PointCloud<TruthPoint>::Ptr truth;
  /** The planes of a simulated frame, see SimulatedFrame::planes. */
  std::vector<Eigen::Vector4f> true_planes;
  /** The loose things of a simulated frame, see SimulatedFrame::objects. */
  std::vector<TrueObject> true_objects;
  /** Where the camera of a simulated frame is, see SimulatedFrame::camera_to_base. */
  std::optional<Eigen::Affine3f> camera_to_base;
  /** What a .pcd file says about its points. */
  PointLabels labels;
};

/** \brief The frames of an INPUT, each read when it is asked for. Throws AppError where
 * the input, an option or a frame is not as it should be. */
class FrameSource {
public:
  explicit FrameSource (const InputOptions& options);

  /** \brief At least 1. */
  std::size_t
  size () const
  {
    return frames_.size();
  }

  /** \brief What the user said, and what TUM RGB-D folders have unless told otherwise. */
  const InputOptions&
  options () const
  {
    return options_;
  }

  /** \brief Reads frame \a i, 0 <= i < size(). Files of a folder come as
   * listFrames() lists them, those of a TUM RGB-D folder as their list does. */
  Frame
  read (std::size_t i) const;

  /** \brief Frame::name of frame \a i. */
  const std::string&
  name (std::size_t i) const
  {
    return frames_[i].name;
  }

  /** \brief The files that frames are read from, and those that list them, also of frames
   * beyond InputOptions::max_frames, and what a TUM RGB-D folder has beside depth. */
  const std::vector<std::filesystem::path>&
  files () const
  {
    return files_;
  }

  /** \brief The folders that hold files(). */
  std::set<std::filesystem::path>
  folders () const;

  /** \brief Throws AppError where one of files() is a pipe: for those who read frames twice. */
  void
  refusePipes () const;

  /** \brief When frame \a i was recorded, seconds; only TUM RGB-D folders know. */
  std::optional<double>
  time (std::size_t i) const
  {
    return frames_[i].time;
  }

private:
  struct StoredFrame {
    std::string name;
    /** Fills in all but the name. */
    std::function<void (Frame&)> read;
    std::optional<double> time = std::nullopt;
  };

  void
  addSimulated (const std::string& description);

  void
  addLive (const std::string& device);

  void
  addFolder (const std::filesystem::path& folder);

  void
  addTumFolder (const std::filesystem::path& folder);

  void
  addFile (const std::filesystem::path& file);

  InputOptions options_;
  std::vector<std::filesystem::path> files_;
  std::vector<StoredFrame> frames_;
  /** Of depth images that are read, also by copies. */
  std::shared_ptr<bool> camera_doubt_is_told_ = std::make_shared<bool> (false);
};

} // namespace rgbd_planes
} // namespace pcl
