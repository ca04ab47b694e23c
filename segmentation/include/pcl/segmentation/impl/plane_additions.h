// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

namespace pcl {
namespace rgbd_planes {

/** \brief What PlaneExtraction does beyond the two stages of the paper (Holz et
 * al. 2011, section 4). Evaluations leave parts of it out to tell what each is
 * good for. */
struct PlaneAdditions {
  /** Points with a large curvature, at creases, start no cluster. */
  bool creases = true;
  /** Points may lie the farther from their plane the farther away they are, and
   * count the less in fits; without, all count as at a range of 3 m. */
  bool noise = true;
  /** Distances are split between peaks of their histogram, and candidates on several levels
   * start on one; without, neighbouring bins are merged as neighbouring cells of normals are. */
  bool peaks = true;
  /** Parts of clusters that hang together in the image are candidates; without,
   * whole clusters. */
  bool parts = true;
  /** Candidates grow to all free points on their plane; without, they keep
   * their own. */
  bool growth = true;
  /** Candidates on two planes that meet at a small angle grow from one side of it. */
  bool bends = true;
  /** Candidates whose normals turn with the place become no planes. */
  bool curved = true;
  /** What no plane took is clustered once more, with twice the angular threshold. */
  bool repeat = true;
  /** Candidates on the same plane are joined. */
  bool joining = true;
  /** Planes are parted along steps, where the errors of their points jump. */
  bool steps = true;
  /** Strips that lie apart are joined where one plane explains both. */
  bool strips = true;
  /** Planes beside which a surface goes on, and turns, are dropped, and those to which
   * most normals of their points do not belong. */
  bool patches = true;
  /** Each point gets the nearest plane of those around it, but for the foot of what stands on
   * one; without, that of the sample in its cell. */
  bool assignment = true;
  /** Where two planes meet, points on both go to the one on their side of the line of
   * intersection. */
  bool intersections = true;
};

} // namespace rgbd_planes
} // namespace pcl
