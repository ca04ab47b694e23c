// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "files.h"
#include "frame_source_test.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

using namespace pcl::rgbd_planes;

namespace {

const std::string square = "0 0 1\n0 0 2\n0 0 3\n0 0 4\n";

} // namespace

TEST (FrameSource, FilesComeInNaturalOrder)
{
  const TemporaryFolder folder;
  for (const char* name : {"10.png",
                           "2.png",
                           "1.png",
                           "\u00e4.png",
                           "a10b2.png",
                           "a9b10.png",
                           "a9b9.png",
                           "007.png"})
    writePng (folder / name, 2, {1, 2, 3, 4});
  writeFile (folder / ".hidden.png", "");
  writeFile (folder / "notes.txt", "");
  std::filesystem::create_directory (folder / "folder.png");
  const FrameSource source (depthInputOf (folder.path()));
  EXPECT_EQ (namesOf (source),
             (std::vector<std::string>{
                 "1", "2", "007", "10", "a9b9", "a9b10", "a10b2", "\u00e4"}));
}

TEST (FrameSource, EndingsMayBeInLargeLetters)
{
  const TemporaryFolder images, clouds;
  writePng (images / "1.PNG", 2, {1, 2, 3, 4});
  writePng (images / "2.png", 2, {1, 2, 3, 4});
  EXPECT_EQ (namesOf (FrameSource (depthInputOf (images.path()))),
             (std::vector<std::string>{"1", "2"}));
  for (const char* name : {"3.PCD", "3_view.pcd", "4.Pcd"})
    writeFile (clouds / name, asciiPcd ("x y z", 2, 2, square));
  EXPECT_EQ (namesOf (FrameSource (inputOf (clouds.path()))),
             (std::vector<std::string>{"3", "4"}));
}

TEST (FrameSource, ColourImagesBetweenDepthImagesAreNoFrames)
{
  const TemporaryFolder folder;
  const auto writeColour = [&] (const char* name) {
    writePng (folder / name, 2, std::vector<std::uint16_t> (12), {8, 3, false, 0.});
  };
  writeColour ("1-colour.png");
  EXPECT_TRUE (
      contains (messageOf (depthInputOf (folder.path())), "not a depth image"));
  for (const char* name : {"2-depth.png", "10-depth.png", "1-depth.png"})
    writePng (folder / name, 2, {1, 2, 3, 4});
  writeColour ("2-colour.png");
  testing::internal::CaptureStderr();
  const FrameSource source (depthInputOf (folder.path()));
  EXPECT_TRUE (contains (testing::internal::GetCapturedStderr(), ": 2 .png files"));
  EXPECT_EQ (namesOf (source),
             (std::vector<std::string>{"1-depth", "2-depth", "10-depth"}));
}

TEST (FrameSource, CloudsAndDepthImagesInOneFolderAreTold)
{
  const TemporaryFolder folder;
  writeFile (folder / "cloud.pcd", asciiPcd ("x y z", 2, 2, square));
  writePng (folder / "picture.png", 2, {1, 2, 3, 4}, {8, 1, false, 0.});
  testing::internal::CaptureStderr();
  EXPECT_EQ (namesOf (FrameSource (inputOf (folder.path()))),
             std::vector<std::string>{"cloud"});
  EXPECT_EQ (testing::internal::GetCapturedStderr(), "");
  EXPECT_TRUE (contains (messageOf (depthInputOf (folder.path())), "leave them out"));

  for (const char* name : {"1.png", "2.png"})
    writePng (folder / name, 2, {1, 2, 3, 4});
  testing::internal::CaptureStderr();
  EXPECT_EQ (namesOf (FrameSource (inputOf (folder.path()))),
             std::vector<std::string>{"cloud"});
  EXPECT_TRUE (contains (testing::internal::GetCapturedStderr(),
                         ": 2 depth images are left out, for there are .pcd files"));
  testing::internal::CaptureStderr();
  EXPECT_EQ (namesOf (FrameSource (depthInputOf (folder.path()))),
             (std::vector<std::string>{"1", "2"}));
  EXPECT_TRUE (contains (testing::internal::GetCapturedStderr(),
                         ": 1 .pcd files are left out, for there is a camera"));
  InputOptions options = depthInputOf (folder.path());
  options.intrinsics.reset();
  EXPECT_TRUE (contains (messageOf (options), "add --intrinsics"));
}

TEST (FrameSource, GroundTruthIsNoFrame)
{
  const TemporaryFolder folder;
  for (const char* name : {"1.pcd", "1_truth.pcd", "my_truth.pcd", "_truth.pcd"})
    writeFile (folder / name, asciiPcd ("x y z", 2, 2, square));
  EXPECT_EQ (namesOf (FrameSource (inputOf (folder.path()))),
             (std::vector<std::string>{"1", "_truth", "my_truth"}))
      << "only beside what it is true of";
  EXPECT_EQ (namesOf (FrameSource (inputOf (folder / "1_truth.pcd"))),
             std::vector<std::string>{"1_truth"});
}

