// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "numbers_of_all_classes.h"

#include <utility>

TEST (MovedObjects, GiveTheSameAsNewOnesBeforeAndAfter)
{
  using Numbers = NumbersOfAllClasses<pcl::PointXYZ, pcl::Normal, pcl::Label>;
  const Numbers expected;
  Numbers from;
  Numbers to = std::move (from);
  for (auto* numbers : {&from, &to}) {
    numbers->find();
    for (const auto& [name, values] : expected.get())
      EXPECT_TRUE (numbers->get().at (name) == values) << name;
  }
}
