// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "viewer_window_test.h"

#include <vtkCamera.h>

using namespace pcl::rgbd_planes;

namespace {

const pcl::RGB floor_green (40, 110, 50), yellow (255, 255, 60), white (255, 255, 255);

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
  for (std::uint32_t v = 0; v < before.height; ++v)
    EXPECT_TRUE (before (before.width - 1, v) == with_help (before.width - 1, v))
        << "a line is cut in row " << v;
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

TEST_F (ViewerWindowTest, KeyWSwitchesTheCorrection)
{
  constexpr float warp = 0.05f;
  CorrectedOption corrected{WarpSource::file, "warp.pcd", {}};
  corrected.warp.resize (640u, 480u);
  for (auto& point : corrected.warp)
    point.intensity = warp;
  options_.corrected = corrected;
  viewer_ = std::make_unique<PlaneViewer> (options_);
  viewer_->show (viewer_scene::makeFrame());
  EXPECT_TRUE (says ("shown: none   corrected"));
  const float distance = 1.f / (1.f / viewer_scene::wall_distance - warp);
  const std::string as_corrected = shiftClick ({0.f, 0.f, distance});
  EXPECT_NE (as_corrected.find (" z +3.5294 = 0, "), std::string::npos) << as_corrected;
  press ('w');
  EXPECT_FALSE (says ("corrected"));
  const std::string as_measured = shiftClick ({0.f, 0.f, viewer_scene::wall_distance});
  EXPECT_NE (as_measured.find (" z +3.0000 = 0, "), std::string::npos) << as_measured;
  press ('w');
  press ('d');
  EXPECT_TRUE (says ("scene, 320 x 240")) << "the warp is that of every 2nd pixel";
  EXPECT_TRUE (says ("   corrected"));
}

TEST_F (ViewerWindowTest, KeyWTellsWhereThereIsNoCorrection)
{
  press ('w');
  EXPECT_TRUE (says ("waiting for the first frame"));
  viewer_->show (viewer_scene::makeFrame());
  press ('w');
  EXPECT_TRUE (says ("start with --corrected"));
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
  press ('c'); // lines beside the points
  const std::string wall = shiftClick ({0.f, -0.7f, 3.f});
  EXPECT_EQ (wall.rfind ("scene: plane ", 0), 0u) << wall;
  EXPECT_NE (wall.find (" z +3.0000 = 0, "), std::string::npos) << wall;
  EXPECT_NE (wall.find (", wall\n"), std::string::npos) << wall;
  EXPECT_TRUE (says ("\nscene: plane ") && says (", wall"));
  const std::string box = shiftClick ({0.f, 0.457f, 2.f});
  EXPECT_NE (box.find (" z +2.0000 = 0, "), std::string::npos) << box;
  const std::string floor = shiftClick ({-0.27f, 0.6f, 2.62f});
  EXPECT_NE (floor.find (", floor\n"), std::string::npos)
      << "12 pixels beside the box: " << floor;
  EXPECT_TRUE (says (", floor"));
}

TEST_F (ViewerWindowTest, LongMessagesAreBroken)
{
  const std::string name (60, 'x');
  viewer_->show (viewer_scene::makeFrame (name));
  const std::string told = shiftClick ({0.f, -0.7f, 3.f});
  ASSERT_GT (told.size(), 110u);
  EXPECT_EQ (told.find ('\n'), told.size() - 1) << "one line on the terminal";
  const std::string shown = viewer_->status();
  const auto message = shown.find ('\n' + name);
  ASSERT_NE (message, std::string::npos);
  EXPECT_LE (shown.find ('\n', message + 1) - message - 1, 110u);
  EXPECT_TRUE (says (" wall"));
}

TEST_F (ViewerWindowTest, AClickWithShiftOnTheBackgroundTellsNothing)
{
  viewer_->show (viewer_scene::makeFrame());
  EXPECT_EQ (shiftClick ({0.f, -1.6f, 3.f}), "") << "above the wall";
  EXPECT_FALSE (says ("scene: "));
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
