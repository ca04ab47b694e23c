// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "random.h"
#include "scene.h"

namespace pcl {
namespace rgbd_planes {

/** \brief A table with one box. */
Scene
tableSingle (Random& random);

/** \brief A table with much on it (addClutter()), and a dark mat. */
Scene
tableCluttered (Random& random);

/** \brief A worktop in the corner of a room. Five things stand in a row at the wall, from
 * against it to 2 cm off, the first one in the corner; four stand before them. */
Scene
worktop (Random& random);

/** \brief A table with hollow things, which are seen from above, two boxes without lids, two bowls
 * and three cups, and three solid boxes. */
Scene
crockery (Random& random);

/** \brief A shelf at a wall, with three boxes and two cylinders on each of its three boards. */
Scene
shelf (Random& random);

} // namespace rgbd_planes
} // namespace pcl
