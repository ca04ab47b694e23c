// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace pcl {
namespace rgbd_planes {

/** \brief Something only the user can put right. The message is one line: what is
 * wrong, with the name of the file or option, and what to do. */
class AppError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/** \brief The error for a file that could not be opened just now; \c errno says why. */
AppError
cannotOpen (const std::string& file);

/** \brief Throws AppError where standard output did not take all that was printed. To be
 * called when files are committed: who reads only the start of it gets them all the same. */
void
flushOutput ();

/** \brief Prints a line on stderr that is no error, behind the name of the application. */
void
printNotice (const std::string& line);

/** \brief Runs the body of an application.
 * \param[in] name of the application, put before the message of an error and before notices
 * \return the exit code: 0, or 1 after an exception, which is told in one line on
 * stderr
 */
int
runApp (const std::string& name, const std::function<void()>& body);

} // namespace rgbd_planes
} // namespace pcl
