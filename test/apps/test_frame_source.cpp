// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "files.h"

#include <pcl/apps/app_error.h>
#include <pcl/apps/frame_source.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

using namespace pcl::rgbd_planes;

namespace {

const std::string square = "0 0 1\n0 0 2\n0 0 3\n0 0 4\n";

InputOptions
inputOf (const std::filesystem::path& input)
{
  InputOptions options;
  options.input = input;
  return options;
}

InputOptions
depthInputOf (const std::filesystem::path& input)
{
  InputOptions options = inputOf (input);
  options.intrinsics = Intrinsics{100.f, 100.f, 0.f, 0.f};
  options.units_per_metre = 1000.f;
  return options;
}

std::vector<std::string>
namesOf (const FrameSource& source)
{
  std::vector<std::string> names;
  for (std::size_t i = 0; i < source.size(); ++i)
    names.push_back (source.read (i).name);
  return names;
}

std::string
messageOf (const InputOptions& options)
{
  try {
    namesOf (FrameSource (options));
  }
  catch (const AppError& error) {
    return error.what();
  }
  return "";
}

bool
contains (const std::string& text, const std::string& part)
{
  return text.find (part) != std::string::npos;
}

/** A VGA image that holds 5000 at column 420, row 340. */
std::vector<std::uint16_t>
vgaDepth ()
{
  std::vector<std::uint16_t> depth (640 * 480);
  depth[340 * 640 + 420] = 5000;
  return depth;
}

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

class TumFolder : public testing::Test {
protected:
  TumFolder()
  {
    std::filesystem::create_directory (folder_ / "depth");
    writePng (folder_ / "depth/9.5.png", 640, vgaDepth());
    writePng (folder_ / "depth/10.5.png", 640, vgaDepth());
    writeList ("freiburg1_xyz", "10.5 depth/10.5.png\r\n\n9.5 depth/9.5.png\n");
  }

  void
  writeList (const std::string& recording, const std::string& lines)
  {
    writeFile (folder_ / "depth.txt",
               "# depth maps\n# file: 'rgbd_dataset_" + recording + ".bag'\n" + lines);
  }

  /** The point of column 420, row 340 of the first frame. */
  Eigen::Vector3f
  point (const InputOptions& options) const
  {
    return (*FrameSource (options).read (0).cloud) (420, 340).getVector3fMap();
  }

  const TemporaryFolder folder_;
};

TEST_F (TumFolder, FramesComeAsListed)
{
  EXPECT_EQ (namesOf (FrameSource (inputOf (folder_.path()))),
             (std::vector<std::string>{"10.5", "9.5"}));
}

TEST_F (TumFolder, FilesAreKnown)
{
  EXPECT_EQ (FrameSource (inputOf (folder_.path())).files(),
             (std::vector<std::filesystem::path>{folder_ / "depth.txt",
                                                 folder_ / "depth/10.5.png",
                                                 folder_ / "depth/9.5.png"}));
  EXPECT_EQ (FrameSource (inputOf (folder_.path())).folders(),
             (std::set<std::filesystem::path>{folder_ / ".", folder_ / "depth/."}));
  // Results do not replace these either.
  std::filesystem::create_directory (folder_ / "rgb");
  writeFile (folder_ / "rgb/9.6.png", "");
  writeFile (folder_ / "rgb.txt", "# colour images\n9.6 rgb/9.6.png\n\n");
  writeFile (folder_ / "groundtruth.txt", "");
  EXPECT_EQ (FrameSource (inputOf (folder_.path())).files(),
             (std::vector<std::filesystem::path>{folder_ / "rgb.txt",
                                                 folder_ / "groundtruth.txt",
                                                 folder_ / "rgb/9.6.png",
                                                 folder_ / "depth.txt",
                                                 folder_ / "depth/10.5.png",
                                                 folder_ / "depth/9.5.png"}));
}

TEST_F (TumFolder, CameraIsKnown)
{
  const Eigen::Vector3f usual (100.5f / 525.f, 100.5f / 525.f, 1.f);
  EXPECT_TRUE (point (inputOf (folder_.path())).isApprox (usual, 1e-6f));
  writeList ("freiburg3_structure", "10.5 depth/10.5.png\n");
  const Eigen::Vector3f third (
      (420.f - 320.1f) / 535.4f, (340.f - 247.6f) / 539.2f, 1.f);
  EXPECT_TRUE (point (inputOf (folder_.path())).isApprox (third, 1e-6f));
  const auto used = FrameSource (inputOf (folder_.path())).options();
  EXPECT_EQ (used.intrinsics->fx, 535.4f);
  EXPECT_EQ (used.units_per_metre, 5000.f);
  const Eigen::Vector3f given (4.2f * 5.f, 3.4f * 5.f, 5.f);
  EXPECT_TRUE (point (depthInputOf (folder_.path())).isApprox (given, 1e-6f));
  EXPECT_EQ (FrameSource (depthInputOf (folder_.path())).options().intrinsics->fx,
             100.f);
}

TEST_F (TumFolder, OtherSizesNeedTheirCamera)
{
  writePng (
      folder_ / "depth/10.5.png", 320, std::vector<std::uint16_t> (320 * 240, 5000));
  EXPECT_TRUE (contains (messageOf (inputOf (folder_.path())), "320 x 240"));
  EXPECT_EQ (messageOf (depthInputOf (folder_.path())), "");
}

TEST_F (TumFolder, BadListsAreRefused)
{
  writeList ("freiburg1_xyz", "1.5 depth/1.5.png\n");
  EXPECT_TRUE (contains (messageOf (inputOf (folder_.path())), "1.5.png: cannot open"));
  writeList ("freiburg1_xyz", "");
  EXPECT_TRUE (contains (messageOf (inputOf (folder_.path())), "lists no depth image"));
  writeList ("freiburg1_xyz", "9.5 depth/9.5.png\n10.5\n");
  EXPECT_TRUE (contains (messageOf (inputOf (folder_.path())), "line 4"));
  for (const std::string time : {"nan", "inf", "-inf", "1.5s", "1305031102160000000"}) {
    writeList ("freiburg1_xyz", time + " depth/9.5.png\n");
    EXPECT_TRUE (
        contains (messageOf (inputOf (folder_.path())), "line 3: the timestamp"))
        << time;
  }
  writeList ("freiburg1_xyz", "9.5 depth/9.5.png\n9.6 depth/9.5.png\n");
  EXPECT_TRUE (contains (messageOf (inputOf (folder_.path())), "named '9.5'"));
}
