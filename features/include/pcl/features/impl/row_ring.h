// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <boost/align/aligned_allocator.hpp>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief The channels of one row of an image: channel c is the array row[c], with
 * room in front of it and behind it. */
template <typename T>
class ChannelRow {
public:
  ChannelRow() = default;

  ChannelRow (T* first, std::size_t stride) : first_ (first), stride_ (stride) {}

  /** \brief The row of the elements \a columns to the right. */
  ChannelRow
  shifted (std::ptrdiff_t columns) const
  {
    return {first_ + columns, stride_};
  }

  T*
  operator[] (std::size_t channel) const
  {
    return first_ + channel * stride_;
  }

  /** \brief From one channel to the next. */
  std::size_t
  stride () const
  {
    return stride_;
  }

private:
  T* first_ = nullptr;
  std::size_t stride_ = 0;
};

/** \brief The last rows of an image that is computed row by row, so that they stay in
 * the cache. */
template <typename T>
class RowRing {
public:
  /** Rows and the room around them are whole numbers of the longest vector. */
  static constexpr std::size_t lanes = 16;

  /** \brief The elements of as many whole vectors as hold \a number of them. */
  static constexpr int
  roundUp (int number)
  {
    constexpr int vector = static_cast<int> (lanes);
    return (number + vector - 1) / vector * vector;
  }

  /** \brief Makes room for the last \a rows rows of \a width elements in \a channels
   * channels, and for \a margin elements on both sides of each. Sets everything to \a value,
   * unless the room has been the same before. Allocates only when more room is needed than ever
   * before. */
  void
  reset (int rows, int channels, int width, int margin, T value)
  {
    const auto m = static_cast<std::size_t> (roundUp (margin));
    const std::tuple size (static_cast<std::size_t> (rows),
                           static_cast<std::size_t> (channels),
                           m,
                           static_cast<std::size_t> (roundUp (width)) + 2 * m);
    if (size == std::tuple (rows_, channels_, margin_, stride_))
      return;
    elements_.assign (std::get<0> (size) * std::get<1> (size) * std::get<3> (size),
                      value);
    std::tie (rows_, channels_, margin_, stride_) = size;
  }

  /** \brief Sets all of row \a v to \a value. */
  void
  fill (int v, T value)
  {
    std::fill_n (operator[] (v)[0] - margin_, channels_ * stride_, value);
  }

  /** \brief Row \a v, which takes the place of row v - rows. */
  ChannelRow<T>
  operator[] (int v)
  {
    const std::size_t slot = static_cast<std::size_t> (v) % rows_;
    return {elements_.data() + slot * channels_ * stride_ + margin_, stride_};
  }

private:
  std::size_t rows_ = 0;
  std::size_t channels_ = 0;
  std::size_t margin_ = 0;
  std::size_t stride_ = 0;
  /** At multiples of the longest vector. */
  std::vector<T, boost::alignment::aligned_allocator<T, lanes * sizeof (float)>>
      elements_;
};

} // namespace rgbd_planes
} // namespace pcl
