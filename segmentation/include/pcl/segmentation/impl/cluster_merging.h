// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <numeric>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Merges neighbouring clusters, best merges first, and keeps track of the
 * merges (Holz et al. 2011, section 4.1).
 *
 * A cluster that was merged is represented by the cluster that it became part of.
 * Whether a + b or a + c is the better merge is decided by the distances of the
 * clusters as they are at that moment, not as they were before other merges.
 *
 * \tparam Cluster has operator+= and is empty when default-constructed
 */
template <typename Cluster>
class ClusterMerging {
public:
  /** \brief Starts anew with these clusters, fewer than 2^16, none merged. */
  void
  reset (const std::vector<Cluster>& clusters)
  {
    clusters_ = clusters;
    parents_.resize (clusters_.size());
    std::iota (parents_.begin(), parents_.end(), std::size_t{0});
    queue_.clear();
  }

  /** \brief Says that clusters \a a and \a b are neighbours, so that they may merge. */
  void
  addNeighbours (std::size_t a, std::size_t b)
  {
    queue_.push_back (makeCandidate (0.f, a, b));
  }

  /** \brief Merges neighbours while the smallest of their distances is at most
   * \a max_distance.
   * \param[in] distance distance (const Cluster&, const Cluster&), a float
   */
  template <typename Distance>
  void
  merge (float max_distance, const Distance& distance)
  {
    for (Candidate& candidate : queue_)
      candidate = makeCandidate (
          distance (clusters_[first (candidate)], clusters_[second (candidate)]),
          first (candidate),
          second (candidate));
    // Those that are too far apart come last, if others that merge bring them together.
    const auto end = std::partition (
        queue_.begin(), queue_.end(), [max_distance] (Candidate candidate) {
          return distanceOf (candidate) <= max_distance;
        });
    far_.assign (end, queue_.end());
    queue_.erase (end, queue_.end());
    mergeQueue (max_distance, distance);
    const auto is_near_now = [&] (Candidate candidate) {
      const std::size_t a = find (first (candidate)), b = find (second (candidate));
      return a != b && distance (clusters_[a], clusters_[b]) <= max_distance;
    };
    if (std::any_of (far_.begin(), far_.end(), is_near_now)) {
      queue_.swap (far_);
      mergeQueue (max_distance, distance);
    }
  }

  /** \brief The cluster that \a cluster is part of. */
  std::size_t
  find (std::size_t cluster)
  {
    while (parents_[cluster] != cluster) {
      parents_[cluster] = parents_[parents_[cluster]];
      cluster = parents_[cluster];
    }
    return cluster;
  }

  const Cluster&
  operator[] (std::size_t cluster) const
  {
    return clusters_[cluster];
  }

private:
  /** Two neighbours as one number, the smallest of which merge first: the bits of their
   * distance, a float, which are in its order, then their own numbers, so that results do not
   * depend on the order of insertion. Most comparisons cannot be foreseen, and these are fast. */
  using Candidate = std::uint64_t;

  static Candidate
  makeCandidate (float distance, std::size_t a, std::size_t b)
  {
    std::uint32_t bits;
    std::memcpy (&bits, &distance, sizeof bits);
    return std::uint64_t{bits} << 32 | a << 16 | b;
  }

  static float
  distanceOf (Candidate candidate)
  {
    const auto bits = static_cast<std::uint32_t> (candidate >> 32);
    float distance;
    std::memcpy (&distance, &bits, sizeof distance);
    return distance;
  }

  static std::size_t
  first (Candidate candidate)
  {
    return candidate >> 16 & 0xffff;
  }

  static std::size_t
  second (Candidate candidate)
  {
    return candidate & 0xffff;
  }

  template <typename Distance>
  void
  mergeQueue (float max_distance, const Distance& distance)
  {
    std::make_heap (queue_.begin(), queue_.end(), std::greater<>());
    while (!queue_.empty()) {
      sinkTop();
      Candidate& top = queue_.front();
      const std::size_t a = find (first (top)), b = find (second (top));
      const float now = a != b ? distance (clusters_[a], clusters_[b])
                               : std::numeric_limits<float>::infinity();
      if (now > distanceOf (top) && now <= max_distance) {
        // Either was merged since: wait for its turn.
        top = makeCandidate (now, a, b);
        continue;
      }
      if (now <= max_distance) {
        clusters_[a] += clusters_[b];
        clusters_[b] = Cluster{};
        parents_[b] = a;
      }
      top = queue_.back();
      queue_.pop_back();
    }
  }

  /** Makes a heap of the queue, of which all but the top is one. */
  void
  sinkTop ()
  {
    const Candidate top = queue_.front();
    std::size_t at = 0;
    for (std::size_t next = 1; next < queue_.size(); next = 2 * at + 1) {
      if (next + 1 < queue_.size())
        next += queue_[next + 1] < queue_[next];
      if (top <= queue_[next])
        break;
      queue_[at] = queue_[next];
      at = next;
    }
    queue_[at] = top;
  }

  std::vector<Cluster> clusters_;
  std::vector<std::size_t> parents_;
  std::vector<Candidate> queue_; // a heap while merging
  std::vector<Candidate> far_;
};

} // namespace rgbd_planes
} // namespace pcl
