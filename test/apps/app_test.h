// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "files.h"
#include <sys/wait.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

struct Outcome {
  int code;
  std::string out;
  std::string err;
};

/** A test that runs an application in an empty folder. */
class AppTest : public testing::Test {
protected:
  /** \param[in] executable the path of the application */
  explicit AppTest (const std::string& executable) : executable_ (executable) {}

  /** Runs the application with arguments as a shell reads them, after \a before. */
  Outcome
  run (const std::string& arguments, const std::string& before = "") const
  {
    const std::string command = "cd '" + folder_.path().string() + "' && " + before +
                                " '" + executable_ + "' " + arguments + " >'" +
                                (logs_ / "out").string() + "' 2>'" +
                                (logs_ / "err").string() + "'";
    const int status = std::system (command.c_str());
    return {WIFEXITED (status) ? WEXITSTATUS (status) : -1,
            readFile (logs_ / "out"),
            readFile (logs_ / "err")};
  }

  /** Bad usage and bad input: exit 1, one line on stderr that holds \a reason, no
   * output. */
  void
  expectRefused (const std::string& arguments,
                 const std::string& reason,
                 const std::string& before = "") const
  {
    const auto files = listFolder (folder_.path());
    const Outcome result = run (arguments, before);
    EXPECT_EQ (result.code, 1) << arguments;
    EXPECT_EQ (result.out, "") << arguments;
    const std::string name = std::filesystem::path (executable_).filename();
    EXPECT_EQ (result.err.rfind (name + ": ", 0), 0u) << result.err;
    EXPECT_EQ (std::count (result.err.begin(), result.err.end(), '\n'), 1)
        << result.err;
    EXPECT_EQ (result.err.back(), '\n') << result.err;
    EXPECT_NE (result.err.find (reason), std::string::npos) << result.err;
    EXPECT_EQ (listFolder (folder_.path()), files) << arguments;
  }

  const TemporaryFolder folder_;
  const TemporaryFolder logs_;

private:
  const std::string executable_;
};