TEST (FrameSource, WhatTheViewerSavedIsNoFrame)
{
  const TemporaryFolder folder;
  for (const char* name : {"1.pcd", "1_view.pcd", "my_view.pcd"})
    writeFile (folder / name, asciiPcd ("x y z", 2, 2, square));
  EXPECT_EQ (namesOf (FrameSource (inputOf (folder.path()))),
             (std::vector<std::string>{"1", "my_view"}));
  const TemporaryFolder images;
  writePng (images / "1.png", 2, {1, 2, 3, 4});
  writeFile (images / "1_view.pcd", asciiPcd ("x y z", 2, 2, square));
  EXPECT_EQ (namesOf (FrameSource (depthInputOf (images.path()))),
             std::vector<std::string>{"1"});
}

TEST (FrameSource, FilesAreKnown)
{
  const TemporaryFolder folder;
  for (const char* name : {"1.pcd", "2.pcd"})
    writeFile (folder / name, asciiPcd ("x y z", 2, 2, square));
  InputOptions options = inputOf (folder.path());
  options.max_frames = 1;
  EXPECT_EQ (FrameSource (options).files(),
             (std::vector<std::filesystem::path>{folder / "1.pcd", folder / "2.pcd"}));
  EXPECT_EQ (FrameSource (options).folders(),
             std::set<std::filesystem::path>{folder / "."});
  EXPECT_TRUE (FrameSource (inputOf ("sim:room")).files().empty());
  EXPECT_TRUE (FrameSource (inputOf ("sim:room")).folders().empty());
}

TEST (FrameSource, FramesAreLimited)
{
  const TemporaryFolder folder;
  for (const char* name : {"1.pcd", "2.pcd", "3.pcd"})
    writeFile (folder / name, asciiPcd ("x y z", 2, 2, square));
  InputOptions options = inputOf (folder.path());
  options.max_frames = 2;
  EXPECT_EQ (namesOf (FrameSource (options)), (std::vector<std::string>{"1", "2"}));
}

TEST (FrameSource, ResolutionTakesEveryNthPixel)
{
  const TemporaryFolder folder;
  std::vector<std::uint16_t> depth (8 * 8);
  for (std::size_t i = 0; i < depth.size(); ++i)
    depth[i] = static_cast<std::uint16_t> (1000 + i);
  writePng (folder / "depth.png", 8, depth);
  InputOptions options = depthInputOf (folder / "depth.png");
  for (const std::uint32_t step : {1u, 2u, 4u}) {
    options.step = step;
    const auto cloud = FrameSource (options).read (0).cloud;
    ASSERT_EQ (cloud->width, 8 / step);
    ASSERT_EQ (cloud->height, 8 / step);
    for (std::uint32_t v = 0; v < cloud->height; ++v)
      for (std::uint32_t u = 0; u < cloud->width; ++u) {
        const float z = 1.f + 0.001f * static_cast<float> (8 * step * v + step * u);
        EXPECT_NEAR ((*cloud) (u, v).z, z, 1e-6f);
        EXPECT_NEAR (
            (*cloud) (u, v).x, static_cast<float> (step * u) * z / 100.f, 1e-6f);
      }
  }
  writePng (folder / "small.png", 4, std::vector<std::uint16_t> (16, 1000));
  options.input = folder / "small.png";
  EXPECT_TRUE (contains (messageOf (options), "too small"));
}

TEST (FrameSource, RowsAndColumnsAreNoImages)
{
  const TemporaryFolder folder;
  writePng (folder / "row.png", 4, std::vector<std::uint16_t> (4, 1000));
  writePng (folder / "column.png", 1, std::vector<std::uint16_t> (4, 1000));
  EXPECT_TRUE (contains (messageOf (depthInputOf (folder / "row.png")), "is 4 x 1"));
  EXPECT_TRUE (contains (messageOf (depthInputOf (folder / "column.png")), "is 1 x 4"));
}

TEST (FrameSource, DepthImagesNeedTheirCamera)
{
  const TemporaryFolder folder;
  writePng (folder / "depth.png", 2, {1, 2, 3, 4});
  for (const auto& input : {folder / "depth.png", folder.path()}) {
    InputOptions options = depthInputOf (input);
    options.intrinsics.reset();
    EXPECT_TRUE (contains (messageOf (options), "--intrinsics"));
    options = depthInputOf (input);
    options.units_per_metre.reset();
    EXPECT_TRUE (contains (messageOf (options), "--depth-scale"));
  }
}

