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
  explicit AppTest (const std::string& executable)
  : application_ ("'" + executable + "'")
  , name_ (std::filesystem::path (executable).filename())
  {}

  /** Runs commands of a shell. */
  Outcome
  shell (const std::string& commands) const
  {
    const std::string line = "cd '" + folder_.path().string() + "' && { " + commands +
                             "\n} >'" + (logs_ / "out").string() + "' 2>'" +
                             (logs_ / "err").string() + "'";
    const int status = std::system (line.c_str());
    return {WIFEXITED (status) ? WEXITSTATUS (status) : -1,
            readFile (logs_ / "out"),
            readFile (logs_ / "err")};
  }

  /** Runs the application with arguments as a shell reads them, after \a before. */
  Outcome
  run (const std::string& arguments, const std::string& before = "") const
  {
    return shell (before + " " + application_ + " " + arguments);
  }

  /** Bad usage and bad input: exit 1, one line on stderr that holds \a reason, no
   * output, and all files as they were. */
  void
  expectRefused (const std::string& arguments,
                 const std::string& reason,
                 const std::string& before = "") const
  {
    const auto files = readFolder (folder_.path());
    const Outcome result = run (arguments, before);
    EXPECT_EQ (result.code, 1) << arguments;
    EXPECT_EQ (result.out, "") << arguments;
    EXPECT_EQ (result.err.rfind (name_ + ": ", 0), 0u) << result.err;
    EXPECT_EQ (std::count (result.err.begin(), result.err.end(), '\n'), 1)
        << result.err;
    EXPECT_EQ (result.err.back(), '\n') << result.err;
    EXPECT_NE (result.err.find (reason), std::string::npos) << result.err;
    EXPECT_TRUE (readFolder (folder_.path()) == files) << arguments;
  }

  /** The application, as a shell reads it. */
  const std::string application_;
  const std::string name_;
  const TemporaryFolder folder_;
  const TemporaryFolder logs_;
};
