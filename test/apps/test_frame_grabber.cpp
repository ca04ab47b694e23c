// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "files.h"

#include <pcl/apps/app_error.h>
#include <pcl/apps/frame_grabber.h>
#include <pcl/apps/frame_slot.h>
#include <pcl/io/pcd_grabber.h>

#include <gtest/gtest.h>

#include <cmath>
#include <mutex>

using namespace pcl::rgbd_planes;

namespace {

/** Long enough for any machine; never waited for unless a frame is missing. */
constexpr std::chrono::seconds patience (60);

/** A folder of 2 x 2 clouds 1.pcd, 2.pcd, ...; depth is the number of the file. */
class FrameGrabberTest : public testing::Test {
protected:
  FrameGrabberTest()
  {
    for (const std::string number : {"1", "2", "3"})
      files_.push_back (addCloud (number));
    input_.input = folder_.path();
  }

  std::string
  addCloud (const std::string& number)
  {
    const std::string point = "0 0 " + number + "\n";
    const auto file = folder_ / (number + ".pcd");
    writeFile (file, asciiPcd ("x y z", 2, 2, point + point + "0 0 0\n" + point));
    return file;
  }

  const TemporaryFolder folder_;
  std::vector<std::string> files_;
  InputOptions input_;
};

std::string
nameOf (const std::optional<Frame>& frame)
{
  return frame ? frame->name : "nothing";
}

/** Plays to the end, and says what came. */
std::vector<std::string>
playAll (FrameGrabber& grabber)
{
  std::mutex mutex;
  std::condition_variable changed;
  std::vector<std::string> names;
  const auto connection = grabber.registerCallback (
      std::function<FrameGrabber::FrameSignal> ([&] (const Frame& frame) {
        const std::lock_guard<std::mutex> lock (mutex);
        names.push_back (frame.name);
        changed.notify_one();
      }));
  grabber.start();
  {
    std::unique_lock<std::mutex> lock (mutex);
    changed.wait_for (lock, patience, [&] { return names.size() == 3; });
  }
  grabber.stop();
  connection.disconnect();
  return names;
}

} // namespace

TEST_F (FrameGrabberTest, PlaysAllFramesInOrderAndAgain)
{
  FrameGrabber grabber (input_, 1000., false);
  const std::vector<std::string> all{"1", "2", "3"};
  EXPECT_EQ (playAll (grabber), all);
  EXPECT_FALSE (grabber.isRunning());
  EXPECT_EQ (playAll (grabber), all) << "from the beginning";
}

TEST_F (FrameGrabberTest, StepsGiveOneFrameEachAndEnd)
{
  FrameGrabber grabber (input_, 30., false);
  FrameSlot slot;
  slot.connect (grabber);
  for (const char* expected : {"1", "2", "3", "nothing"}) {
    grabber.trigger();
    EXPECT_EQ (nameOf (slot.take()), expected);
  }
}

TEST_F (FrameGrabberTest, ALoopStartsAgain)
{
  FrameGrabber grabber (input_, 1000., true);
  FrameSlot slot;
  slot.connect (grabber);
  for (const char* expected : {"1", "2", "3", "1", "2"}) {
    grabber.trigger();
    EXPECT_EQ (nameOf (slot.take()), expected);
  }
  grabber.start();
  for (int i = 0; i < 7; ++i)
    EXPECT_TRUE (slot.take (patience)) << "more than there are";
  EXPECT_TRUE (grabber.isRunning());
  grabber.stop();
  EXPECT_FALSE (grabber.isRunning());
}

TEST_F (FrameGrabberTest, FramesThatNobodyTakesAreDroppedForNewerOnes)
{
  FrameGrabber grabber (input_, 30., false);
  FrameSlot slot;
  slot.connect (grabber);
  for (int i = 0; i < 3; ++i)
    grabber.trigger();
  EXPECT_EQ (slot.dropped(), 2u);
  EXPECT_EQ (nameOf (slot.take()), "3");
  EXPECT_EQ (nameOf (slot.take()), "nothing");
  EXPECT_EQ (slot.dropped(), 2u);
}

TEST_F (FrameGrabberTest, RatesAreThoseOfTheRecordingOrThoseAskedFor)
{
  EXPECT_FLOAT_EQ (FrameGrabber (input_, 12., false).getFramesPerSecond(), 12.f);
  writeFile (folder_ / "depth.txt", "10.0 a.png\n10.25 b.png\n10.5 c.png\n");
  EXPECT_FLOAT_EQ (FrameGrabber (input_, 12., false).getFramesPerSecond(), 4.f);
}

TEST_F (FrameGrabberTest, ErrorsReachTheOneWhoTakes)
{
  writeFile (folder_ / "2.pcd", "no cloud");
  FrameGrabber grabber (input_, 1000., false);
  FrameSlot slot;
  slot.connect (grabber);
  grabber.trigger();
  EXPECT_EQ (nameOf (slot.take()), "1");
  grabber.trigger();
  EXPECT_THROW (slot.take(), AppError);
  EXPECT_EQ (nameOf (slot.take()), "nothing") << "an error is told once";
}

TEST_F (FrameGrabberTest, CloudsOfPclsGrabberAreFrames)
{
  // At a rate of 0, start() and trigger() of PCL 1.13 end the program.
  pcl::PCDGrabber<pcl::PointXYZ> grabber (files_.front(), 100.f, true);
  FrameSlot slot;
  slot.connect (grabber);
  grabber.start();
  const auto frame = slot.take (patience);
  grabber.stop();
  ASSERT_TRUE (frame);
  ASSERT_EQ (frame->cloud->width, 2u);
  ASSERT_EQ (frame->cloud->height, 2u);
  EXPECT_EQ ((*frame->cloud)[3].z, 1.f);
  EXPECT_TRUE (std::isnan ((*frame->cloud)[2].z)) << "(0, 0, 0) is a missing point";
}

TEST_F (FrameGrabberTest, GrabbersWithoutCloudsAreRefused)
{
  pcl::PCDGrabber<pcl::PointXYZI> grabber (files_, 0.f, false);
  FrameSlot slot;
  EXPECT_THROW (slot.connect (grabber), AppError);
}