TEST (FrameSource, IntrinsicsOfImagesOfAnotherSizeAreToldOnce)
{
  const TemporaryFolder folder;
  for (const char* name : {"1.png", "2.png"})
    writePng (folder / name, 32, std::vector<std::uint16_t> (32 * 24, 1000));
  InputOptions options = depthInputOf (folder.path());
  const auto notice = [&] (float cx, float cy) {
    options.intrinsics = Intrinsics{30.f, 30.f, cx, cy};
    testing::internal::CaptureStderr();
    EXPECT_EQ (messageOf (options), "");
    return testing::internal::GetCapturedStderr();
  };
  EXPECT_EQ (notice (15.5f, 11.5f), "");
  EXPECT_EQ (notice (10.f, 16.f), "");
  const std::string half_size = notice (7.5f, 5.5f);
  EXPECT_TRUE (contains (half_size, "1.png: has 32 x 24 pixels")) << half_size;
  EXPECT_EQ (half_size.find ('\n'), half_size.size() - 1) << half_size;
  EXPECT_NE (notice (16.f, 23.5f), "");
}

TEST (FrameSource, CloudsTakeNoCamera)
{
  const TemporaryFolder folder;
  writeFile (folder / "cloud.pcd", asciiPcd ("x y z", 2, 2, square));
  EXPECT_EQ (messageOf (inputOf (folder / "cloud.pcd")), "");
  EXPECT_TRUE (
      contains (messageOf (depthInputOf (folder / "cloud.pcd")), "leave them out"));
  EXPECT_TRUE (
      contains (messageOf (depthInputOf ("sim:table_single")), "leave them out"));
}

TEST (FrameSource, WrongInputsAreRefused)
{
  const TemporaryFolder folder;
  EXPECT_TRUE (contains (messageOf (inputOf (folder / "nothing")), "no such file"));
  EXPECT_TRUE (contains (messageOf (inputOf ("")), "no such file"));
  const std::string too_long (10000, 'a');
  EXPECT_TRUE (contains (messageOf (inputOf (too_long)), "no such file"));
  EXPECT_TRUE (contains (messageOf (inputOf (folder.path())), "no .pcd, no .png"));
  std::filesystem::create_directory (folder / "depth");
  EXPECT_TRUE (contains (messageOf (inputOf (folder.path())),
                         "did you mean " + (folder / "depth").string()));
  writeFile (folder / "cloud.ply", "ply");
  EXPECT_TRUE (contains (messageOf (inputOf (folder / "cloud.ply")), "neither"));
  EXPECT_TRUE (contains (messageOf (inputOf ("live:none.oni")), "no such file"));
  EXPECT_TRUE (contains (messageOf (inputOf ("none.oni")), "none.oni: no such file"));
}

TEST (FrameSource, BrokenFileInFolderIsAnError)
{
  const TemporaryFolder folder;
  writeFile (folder / "1.pcd", asciiPcd ("x y z", 2, 2, square));
  writeFile (folder / "2.pcd", asciiPcd ("x y z", 2, 2, "0 0 1\n"));
  const FrameSource source (inputOf (folder.path()));
  ASSERT_EQ (source.size(), 2u);
  EXPECT_NO_THROW (source.read (0));
  EXPECT_THROW (source.read (1), AppError);
}

TEST (FrameSource, SimulatedScenes)
{
  const FrameSource one (inputOf ("sim:table_single"));
  ASSERT_EQ (one.size(), 1u);
  EXPECT_EQ (one.read (0).name, "table_single_1");
  EXPECT_EQ (one.read (0).cloud->width, 640u);
  EXPECT_EQ (namesOf (FrameSource (inputOf ("sim:table_single:7"))),
             std::vector<std::string>{"table_single_7"});
  EXPECT_EQ (namesOf (FrameSource (inputOf ("sim:table_single:7:2"))),
             std::vector<std::string>{"table_single_7_2"});
  for (const std::string camera : {"", "x", "-1"})
    EXPECT_TRUE (
        contains (messageOf (inputOf ("sim:table_single:7:" + camera)), "camera"))
        << camera;
  EXPECT_TRUE (contains (messageOf (inputOf ("sim:table_single:7:2:3")), "leave out"));
  const std::string message = messageOf (inputOf ("sim:tabel"));
  EXPECT_TRUE (contains (message, "unknown scene 'tabel'")) << message;
  EXPECT_TRUE (contains (message, "table_single")) << message;
  for (const std::string seed : {"", "x", "-1", "1.5", "99999999999"})
    EXPECT_TRUE (contains (messageOf (inputOf ("sim:table_single:" + seed)), "seed"))
        << seed;
}
