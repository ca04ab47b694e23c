// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "files.h"
#include "viewer_scene.h"

#include <pcl/apps/encode_pcd.h>
#include <pcl/apps/frame_grabber.h>
#include <pcl/apps/plane_viewer.h>

#include <gtest/gtest.h>

#include <vtkCommand.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include <cstdlib>
#include <memory>

namespace pcl {
namespace rgbd_planes {

using viewer_scene::operator==;

/** A viewer, and a person who uses it. */
class ViewerWindowTest : public testing::Test {
protected:
  void
  SetUp () override
  {
    if (!std::getenv ("DISPLAY"))
      GTEST_SKIP() << "there is no display: install the packages xvfb and xauth";
    options_.camera_to_base = viewer_scene::cameraToBase();
    options_.output = folder_.path();
    viewer_ = std::make_unique<PlaneViewer> (options_);
  }

  void
  TearDown () override
  {
    viewer_.reset(); // before the grabber
  }

  /** Plays clouds 1.pcd, 2.pcd and 3.pcd, in which the scene is 0, 10 and 20 cm further off,
   * from a folder. Frames come when keys or trigger() ask for them. */
  void
  playFolder (bool loop = true)
  {
    std::filesystem::create_directory (folder_ / "input");
    for (const std::string number : {"1", "2", "3"}) {
      auto frame = viewer_scene::makeFrame();
      for (auto& point : *frame.cloud)
        point.z += 0.1f * (std::stof (number) - 1.f);
      writeFile (folder_ / ("input/" + number + ".pcd"), encodePcd (*frame.cloud));
    }
    InputOptions input;
    input.input = folder_ / "input";
    constexpr double never = 1e-3;
    grabber_ = std::make_unique<FrameGrabber> (input, never, loop);
    viewer_->play (*grabber_);
    updateUntil ("1, 640 x 480");
  }

  /** Until the status says so. */
  void
  updateUntil (const std::string& text)
  {
    for (int i = 0; i < 6000 && !says (text); ++i)
      viewer_->update();
    EXPECT_TRUE (says (text)) << text << " not in " << viewer_->status();
  }

  bool
  says (const std::string& text) const
  {
    return viewer_->status().find (text) != std::string::npos;
  }

  void
  press (char key)
  {
    auto& interactor = viewer_->window().interactor();
    const std::string symbol (1, key);
    interactor.SetKeyEventInformation (0, 0, key, 0, symbol.c_str());
    for (const auto event : {vtkCommand::KeyPressEvent,
                             vtkCommand::CharEvent,
                             vtkCommand::KeyReleaseEvent})
      interactor.InvokeEvent (event, nullptr);
  }

  /** \return what the terminal tells of a click with shift where a point is seen */
  std::string
  shiftClick (const Eigen::Vector3f& point)
  {
    auto& interactor = viewer_->window().interactor();
    auto& renderer = *interactor.GetRenderWindow()->GetRenderers()->GetFirstRenderer();
    renderer.SetWorldPoint (point.x(), point.y(), point.z(), 1.);
    renderer.WorldToDisplay();
    const double* pixel = renderer.GetDisplayPoint();
    interactor.SetEventInformation (
        static_cast<int> (pixel[0]), static_cast<int> (pixel[1]), 0, 1);
    testing::internal::CaptureStdout();
    interactor.InvokeEvent (vtkCommand::LeftButtonPressEvent, nullptr);
    interactor.InvokeEvent (vtkCommand::LeftButtonReleaseEvent, nullptr);
    viewer_->update();
    return testing::internal::GetCapturedStdout();
  }

  /** The pixels of a colour in the part of the window without text, in percent. */
  double
  percentOf (const pcl::RGB& colour) const
  {
    const Picture picture = viewer_->window().picture();
    std::size_t found = 0, all = 0;
    for (std::size_t i = picture.width * 200; i < picture.width * 700; ++i) {
      ++all;
      found += picture[i] == colour;
    }
    return 100. * static_cast<double> (found) / static_cast<double> (all);
  }

  /** The pixels that differ in a part of the rows, in percent. */
  static double
  difference (const Picture& a, const Picture& b, double from = 0., double to = 1.)
  {
    std::size_t different = 0, all = 0;
    for (auto i = static_cast<std::size_t> (from * static_cast<double> (a.size()));
         i < static_cast<std::size_t> (to * static_cast<double> (a.size()));
         ++i, ++all)
      different += !(a[i] == b[i]);
    return 100. * static_cast<double> (different) / static_cast<double> (all);
  }

  const TemporaryFolder folder_;
  ViewerOptions options_;
  std::unique_ptr<FrameGrabber> grabber_;
  std::unique_ptr<PlaneViewer> viewer_;
};

} // namespace rgbd_planes
} // namespace pcl
