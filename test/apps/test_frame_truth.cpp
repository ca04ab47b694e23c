// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "app_test.h"

#include <pcl/apps/app_error.h>
#include <pcl/apps/encode_pcd.h>
#include <pcl/apps/frame_source.h>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cstring>

using namespace pcl::rgbd_planes;
using nlohmann::json;

namespace {

/** A folder with a frame of a table that pcl_simulate_rgbd wrote. */
class FrameTruth : public AppTest {
protected:
  FrameTruth() : AppTest (SIMULATE_RGBD)
  {
    EXPECT_EQ (run ("table_cluttered --seed 2 --output frames").code, 0);
  }

  Frame
  read (const std::string& input, std::uint32_t step = 1) const
  {
    InputOptions options;
    options.input = input;
    options.step = step;
    return FrameSource (options).read (0);
  }

  std::string
  refusal () const
  {
    try {
      read (path (".pcd"));
    }
    catch (const AppError& error) {
      return error.what();
    }
    return "";
  }

  std::filesystem::path
  path (const std::string& ending) const
  {
    return folder_ / ("frames/table_cluttered_2_kinect_vga" + ending);
  }

  /** The figures of an evaluation, but for those that are times. */
  json
  figures (const std::string& application, const std::string& input) const
  {
    const Outcome outcome = shell ("'" + application + "' " + input +
                                   " --resolution qqvga --json table.json");
    EXPECT_EQ (outcome.code, 0) << outcome.err;
    EXPECT_EQ (outcome.err, "");
    json rows = json::parse (readFile (folder_ / "table.json"))["results"];
    for (json& row : rows)
      for (const char* time : {"ms_median", "ms_worst", "rate_hz"})
        row.erase (time);
    return rows;
  }
};

void
replace (const std::filesystem::path& file,
         const std::string& text,
         const std::string& other)
{
  std::string contents = readFile (file);
  const auto at = contents.find (text);
  ASSERT_NE (at, std::string::npos);
  writeFile (file, contents.replace (at, text.size(), other));
}

} // namespace

TEST_F (FrameTruth, IsThatOfTheSimulation)
{
  for (const std::uint32_t step : {1u, 2u}) {
    const Frame simulated = read ("sim:table_cluttered:2", step);
    const Frame saved = read (folder_ / "frames", step);
    EXPECT_EQ (saved.name, "table_cluttered_2_kinect_vga");
    ASSERT_TRUE (saved.truth && saved.camera_to_base);
    EXPECT_EQ (saved.camera_to_base->matrix(), simulated.camera_to_base->matrix());
    EXPECT_EQ (saved.true_planes, simulated.true_planes);
    ASSERT_EQ (saved.truth->size(), simulated.truth->size());
    for (std::size_t i = 0; i < saved.truth->size(); ++i)
      ASSERT_EQ (std::memcmp (&(*saved.truth)[i],
                              &(*simulated.truth)[i],
                              offsetof (TruthPoint, edge) + sizeof (std::uint32_t)),
                 0)
          << i;
    ASSERT_GE (saved.true_objects.size(), 5u);
    ASSERT_EQ (saved.true_objects.size(), simulated.true_objects.size());
    for (std::size_t i = 0; i < saved.true_objects.size(); ++i) {
      const TrueObject &a = saved.true_objects[i], &b = simulated.true_objects[i];
      EXPECT_EQ (a.id, b.id);
      EXPECT_EQ (a.shape, b.shape);
      EXPECT_EQ (a.size, b.size);
      EXPECT_EQ (a.pose.matrix(), b.pose.matrix());
    }
  }
}

TEST_F (FrameTruth, GivesTheFiguresOfTheSimulation)
{
  for (const char* application :
       {EVALUATE_DETECTION, EVALUATE_NORMALS, EVALUATE_PLANES})
    EXPECT_EQ (figures (application, "frames"),
               figures (application, "sim:table_cluttered:2"))
        << application;
}

