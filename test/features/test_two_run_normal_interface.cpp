// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "normal_clouds.h"

#include <pcl/common/io.h>
#include <pcl/console/print.h>
#include <pcl/features/two_run_normal.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

using namespace normal_clouds;
using Estimation = pcl::TwoRunNormalEstimation<pcl::PointXYZ, pcl::Normal>;

namespace {

class QuietErrors : public ::testing::Test {
protected:
  void
  SetUp () override
  {
    pcl::console::setVerbosityLevel (pcl::console::L_ALWAYS);
  }
  void
  TearDown () override
  {
    pcl::console::setVerbosityLevel (pcl::console::L_INFO);
  }
};

using TwoRunNormalErrors = QuietErrors;

} // namespace

TEST (TwoRunNormal, SearchSurface)
{
  // Few points of a noisy plane, neighbours from the whole of it.
  const Cloud::Ptr surface = makeHoles();
  const Normals all = estimate<Estimation> (surface);
  Cloud::Ptr few (new Cloud);
  for (std::size_t i = 0; i < surface->size(); i += 50)
    few->push_back ((*surface)[i]);
  Estimation estimation;
  estimation.setInputCloud (few);
  estimation.setSearchSurface (surface);
  Normals normals;
  estimation.compute (normals);
  ASSERT_EQ (normals.size(), few->size());
  for (std::size_t i = 0; i < normals.size(); ++i)
    EXPECT_TRUE (sameBits (normals[i], all[i * 50])) << i;
}

/** FLANN ended the process, where boxes of its tree overflowed. */
TEST (TwoRunNormal, PointsAtTheEndOfFloatsHaveNoNormals)
{
  const Cloud::Ptr surface = makeHoles();
  Cloud::Ptr cloud (new Cloud);
  for (std::size_t i = 0; i < surface->size(); i += 50)
    cloud->push_back ((*surface)[i]);
  const std::size_t ordinary = cloud->size();
  const Normals all = estimate<Estimation> (cloud);
  constexpr float largest = std::numeric_limits<float>::max();
  for (const float x : {largest, -largest, 3e38f, -2e38f})
    for (int k = 0; k < 10; ++k)
      cloud->push_back ({x, static_cast<float> (k), 1.f});
  const Normals normals = estimate<Estimation> (cloud);
  ASSERT_EQ (normals.size(), cloud->size());
  for (std::size_t i = 0; i < normals.size(); ++i)
    if (i < ordinary)
      EXPECT_TRUE (sameBits (normals[i], all[i])) << i;
    else
      EXPECT_TRUE (std::isnan (normals[i].normal_x)) << i;
}

/** They ended the process. */
TEST (TwoRunNormal, ExceptionsOfTheRadiusArrive)
{
  for (const unsigned threads : {1u, 2u}) {
    Estimation estimation;
    estimation.setNumberOfThreads (threads);
    estimation.setInputCloud (makeHoles());
    estimation.setRadius (
        [] (float) -> float { throw std::runtime_error ("no radius"); });
    Normals normals;
    EXPECT_THROW (estimation.compute (normals), std::runtime_error);
  }
}

TEST_F (TwoRunNormalErrors, TheSearchSurfaceIsNoOutput)
{
  const auto surface = pcl::make_shared<pcl::PointCloud<pcl::PointNormal>>();
  pcl::copyPointCloud (*makeHoles(), *surface);
  pcl::TwoRunNormalEstimation<pcl::PointNormal, pcl::PointNormal> estimation;
  estimation.setInputCloud (surface);
  estimation.setSearchSurface (surface);
  estimation.compute (*surface);
  EXPECT_EQ (surface->width, 160u) << "as it is the input, too";
  const auto few = pcl::make_shared<pcl::PointCloud<pcl::PointNormal>>();
  few->assign (surface->begin(), surface->begin() + 50, 10);
  estimation.setInputCloud (few);
  estimation.compute (*surface);
  EXPECT_TRUE (surface->empty());
}

TEST_F (TwoRunNormalErrors, BadNeighbourhoodsGiveEmptyOutput)
{
  const Cloud::Ptr plane =
      synthetic::render ({synthetic::tiltedPlane (1.f, 0.f, 0.f)}, 16, 12).cloud;
  const auto expectEmpty = [] (Estimation& estimation) {
    Normals normals (3, 1);
    estimation.compute (normals);
    EXPECT_TRUE (normals.empty());
    EXPECT_EQ (normals.width * normals.height, 0u);
  };
  Estimation on_surface;
  on_surface.setInputCloud (plane);
  on_surface.setSearchSurface (Cloud::Ptr (new Cloud));
  expectEmpty (on_surface);
  on_surface.setSearchSurface (plane);
  on_surface.setWindowSize (5);
  expectEmpty (on_surface);
  Estimation unorganized;
  unorganized.setInputCloud (Cloud::Ptr (new Cloud (9, 1)));
  unorganized.setWindowSize (5);
  expectEmpty (unorganized);
}

TEST_F (TwoRunNormalErrors, BadParametersAreRefused)
{
  Estimation estimation;
  estimation.setInputCloud (makeHoles());
  Normals before, after;
  estimation.compute (before);
  estimation.setRadius (-0.1f, 0.1f);
  estimation.setRadius (0.f, 0.f);
  estimation.setRadius (synthetic::nan, 0.1f);
  estimation.setRadius (0.1f, 0.1f, std::numeric_limits<float>::infinity());
  estimation.setRadius (std::function<float (float)>());
  for (const int size : {-1, 1, 4})
    estimation.setWindowSize (size);
  estimation.compute (after);
  EXPECT_TRUE (sameBits (before, after));
}
