// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/pictures.h>
#include <pcl/apps/scene_lines.h>
#include <pcl/visualization/pcl_visualizer.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkActor;
class vtkTextActor;

namespace pcl {
namespace rgbd_planes {

/** \brief A PCLVisualizer with a cloud, lines and texts, which can be replaced. */
class ViewerWindow {
public:
  /** Takes a key, in lower case; false leaves it to PCL. */
  using KeyHandler = std::function<bool (char)>;
  /** Takes a point that was clicked on with shift; in the camera frame, metres. */
  using PickHandler = std::function<void (const Eigen::Vector3f&)>;

  /** \brief Opens the window; AppError where there is no display. The handlers are called by
   * processEvents(). */
  ViewerWindow (KeyHandler take_key, PickHandler take_point);

  ~ViewerWindow();

  /** \param[in] point_size pixels; what the user makes of it stays until another one comes */
  void
  showCloud (const pcl::PointCloud<pcl::PointXYZRGB>& cloud, int point_size);

  void
  showLines (const std::vector<ColouredLine>& lines);

  /** \brief Text at the top of the window. */
  void
  showStatus (const std::string& text);

  /** \brief Text at the bottom of the window; none where it is empty. */
  void
  showHelp (const std::string& text);

  /** \brief Looks at a scene from a little behind and above the camera that took it.
   * \param[in] cloud organized
   * \return false where there is nothing to look at */
  bool
  lookFromCamera (const pcl::PointCloud<pcl::PointXYZRGB>& cloud);

  void
  render ();

  /** \brief Handles what the user did since the last call, without waiting for more. */
  void
  processEvents ();

  /** \brief Whether the user closed it. */
  bool
  isClosed () const
  {
    return visualizer_->wasStopped();
  }

  /** \brief What is seen. */
  Picture
  picture ();

  vtkRenderWindowInteractor&
  interactor ();

private:
  std::unique_ptr<pcl::visualization::PCLVisualizer> visualizer_;
  vtkSmartPointer<vtkActor> lines_;
  vtkSmartPointer<vtkTextActor> status_, help_;
  int point_size_ = 0;
};

} // namespace rgbd_planes
} // namespace pcl
