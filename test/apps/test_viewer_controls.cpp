// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "viewer_window_test.h"
#include <sys/resource.h>

#include <pcl/io/pcd_grabber.h>

#include <algorithm>
#include <csignal>
#include <utility>

using namespace pcl::rgbd_planes;

using ViewerControlsTest = ViewerWindowTest;

TEST_F (ViewerControlsTest, SpacePausesAndGoesOn)
{
  playFolder();
  EXPECT_TRUE (grabber_->isRunning());
  EXPECT_TRUE (says ("playing"));
  press (' ');
  EXPECT_FALSE (grabber_->isRunning());
  EXPECT_TRUE (says ("paused"));
  press (' ');
  updateUntil ("2, 640 x 480");
  EXPECT_TRUE (grabber_->isRunning());
  EXPECT_TRUE (says ("playing"));
}

TEST_F (ViewerControlsTest, PointStepsThroughFrames)
{
  playFolder();
  for (const std::string number : {"2", "3", "1", "2"}) {
    press ('.');
    updateUntil (number + ", 640 x 480");
    EXPECT_TRUE (says ("paused"));
  }
}

TEST_F (ViewerControlsTest, SpaceStartsAgainAtTheEnd)
{
  playFolder (false);
  for (const std::string number : {"2", "3"}) {
    press ('.');
    updateUntil (number + ", 640 x 480");
  }
  press ('.');
  viewer_->update();
  EXPECT_TRUE (says ("3, 640 x 480")) << "the last one";
  press (' ');
  updateUntil ("1, 640 x 480");
}

TEST_F (ViewerControlsTest, KeyDChangesTheResolution)
{
  playFolder();
  for (const std::string size : {"320 x 240", "160 x 120", "640 x 480"}) {
    press ('d');
    EXPECT_TRUE (says ("1, " + size)) << viewer_->status();
    EXPECT_GT (percentOf (viewer_scene::camera_colour), 50.) << "points grow";
  }
  press ('d');
  press ('.');
  updateUntil ("2, 320 x 240");
}

TEST_F (ViewerControlsTest, KeySSavesTheViewAndTheFrame)
{
  viewer_->show (viewer_scene::makeFrame ("frame_7"));
  press ('p');
  const Picture seen = viewer_->window().picture();
  testing::internal::CaptureStdout();
  press ('s');
  EXPECT_NE (testing::internal::GetCapturedStdout().find ("saved"), std::string::npos);
  EXPECT_TRUE (says ("\nsaved "));
  EXPECT_EQ (listFolder (folder_.path()),
             (std::vector<std::string>{"frame_7_view.pcd", "frame_7_view.png"}));

  const RgbImage image = readRgbPng (folder_ / "frame_7_view.png");
  ASSERT_EQ (image.width, seen.width);
  ASSERT_EQ (image.height, seen.height);
  std::size_t same = 0;
  for (std::size_t i = 0; i < seen.size(); ++i)
    same += seen[i].r == image.samples[3 * i] &&
            seen[i].g == image.samples[3 * i + 1] &&
            seen[i].b == image.samples[3 * i + 2];
  EXPECT_EQ (same, seen.size());
  InputOptions input;
  input.input = folder_ / "frame_7_view.pcd";
  const auto cloud = FrameSource (input).read (0).cloud;
  const auto truth = viewer_scene::makeFrame().cloud;
  ASSERT_EQ (cloud->width, truth->width);
  ASSERT_EQ (cloud->height, truth->height);
  for (std::size_t i = 0; i < cloud->size(); i += 1001) {
    EXPECT_EQ ((*cloud)[i].getVector3fMap(), (*truth)[i].getVector3fMap());
    EXPECT_EQ ((*cloud)[i].g, viewer_scene::camera_colour.g) << "as the camera saw it";
  }
}

