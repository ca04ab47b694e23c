// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/frame_source.h>
#include <pcl/features/depth_noise.h>

#include <boost/program_options/options_description.hpp>
#include <boost/program_options/variables_map.hpp>

#include <array>
#include <cstddef>
#include <string>

namespace pcl {
namespace rgbd_planes {

/** \brief --intrinsics, --depth-scale, --resolution and --frames, the same in all
 * applications. */
boost::program_options::options_description
inputOptionsDescription ();

/** \brief What the values of inputOptionsDescription() say about \a input; AppError
 * where one of them is malformed or out of range. */
InputOptions
readInputOptions (const std::string& input,
                  const boost::program_options::variables_map& values);

/** \brief The value of an option that counts something: a whole number of 1 or more;
 * AppError otherwise. */
unsigned
parseCount (const std::string& option, const std::string& text);

/** \brief What --help says about --base-transform. */
extern const char base_transform_help[];

/** \brief The value of --base-transform, x,y,z,roll,pitch,yaw in metres and degrees: from the
 * camera optical frame (x right, y down, z forward) to the frame of the robot (x forward, y
 * left, z up) for a camera at x, y, z that looks along x, then is turned about x, y and z in
 * this order. AppError where it is not six finite numbers. */
Eigen::Affine3f
parseBaseTransform (const std::string& text);

/** \brief The two finite numbers of "A,B", 0 or more and not both 0; AppError for others, which
 * calls them \a names, as in "A,B". */
std::array<float, 2>
parseCoefficients (const std::string& option,
                   const std::string& text,
                   const std::string& names);

/** \brief Adds --depth-noise. */
void
addDepthNoiseOption (boost::program_options::options_description& options);

/** \brief The value of --depth-noise, by default DepthNoise::kinectV1(); AppError where there is
 * no such sensor, or --corrected, which knows what noise is left, is given as well. */
DepthNoise
readDepthNoise (const boost::program_options::variables_map& values);

/** \brief The step between pixels for a value of --resolution; AppError where it is
 * none. */
std::uint32_t
parseResolution (const std::string& text);

/** \brief The value of --resolution for a step of 1, 2 or 4. */
std::string
resolutionName (std::uint32_t step);

/** \brief What --help says about INPUT. */
std::string
inputHelp ();

/** \brief Columns of --help. */
constexpr unsigned help_width = 100;

/** \brief Words in lines of so many columns, each after \a indent spaces. */
std::string
wrap (const std::string& text, std::size_t columns, std::size_t indent = 0);

} // namespace rgbd_planes
} // namespace pcl
