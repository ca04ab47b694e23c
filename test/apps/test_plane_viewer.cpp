// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "app_test.h"
#include "x_client.h"
#include <sys/types.h>

#include <pcl/apps/pictures.h>
#include <pcl/apps/viewer_layers.h>

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <regex>
#include <thread>

using namespace pcl::rgbd_planes;

namespace {

class PlaneViewerApp : public AppTest {
protected:
  PlaneViewerApp() : AppTest (PLANE_VIEWER) {}

  void
  SetUp () override
  {
    if (!std::getenv ("DISPLAY"))
      GTEST_SKIP() << "there is no display: install the packages xvfb and xauth";
    // A wall, then nothing.
    writePng (folder_ / "1.png", 160, std::vector<std::uint16_t> (160 * 120, 1500));
    writePng (folder_ / "2.png", 160, std::vector<std::uint16_t> (160 * 120, 0));
  }

  /** The pixels of the colour of the first plane in the lower half, in percent. */
  double
  percentOfFirstPlane (const std::string& file) const
  {
    const RgbImage image = readRgbPng (folder_ / file);
    EXPECT_EQ (image.width, 1024u);
    EXPECT_EQ (image.height, 768u);
    const pcl::RGB colour = planeColour (0);
    std::size_t found = 0, all = 0;
    for (std::size_t i = image.samples.size() / 2; i < image.samples.size();
         i += 3, ++all)
      found += image.samples[i] == colour.r && image.samples[i + 1] == colour.g &&
               image.samples[i + 2] == colour.b;
    return 100. * static_cast<double> (found) / static_cast<double> (all);
  }

  /** Starts the application in the background; its exit code appears in the log "code". */
  pid_t
  start (const std::string& arguments) const
  {
    const Outcome result =
        shell ("(env --default-signal=INT " + application_ + " " + arguments +
               " & echo $! >&3; wait $!; echo $? >'" + (logs_ / "code").string() +
               "') 3>'" + (logs_ / "pid").string() + "' >/dev/null 2>&1 &");
    EXPECT_EQ (result.code, 0);
    EXPECT_TRUE (waitFor ([this] { return !contents ("pid").empty(); }));
    return static_cast<pid_t> (std::stol (contents ("pid")));
  }

  /** What is in a log; nothing where it is not there yet. */
  std::string
  contents (const std::string& log) const
  {
    return std::filesystem::exists (logs_ / log) ? readFile (logs_ / log) : "";
  }

  /** The exit code of what start() started, once it ended. */
  std::string
  exitCode () const
  {
    waitFor ([this] { return !contents ("code").empty(); });
    return contents ("code");
  }

  void
  expectEndBySignal (int signal)
  {
    const pid_t process = start ("sim:room --resolution qqvga");
    ASSERT_TRUE (person_.findWindow ("pcl_plane_viewer"));
    kill (process, signal);
    EXPECT_EQ (exitCode(), "0\n");
  }

  static bool
  waitFor (const std::function<bool()>& condition)
  {
    for (int i = 0; i < 600 && !condition(); ++i)
      std::this_thread::sleep_for (std::chrono::milliseconds (100));
    return condition();
  }

  /** Is there all the time: Xvfb starts anew when its last client goes. */
  XClient person_;
  const std::string intrinsics_ = " --intrinsics 131,131,79.5,59.5 --depth-scale 1000 ";
  const std::string camera_ = intrinsics_ + "--base-transform 0,0,1,0,0,0 ";
  const std::string no_display_ = "env -u DISPLAY";
};

} // namespace

TEST_F (PlaneViewerApp, ScreenshotsNeedNoDisplay)
{
  const Outcome result = run ("1.png --screenshot seen.png" + camera_, no_display_);
  ASSERT_EQ (result.code, 0) << result.err;
  EXPECT_EQ (result.err, "");
  EXPECT_GT (percentOfFirstPlane ("seen.png"), 30.);
}

TEST_F (PlaneViewerApp, SaysWhereThePoseIsAGuess)
{
  const Outcome result = run ("1.png --screenshot seen.png" + intrinsics_);
  ASSERT_EQ (result.code, 0) << result.err;
  EXPECT_EQ (
      result.err,
      "pcl_plane_viewer: pose of the camera: estimated, in 1 from plane 0 as the "
      "floor, at a distance of 1.50 m; --base-transform gives the true one\n");
}

