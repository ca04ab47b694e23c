// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/features/impl/input_faults.h>
#include <pcl/segmentation/plane_tracker.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace pcl {

namespace {

/** From frame to frame; radians and metres. */
constexpr float max_turn = 0.5f, max_shift = 1.f;
/** Pixels count half where the distance has changed by this, or by so many times what it has
 * changed by for the quarter of those along the same axis that changed least: they tell whether the
 * camera moves along it. */
constexpr float half_shift = 0.03f, half_ratio = 40.f;
constexpr float part_of_least = 0.25f;
/** Of planes that face along one axis: 37 degrees. */
constexpr float min_cos_along = 0.8f;
/** Frames for which an unseen plane is remembered. */
constexpr unsigned max_missed = 15;

float
turnOf (const Eigen::Vector4f& a, const Eigen::Vector4f& b)
{
  return 2.f * std::asin (std::min (1.f, 0.5f * (a - b).head<3>().norm()));
}

float
shiftOf (const Eigen::Vector4f& a, const Eigen::Vector4f& b)
{
  return std::fabs (a.w() - b.w());
}

/** 1 for the same plane, 0 from the largest turn or shift on. */
float
similarity (float turn, float shift, float half)
{
  const float ratio = shift / half;
  return std::max (0.f, 1.f - turn / max_turn) *
         std::max (0.f, 1.f - shift / max_shift) / (1.f + ratio * ratio);
}

std::string
faultOf (const std::vector<ModelCoefficients>& model_coefficients,
         const PointCloud<Label>& labels)
{
  const char* advice = " of segment (models, inliers, labels).";
  if (!model_coefficients.empty() && labels.empty())
    return std::string ("The planes have no labels: pass those") + advice;
  if (labels.size() != static_cast<std::size_t> (labels.width) * labels.height)
    return std::to_string (labels.size()) + " labels are no image of " +
           std::to_string (labels.width) + " x " + std::to_string (labels.height) +
           " pixels: pass those" + advice;
  for (const auto& model : model_coefficients)
    if (model.values.size() != 4)
      return "A plane has " + std::to_string (model.values.size()) +
             " coefficients, not 4: pass the planes" + advice;
  return {};
}

} // namespace

void
PlaneTracker::track (const std::vector<ModelCoefficients>& model_coefficients,
                     const PointCloud<Label>& labels,
                     std::vector<std::uint32_t>& ids)
{
  ids.clear();
  // A frame that could not be segmented has no labels: all is as before it.
  const bool is_fault = rgbd_planes::isFault ("PlaneTracker::track",
                                              faultOf (model_coefficients, labels));
  if (is_fault || labels.empty())
    return;
  planes_.clear();
  for (const auto& model : model_coefficients) {
    planes_.emplace_back (model.values.data());
    planes_.back() /= planes_.back().head<3>().norm();
  }
  ids.reserve (planes_.size());
  fit (labels.width, labels.height);
  countOverlaps (labels);
  match();
  remember (labels);
  for (const auto track : track_of_plane_)
    ids.push_back (tracks_[track].id);
}

void
PlaneTracker::fit (std::uint32_t width, std::uint32_t height)
{
  if (width == width_ && height == height_)
    return;
  scaled_.assign (static_cast<std::size_t> (width) * height, {});
  if (!pixels_.empty())
    for (std::size_t v = 0, i = 0; v < height; ++v)
      for (std::size_t u = 0; u < width; ++u, ++i)
        scaled_[i] = pixels_[v * height_ / height * width_ + u * width_ / width];
  pixels_.swap (scaled_);
  width_ = width;
  height_ = height;
}

bool
PlaneTracker::isMissing (std::uint32_t track) const
{
  return track != none && tracks_[track].missed > 0;
}

void
PlaneTracker::countOverlaps (const PointCloud<Label>& labels)
{
  const std::size_t planes = planes_.size();
  overlaps_.assign (tracks_.size() * planes, 0);
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    const std::size_t plane = labels[i].label;
    if (plane >= planes)
      continue;
    const auto [track, former] = pixels_[i];
    if (track != none)
      ++overlaps_[track * planes + plane];
    if (isMissing (former))
      ++overlaps_[former * planes + plane];
  }
}