TEST_F (ViewerControlsTest, InputsAreNotReplacedByViews)
{
  for (const std::string name : {"scene_view.pcd", "scene_view.png"}) {
    writeFile (folder_ / name, "input");
    options_.inputs = {folder_ / name};
    viewer_.reset();
    viewer_ = std::make_unique<PlaneViewer> (options_);
    viewer_->show (viewer_scene::makeFrame());
    press ('s');
    EXPECT_TRUE (says (": is an input"));
    EXPECT_EQ (listFolder (folder_.path()), std::vector<std::string>{name});
    EXPECT_EQ (readFile (folder_ / name), "input");
    std::filesystem::remove (folder_ / name);
  }
}

TEST_F (ViewerControlsTest, FoldersThatCannotBeThereAreTold)
{
  writeFile (folder_ / "file", "");
  std::filesystem::create_symlink ("loop", folder_ / "loop");
  for (const std::string name : {"file", "file/folder", "loop/folder"}) {
    options_.output = folder_ / name;
    viewer_.reset();
    viewer_ = std::make_unique<PlaneViewer> (options_);
    viewer_->show (viewer_scene::makeFrame());
    press ('s');
    EXPECT_TRUE (says ((folder_ / name.substr (0, 4)).string())) << viewer_->status();
    EXPECT_FALSE (says ("\nsaved "));
    EXPECT_TRUE (viewer_->update()) << "goes on";
  }
  EXPECT_EQ (listFolder (folder_.path()), (std::vector<std::string>{"file", "loop"}));
}

/** As where a disk has room for one file of two. */
TEST_F (ViewerControlsTest, HalfOfWhatIsSavedDoesNotStay)
{
  viewer_->show (viewer_scene::makeFrame());
  press ('s');
  std::uintmax_t largest = 0;
  for (const auto& file : listFolder (folder_.path())) {
    largest = std::max (largest, std::filesystem::file_size (folder_ / file));
    std::filesystem::remove (folder_ / file);
  }
  std::signal (SIGXFSZ, SIG_IGN);
  rlimit limit{};
  getrlimit (RLIMIT_FSIZE, &limit);
  const rlim_t all = std::exchange (limit.rlim_cur, largest - 1);
  setrlimit (RLIMIT_FSIZE, &limit);
  press ('s');
  limit.rlim_cur = all;
  setrlimit (RLIMIT_FSIZE, &limit);
  EXPECT_TRUE (says (": cannot write this file: File too large")) << viewer_->status();
  EXPECT_TRUE (listFolder (folder_.path()).empty());
  press ('s');
  EXPECT_TRUE (says ("\nsaved ")) << "once there is room";
}

TEST_F (ViewerControlsTest, FramesThatAreNotShownAreCounted)
{
  playFolder();
  press (' ');
  for (int i = 0; i < 3; ++i)
    grabber_->trigger();
  viewer_->update();
  EXPECT_TRUE (says ("1, 640 x 480")) << "after 2 and 3";
  EXPECT_TRUE (says (" frames/s, 2 dropped, ")) << viewer_->status();
}

TEST_F (ViewerControlsTest, KeysBeforeTheFirstFrameDoNoHarm)
{
  for (const char key : "pcnobv .dsrh")
    if (key != '\0')
      press (key);
  EXPECT_TRUE (viewer_->update());
  EXPECT_TRUE (says ("waiting for the first frame"));
  EXPECT_TRUE (listFolder (folder_.path()).empty());
}

TEST_F (ViewerControlsTest, PlaysAnyGrabberAsFarAsAsked)
{
  writeFile (folder_ / "1.pcd", encodePcd (*viewer_scene::makeFrame().cloud));
  options_.max_frames = 2;
  viewer_.reset();
  viewer_ = std::make_unique<PlaneViewer> (options_);
  pcl::PCDGrabber<pcl::PointXYZRGB> grabber (folder_ / "1.pcd", 100.f, true);
  viewer_->play (grabber);
  updateUntil ("paused");
  EXPECT_TRUE (says ("640 x 480: 3 planes"));
  EXPECT_FALSE (grabber.isRunning());
  press ('.');
  updateUntil ("playing");
  updateUntil ("paused");
  viewer_.reset();
}
