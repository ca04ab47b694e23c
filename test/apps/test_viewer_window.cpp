// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "files.h"
#include "viewer_scene.h"

#include <pcl/apps/encode_pcd.h>
#include <pcl/apps/frame_grabber.h>
#include <pcl/apps/plane_viewer.h>
#include <pcl/io/pcd_grabber.h>

#include <gtest/gtest.h>

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include <cmath>
#include <cstdlib>

using namespace pcl::rgbd_planes;
using viewer_scene::operator==;

namespace {

const pcl::RGB floor_green (40, 110, 50), yellow (255, 255, 60), white (255, 255, 255);

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
  playFolder ()
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
    grabber_ = std::make_unique<FrameGrabber> (input, never, true);
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

  /** \param[in] u of a window of 1024 pixels */
  void
  shiftClick (int u, int v)
  {
    auto& interactor = viewer_->window().interactor();
    interactor.SetEventInformationFlipY (u, v, 0, 1);
    interactor.InvokeEvent (vtkCommand::LeftButtonPressEvent, nullptr);
    interactor.InvokeEvent (vtkCommand::LeftButtonReleaseEvent, nullptr);
    viewer_->update();
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

} // namespace

TEST_F (ViewerWindowTest, ShowsWhatTheCameraSees)
{
  EXPECT_EQ (percentOf (viewer_scene::camera_colour), 0.);
  viewer_->show (viewer_scene::makeFrame());
  EXPECT_TRUE (says ("scene, 640 x 480: 3 planes, 1 objects, "));
  EXPECT_TRUE (says ("shown: none"));
  for (const std::string stage :
       {"normals", "refinement", "objects", "obstacles", "total"})
    EXPECT_TRUE (says ("\n" + stage + " ")) << stage;
  EXPECT_GT (percentOf (viewer_scene::camera_colour), 50.);
}

TEST_F (ViewerWindowTest, KeyPSwitchesPlanes)
{
  viewer_->show (viewer_scene::makeFrame());
  press ('p');
  EXPECT_TRUE (says ("shown: planes"));
  EXPECT_EQ (percentOf (viewer_scene::camera_colour), 0.);
  double planes = 0.;
  for (std::uint32_t id = 0; id < 3; ++id) {
    EXPECT_GT (percentOf (planeColour (id)), 0.3) << id;
    planes += percentOf (planeColour (id));
  }
  EXPECT_GT (planes, 50.);
  press ('P');
  EXPECT_TRUE (says ("shown: none"));
  EXPECT_GT (percentOf (viewer_scene::camera_colour), 50.);
}

TEST_F (ViewerWindowTest, KeyCSwitchesContours)
{
  viewer_->show (viewer_scene::makeFrame());
  const double surface = percentOf (viewer_scene::camera_colour);
  press ('c');
  EXPECT_TRUE (says ("shown: contours"));
  for (std::uint32_t id = 0; id < 3; ++id)
    EXPECT_GT (percentOf (planeColour (id)), 0.005) << id;
  EXPECT_LT (percentOf (viewer_scene::camera_colour), surface);
  press ('c');
  EXPECT_EQ (percentOf (viewer_scene::camera_colour), surface);
}

TEST_F (ViewerWindowTest, KeyNSwitchesNormals)
{
  viewer_->show (viewer_scene::makeFrame());
  press ('n');
  EXPECT_TRUE (says ("shown: normals"));
  EXPECT_GT (percentOf (white), 0.5);
  press ('n');
  EXPECT_EQ (percentOf (white), 0.);
}

TEST_F (ViewerWindowTest, KeyOSwitchesObjects)
{
  viewer_->show (viewer_scene::makeFrame());
  press ('o');
  EXPECT_TRUE (says ("shown: objects"));
  constexpr std::uint32_t planes = 3;
  EXPECT_GT (percentOf (planeColour (planes)), 0.3)
      << "the colour after those of planes";
  EXPECT_GT (percentOf (white) + percentOf ({255, 40, 40}), 0.02) << "the box";
  press ('o');
  EXPECT_EQ (percentOf (planeColour (planes)), 0.);
}

TEST_F (ViewerWindowTest, KeyBSwitchesObstacles)
{
  viewer_->show (viewer_scene::makeFrame());
  press ('b');
  EXPECT_TRUE (says ("shown: obstacles"));
  EXPECT_GT (percentOf (floor_green), 5.);
  EXPECT_LT (percentOf (viewer_scene::camera_colour), 0.5);
  press ('b');
  EXPECT_EQ (percentOf (floor_green), 0.);
}

TEST_F (ViewerWindowTest, KeyVSwitchesTheScan)
{
  viewer_->show (viewer_scene::makeFrame());
  press ('v');
  EXPECT_TRUE (says ("shown: scan"));
  EXPECT_GT (percentOf (yellow), 0.05);
  press ('v');
  EXPECT_EQ (percentOf (yellow), 0.);
}

TEST_F (ViewerWindowTest, SpacePausesAndGoesOn)
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

TEST_F (ViewerWindowTest, PointStepsThroughFrames)
{
  playFolder();
  for (const std::string number : {"2", "3", "1", "2"}) {
    press ('.');
    updateUntil (number + ", 640 x 480");
    EXPECT_TRUE (says ("paused"));
  }
}

TEST_F (ViewerWindowTest, KeyDChangesTheResolution)
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

TEST_F (ViewerWindowTest, KeySSavesTheViewAndTheFrame)
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

TEST_F (ViewerWindowTest, NothingIsSavedAmongTheInputs)
{
  options_.input = options_.output;
  viewer_.reset();
  viewer_ = std::make_unique<PlaneViewer> (options_);
  viewer_->show (viewer_scene::makeFrame());
  press ('s');
  EXPECT_TRUE (says ("choose another folder"));
  EXPECT_TRUE (listFolder (folder_.path()).empty());
}

TEST_F (ViewerWindowTest, KeyRLooksFromTheCameraAgain)
{
  viewer_->show (viewer_scene::makeFrame());
  const Picture before = viewer_->window().picture();
  auto& window = *viewer_->window().interactor().GetRenderWindow();
  window.GetRenderers()->GetFirstRenderer()->GetActiveCamera()->Azimuth (40.);
  EXPECT_GT (difference (before, viewer_->window().picture()), 10.);
  press ('r');
  EXPECT_EQ (difference (before, viewer_->window().picture()), 0.);
}

TEST_F (ViewerWindowTest, KeyHShowsHelpAndHidesIt)
{
  viewer_->show (viewer_scene::makeFrame());
  const Picture before = viewer_->window().picture();
  press ('h');
  const Picture with_help = viewer_->window().picture();
  EXPECT_GT (difference (before, with_help, 0.7, 1.), 30.) << "on a dark ground";
  EXPECT_EQ (difference (before, with_help, 0., 0.2), 0.);
  press ('h');
  EXPECT_EQ (difference (before, viewer_->window().picture()), 0.);
  for (const auto& layer : viewer_layers)
    EXPECT_NE (viewerKeysHelp().find (std::string ("  ") + layer.key + "   "),
               std::string::npos)
        << layer.name;
}

TEST_F (ViewerWindowTest, PlusAndMinusChangeThePoints)
{
  viewer_->show (viewer_scene::makeFrame());
  press ('d');
  press ('d');
  const Picture before = viewer_->window().picture();
  press ('+');
  press ('+');
  EXPECT_GT (difference (before, viewer_->window().picture()), 0.1);
  press ('-');
  press ('-');
  EXPECT_EQ (difference (before, viewer_->window().picture()), 0.);
}

TEST_F (ViewerWindowTest, KeyQEnds)
{
  viewer_->show (viewer_scene::makeFrame());
  EXPECT_TRUE (viewer_->update());
  press ('q');
  EXPECT_FALSE (viewer_->update());
}

TEST_F (ViewerWindowTest, AClickWithShiftTellsThePlane)
{
  viewer_->show (viewer_scene::makeFrame());
  testing::internal::CaptureStdout();
  shiftClick (512, 250);
  const std::string wall = testing::internal::GetCapturedStdout();
  EXPECT_EQ (wall.rfind ("scene: plane ", 0), 0u) << wall;
  EXPECT_NE (wall.find (", wall\n"), std::string::npos) << wall;
  EXPECT_TRUE (says ("\nscene: plane ") && says (", wall"));
  testing::internal::CaptureStdout();
  shiftClick (300, 590);
  const std::string floor = testing::internal::GetCapturedStdout();
  EXPECT_NE (floor.find (", floor\n"), std::string::npos) << floor;
  EXPECT_TRUE (says (", floor"));
}

TEST_F (ViewerWindowTest, FramesThatAreNotShownAreCounted)
{
  playFolder();
  press (' ');
  for (int i = 0; i < 3; ++i)
    grabber_->trigger();
  viewer_->update();
  EXPECT_TRUE (says ("1, 640 x 480")) << "after 2 and 3";
  EXPECT_TRUE (says (" frames/s, 2 dropped, ")) << viewer_->status();
}

TEST_F (ViewerWindowTest, TheFirstPointsAreLookedAt)
{
  auto dark = viewer_scene::makeFrame();
  for (auto& point : *dark.cloud)
    point.x = point.y = point.z = synthetic::nan;
  viewer_->show (dark);
  EXPECT_TRUE (says ("0 planes"));
  viewer_->show (viewer_scene::makeFrame());
  EXPECT_GT (percentOf (viewer_scene::camera_colour), 50.);
}

TEST_F (ViewerWindowTest, KeysBeforeTheFirstFrameDoNoHarm)
{
  for (const char key : "pcnobv .dsrh")
    if (key != '\0')
      press (key);
  EXPECT_TRUE (viewer_->update());
  EXPECT_TRUE (says ("waiting for the first frame"));
  EXPECT_TRUE (listFolder (folder_.path()).empty());
}

TEST_F (ViewerWindowTest, PlaysAnyGrabberAsFarAsAsked)
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