TEST_F (PlaneViewerApp, SaysWhereACloudIsNotInTheFrameOfTheCamera)
{
  writeFile (folder_ / "up.pcd",
             asciiPcd ("x y z", 2, 2, "1 1 -1\n1 -1 -1\n1 1 1\n1 -1 1\n"));
  const Outcome result = run ("up.pcd --screenshot up.png");
  ASSERT_EQ (result.code, 0) << result.err;
  EXPECT_NE (result.err.find ("pcl_plane_viewer: in 1 of 1 frames most points are not"),
             std::string::npos)
      << result.err;
}

TEST_F (PlaneViewerApp, ScreenshotsShowTheLayersAskedFor)
{
  ASSERT_EQ (run ("1.png --show none --screenshot none.png" + camera_).code, 0);
  EXPECT_EQ (percentOfFirstPlane ("none.png"), 0.);
  ASSERT_EQ (run ("1.png --show planes --screenshot planes.png" + camera_).code, 0);
  EXPECT_GT (percentOfFirstPlane ("planes.png"), 30.);
}

TEST_F (PlaneViewerApp, ScreenshotsAreOfTheFirstFrameOrTheLastOfSoMany)
{
  ASSERT_EQ (run (". --screenshot first.png" + camera_).code, 0);
  EXPECT_GT (percentOfFirstPlane ("first.png"), 30.);
  std::filesystem::rename (folder_ / "first.png", logs_ / "first.png");
  ASSERT_EQ (run (". --frames 2 --screenshot second.png" + camera_).code, 0);
  EXPECT_EQ (percentOfFirstPlane ("second.png"), 0.);
}

TEST_F (PlaneViewerApp, WithoutADisplayItSaysWhatToDo)
{
  expectRefused ("sim:room", "there is no display", no_display_);
  expectRefused ("sim:room", "xvfb-run -a", no_display_);
  expectRefused ("sim:room", "cannot open the display ':77'", "env DISPLAY=:77");
  expectRefused ("sim:room --screenshot seen.png",
                 "cannot open the display ':77'",
                 "env DISPLAY=:77");
  expectRefused ("sim:room --screenshot seen.png",
                 "install the package xvfb",
                 "env -u DISPLAY PATH=/nonexistent");
}

TEST_F (PlaneViewerApp, BadUsageIsRefused)
{
  for (const std::string& before : {std::string(), no_display_}) {
    expectRefused ("", "no INPUT", before);
    expectRefused ("missing.pcd", "missing.pcd: no such file", before);
    expectRefused (
        "missing.pcd --screenshot seen.png", "missing.pcd: no such file", before);
  }
  expectRefused ("sim:room sim:room", "--help");
  expectRefused ("sim:room --colour red", "--help");
  expectRefused ("sim:room --show walls", "there is no 'walls'");
  expectRefused ("sim:room --rate 0", "--rate: '0' must be");
  expectRefused ("sim:room --rate fast", "--rate is 'fast'");
  expectRefused ("sim:room --frames 0", "--frames");
  expectRefused ("sim:room --resolution 1k", "vga, qvga or qqvga");
  expectRefused ("sim:room --base-transform 1,2", "x,y,z,roll,pitch,yaw");
  expectRefused ("sim:room --depth-noise sonar", "active_stereo or");
  expectRefused ("sim:room --corrected camera", "pcl_segment_planes writes");
  expectRefused ("sim:room --corrected missing.pcd", "missing.pcd");
  expectRefused ("live:missing.oni", "live:missing.oni: ");
  expectRefused ("sim:room --screenshot missing/seen.png", "missing/seen.png");
  expectRefused ("sim:room --output 1.png", "1.png: cannot create this folder");
  expectRefused ("sim:room --output /proc", "/proc/FRAME_view.png: cannot write");
  std::filesystem::create_directory (folder_ / "taken.png");
  expectRefused ("sim:room --screenshot taken.png", "no regular file");
  std::filesystem::remove (folder_ / "taken.png");
  writeFile (folder_ / "damaged.pcd", "no cloud");
  expectRefused ("damaged.pcd", "damaged.pcd");
  expectRefused ("damaged.pcd --screenshot seen.png", "damaged.pcd");
  expectRefused ("1.png --screenshot 1.png" + camera_, "1.png: is an input");
  for (const std::string name : {"seen.jpg", "seen", "damaged.pcd"})
    expectRefused ("sim:room --screenshot " + name, "must end in .png");
}