TEST_F (FrameTruth, FilesAreInputs)
{
  InputOptions options;
  options.input = path (".pcd");
  EXPECT_EQ (FrameSource (options).files(),
             (std::vector<std::filesystem::path>{
                 path (".pcd"), path ("_truth.json"), path ("_truth.pcd")}));
}

TEST_F (FrameTruth, IsUnknownWithoutTheScene)
{
  std::filesystem::remove (path ("_truth.json"));
  const Frame frame = read (folder_ / "frames");
  EXPECT_FALSE (frame.truth || frame.camera_to_base);
}

TEST_F (FrameTruth, OfAnotherFrameIsRefused)
{
  ASSERT_EQ (run ("table_cluttered --seed 2 --resolution qvga --output small").code, 0);
  std::filesystem::copy (folder_ / "small/table_cluttered_2_kinect_qvga_truth.pcd",
                         path ("_truth.pcd"),
                         std::filesystem::copy_options::overwrite_existing);
  EXPECT_NE (refusal().find ("_truth.pcd: the truth about another frame"),
             std::string::npos)
      << refusal();
}

TEST_F (FrameTruth, OfAnotherSceneIsRefused)
{
  json scene = json::parse (readFile (path ("_truth.json")));
  scene["planes"].erase (scene["planes"].size() - 1);
  writeFile (path ("_truth.json"), scene.dump());
  EXPECT_NE (refusal().find ("_truth.pcd: the truth about another frame"),
             std::string::npos)
      << refusal();
}

TEST_F (FrameTruth, ImpossibleNumbersAreRefused)
{
  const json scene = json::parse (readFile (path ("_truth.json")));
  const json no_turn = {{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}};
  const json mirror = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, -1, 0}};
  json far_away = scene["camera_to_base"];
  far_away[0][3] = 1e39;
  const auto expectRefusal = [&] (const std::string& place, const json& value) {
    json damaged = scene;
    damaged[json::json_pointer (place)] = value;
    writeFile (path ("_truth.json"), damaged.dump());
    EXPECT_NE (refusal().find ("_truth.json: not the truth about a frame"),
               std::string::npos)
        << place << ' ' << value << ' ' << refusal();
  };
  for (const json& pose : {no_turn, mirror, far_away}) {
    expectRefusal ("/camera_to_base", pose);
    expectRefusal ("/objects/0/pose", pose);
  }
  for (const json& plane : {json{0, 0, 0, 1}, json{0, 0, 2, 1}, json{0, 0, 1, 1e39}})
    expectRefusal ("/planes/0", plane);
  for (const json& id :
       {json (0), json (-1), json (1.5), json (1ull << 32), json ("1")})
    expectRefusal ("/objects/0/id", id);
  for (const json& size : {json{0, 1, 1}, json{1, -1, 1}, json{1, 1, 1e39}})
    expectRefusal ("/objects/0/size_m", size);
}

TEST_F (FrameTruth, NamesMayBeTooLongToHaveOne)
{
  const std::string name (255 - 4, 'a');
  std::filesystem::copy (path (".pcd"), folder_ / (name + ".pcd"));
  const Frame frame = read (folder_ / (name + ".pcd"));
  EXPECT_EQ (frame.name, name);
  EXPECT_FALSE (frame.truth);
}

TEST_F (FrameTruth, DamagedOneIsRefused)
{
  const std::string scene = readFile (path ("_truth.json"));
  for (const auto& [text, other] :
       {std::pair ("\"planes\"", "\"plane\""), {"\"box\"", "\"cone\""}, {"{", "["}}) {
    replace (path ("_truth.json"), text, other);
    EXPECT_NE (refusal().find ("_truth.json: not the truth about a frame"),
               std::string::npos)
        << refusal();
    writeFile (path ("_truth.json"), scene);
  }
  replace (path ("_truth.pcd"), " edge", " rim_");
  EXPECT_NE (refusal().find ("_truth.pcd: has no field 'edge'"), std::string::npos)
      << refusal();
  std::filesystem::remove (path ("_truth.pcd"));
  EXPECT_NE (refusal().find ("_truth.pcd: cannot open"), std::string::npos)
      << refusal();
}