/** Of the planes that face as \a plane does, or away from there: the floor does not tell that a
 * robot comes nearer to a wall. Matches are by their shift. */
float
PlaneTracker::leastShift (const Eigen::Vector4f& plane) const
{
  const auto isAlong = [&] (const Match& match) {
    return std::fabs (planes_[match.plane].head<3>().dot (plane.head<3>())) >
           min_cos_along;
  };
  float pixels = 0.f;
  for (const Match& match : matches_)
    pixels += isAlong (match) ? match.score : 0.f;
  float rest = part_of_least * pixels;
  for (const Match& match : matches_)
    if (isAlong (match) && (rest -= match.score) <= 0.f)
      return match.shift;
  return 0.f;
}

void
PlaneTracker::match()
{
  const auto planes = static_cast<std::uint32_t> (planes_.size());
  matches_.clear();
  for (std::uint32_t t = 0; t < tracks_.size(); ++t)
    for (std::uint32_t p = 0; p < planes; ++p)
      if (const auto pixels = overlaps_[t * planes + p]) {
        Match match{static_cast<float> (pixels), t, p};
        const Eigen::Vector4f& track = tracks_[t].plane;
        const bool is_turned = track.head<3>().dot (planes_[p].head<3>()) < 0.f;
        const Eigen::Vector4f plane = is_turned ? -planes_[p] : planes_[p];
        match.turn = turnOf (track, plane);
        match.shift = shiftOf (track, plane);
        if (match.turn < max_turn && match.shift < max_shift)
          matches_.push_back (match);
      }
  std::sort (matches_.begin(), matches_.end(), [] (const Match& a, const Match& b) {
    return a.shift < b.shift;
  });
  halves_.clear();
  for (const Eigen::Vector4f& plane : planes_)
    halves_.push_back (std::max (half_shift, half_ratio * leastShift (plane)));
  for (Match& match : matches_)
    match.score *= similarity (match.turn, match.shift, halves_[match.plane]);
  std::sort (matches_.begin(), matches_.end(), [] (const Match& a, const Match& b) {
    return a.score != b.score   ? a.score > b.score
           : a.track != b.track ? a.track < b.track
                                : a.plane < b.plane;
  });

  tracks_.reserve (tracks_.size() + planes); // what may throw comes before any change
  track_of_plane_.assign (planes, none);
  for (auto& track : tracks_)
    ++track.missed;
  for (const auto& match : matches_)
    if (tracks_[match.track].missed > 0 && track_of_plane_[match.plane] == none) {
      track_of_plane_[match.plane] = match.track;
      tracks_[match.track].missed = 0;
    }
  for (std::uint32_t p = 0; p < planes; ++p) {
    if (track_of_plane_[p] == none)
      track_of_plane_[p] = addTrack();
    tracks_[track_of_plane_[p]].plane = planes_[p];
  }
}

std::uint32_t
PlaneTracker::addTrack()
{
  // One frame after the last pixel of a track was forgotten, its place is free.
  const auto place =
      std::find_if (tracks_.begin(), tracks_.end(), [] (const Track& track) {
        return track.missed > max_missed + 1;
      });
  const auto index = static_cast<std::uint32_t> (place - tracks_.begin());
  if (place == tracks_.end())
    tracks_.emplace_back();
  tracks_[index].id = next_id_++;
  tracks_[index].missed = 0;
  return index;
}

void
PlaneTracker::remember (const PointCloud<Label>& labels)
{
  const auto forget = [this] (std::uint32_t& track) {
    if (track != none && tracks_[track].missed > max_missed)
      track = none;
  };
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    auto& [track, former] = pixels_[i];
    const bool is_labelled = labels[i].label < planes_.size();
    const auto now = is_labelled ? track_of_plane_[labels[i].label] : none;
    if (now != track && (is_labelled || !isMissing (track))) {
      // What is missing may come back here, what is seen is elsewhere.
      if (track != none && (isMissing (track) || !isMissing (former)))
        former = track;
      track = now;
      if (former == track)
        former = none;
    }
    forget (track);
    forget (former);
  }
}

} // namespace pcl
