// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "files.h"
#include "frame_source_test.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

using namespace pcl::rgbd_planes;

namespace {

/** A VGA image that holds 5000 at column 420, row 340. */
std::vector<std::uint16_t>
vgaDepth ()
{
  std::vector<std::uint16_t> depth (640 * 480);
  depth[340 * 640 + 420] = 5000;
  return depth;
}

} // namespace

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