/** Ctrl-C goes to all processes that a terminal started. */
TEST_F (PlaneViewerApp, InterruptedScreenshotsLeaveNothing)
{
  for (const std::string signal : {"-INT -- -", "-TERM "}) {
    const Outcome outcome =
        shell ("rm 2.png; mkfifo 2.png; bash <<'END'\nset -m; " + no_display_ + " " +
               application_ + " . --frames 2 --screenshot seen.png" + camera_ +
               "& pid=$!; exec 3>2.png; kill " + signal +
               "$pid; cat 1.png >&3; exec 3>&-; wait $pid\nEND");
    EXPECT_EQ (outcome.code, 1);
    EXPECT_EQ (outcome.err, "pcl_plane_viewer: interrupted; nothing was written\n");
    EXPECT_EQ (listFolder (folder_.path()),
               (std::vector<std::string>{"1.png", "2.png"}));
  }
}

TEST_F (PlaneViewerApp, ItEndsWithItsDisplay)
{
  const Outcome outcome =
      shell ("rm 2.png; mkfifo 2.png; mkfifo number; "
             "Xvfb -displayfd 3 3>number 2>/dev/null & server=$!; "
             "DISPLAY=:$(head -n 1 number) " +
             application_ + " . --frames 2 --screenshot seen.png" + camera_ +
             "& pid=$!; exec 3>2.png; kill $server; wait $server; cat 1.png >&3; "
             "exec 3>&-; wait $pid");
  EXPECT_EQ (outcome.code, 1);
  EXPECT_EQ (outcome.err, "pcl_plane_viewer: the display has gone; start it again\n");
  EXPECT_EQ (listFolder (folder_.path()),
             (std::vector<std::string>{"1.png", "2.png", "number"}));
}

TEST_F (PlaneViewerApp, ItEndsAtADamagedFrame)
{
  const std::string frame = readFile (folder_ / "1.png");
  writeFile (folder_ / "2.png", frame.substr (0, frame.size() / 2));
  expectRefused (". " + camera_, "2.png: ");
  expectRefused (". --loop --rate 1000" + camera_, "2.png: ");
}

TEST_F (PlaneViewerApp, HelpTellsKeysAndOptions)
{
  const Outcome result = run ("--help", no_display_);
  ASSERT_EQ (result.code, 0) << result.err;
  EXPECT_EQ (result.err, "");
  for (const auto& layer : viewer_layers)
    EXPECT_NE (result.out.find (std::string ("  ") + layer.key + "      show or hide " +
                                layer.name),
               std::string::npos);
  for (const std::string word : {"INPUT",         "  space  ",
                                 "  .  ",         "  d  ",
                                 "  s  ",         "  r  ",
                                 "  h  ",         "  q  ",
                                 "--show",        "--screenshot",
                                 "--output",      "--rate",
                                 "--loop",        "--base-transform",
                                 "--depth-noise", "--intrinsics",
                                 "--depth-scale", "--resolution",
                                 "--frames",      "Exit code"})
    EXPECT_NE (result.out.find (word), std::string::npos) << word;
  EXPECT_FALSE (std::regex_search (result.out, std::regex ("\n *:"))) << result.out;
}

TEST_F (PlaneViewerApp, ItsWindowTakesKeys)
{
  for (const std::string arguments : {"1.png --output saved", ". --frames 1"}) {
    std::filesystem::remove (logs_ / "pid");
    std::filesystem::remove (logs_ / "code");
    start (arguments + camera_);
    ASSERT_TRUE (person_.findWindow ("pcl_plane_viewer"));
    const std::string view = arguments[0] == '1' ? "saved/1_view.png" : "1_view.png";
    // Nothing is saved before the first frame is there.
    EXPECT_TRUE (waitFor ([&] {
      person_.type ("s");
      return std::filesystem::exists (folder_ / view);
    }));
    EXPECT_GT (percentOfFirstPlane (view), 30.);
    person_.type ("q");
    EXPECT_EQ (exitCode(), "0\n");
  }
}

TEST_F (PlaneViewerApp, CtrlCEndsIt) { expectEndBySignal (SIGINT); }

TEST_F (PlaneViewerApp, TerminationEndsIt) { expectEndBySignal (SIGTERM); }
