// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "files.h"
#include <unistd.h>

#include <pcl/apps/app_error.h>
#include <pcl/apps/output_files.h>

#include <gtest/gtest.h>

namespace fs = std::filesystem;
using namespace pcl::rgbd_planes;
using Names = std::vector<std::string>;

TEST (OutputFiles, AppearWithCommit)
{
  const TemporaryFolder folder;
  writeFile (folder / "old.txt", "old");
  {
    OutputFiles files;
    files.createFolder (folder / "a/b");
    files.reserve (folder / "a/b/new.txt");
    files.write (folder / "old.txt", "new");
    files.write (folder / "a/../a/b/new.txt", "contents");
    EXPECT_EQ (readFile (folder / "old.txt"), "old");
    EXPECT_FALSE (fs::exists (folder / "a/b/new.txt"));
    files.commit();
  }
  EXPECT_EQ (readFile (folder / "old.txt"), "new");
  EXPECT_EQ (readFile (folder / "a/b/new.txt"), "contents");
  EXPECT_EQ (listFolder (folder.path()), (Names{"a", "old.txt"}));
  EXPECT_EQ (listFolder (folder / "a/b"), Names{"new.txt"});
}

TEST (OutputFiles, LeaveNothingWithoutCommit)
{
  const TemporaryFolder folder;
  fs::create_directory (folder / "a");
  {
    OutputFiles files;
    files.createFolder (folder / "a/b/c/");
    files.write (folder / "a/b/c/new.txt", "contents");
  }
  EXPECT_EQ (listFolder (folder.path()), Names{"a"});
  EXPECT_EQ (listFolder (folder / "a"), Names{});
}

TEST (OutputFiles, LeaveNothingNewAfterAFailedCommit)
{
  const TemporaryFolder folder;
  writeFile (folder / "old.txt", "old");
  {
    OutputFiles files;
    files.createFolder (folder / "a");
    files.write (folder / "taken.txt", "1");
    files.write (folder / "a/new.txt", "2");
    files.write (folder / "old.txt", "3");
    fs::create_directory (folder / "taken.txt");
    EXPECT_THROW (files.commit(), AppError);
  }
  EXPECT_EQ (listFolder (folder.path()), (Names{"old.txt", "taken.txt"}));
  EXPECT_EQ (readFile (folder / "old.txt"), "3");
}

TEST (OutputFiles, InputsAreNotReplaced)
{
  const TemporaryFolder folder;
  writeFile (folder / "in.pcd", "recording");
  fs::create_symlink ("in.pcd", folder / "link.pcd");
  for (const std::string input : {"in.pcd", "link.pcd"}) {
    OutputFiles files;
    files.protect ({folder / input, "", folder / "missing.pcd"});
    EXPECT_THROW (files.write (folder / "in.pcd", ""), AppError);
    EXPECT_THROW (files.write (folder / "link.pcd", ""), AppError);
    EXPECT_NO_THROW (files.write (folder / "out.pcd", ""));
  }
}

TEST (OutputFiles, ReplacedOnesKeepTheirPermissions)
{
  const TemporaryFolder folder;
  writeFile (folder / "secret.txt", "old");
  const auto secret = fs::perms::owner_read;
  fs::permissions (folder / "secret.txt", secret);
  OutputFiles files;
  files.reserve (folder / "secret.txt");
  files.write (folder / "secret.txt", "new");
  for (const auto& name : listFolder (folder.path())) // also of the temporary file
    EXPECT_EQ (fs::status (folder / name).permissions(), secret) << name;
  files.commit();
  EXPECT_EQ (readFile (folder / "secret.txt"), "new");
  EXPECT_EQ (fs::status (folder / "secret.txt").permissions(), secret);
}

TEST (OutputFiles, LinksStayAlsoToWhatIsNotThere)
{
  const TemporaryFolder folder;
  fs::create_directory (folder / "a");
  fs::create_symlink ("a/link", folder / "link");
  fs::create_symlink (folder / "new.txt", folder / "a/link");
  for (const std::string contents : {"1", "2"}) {
    OutputFiles files;
    files.reserve (folder / "link");
    EXPECT_THROW (files.reserve (folder / "new.txt"), AppError);
    files.write (folder / "link", contents);
    files.commit();
    EXPECT_EQ (readFile (folder / "new.txt"), contents);
    EXPECT_TRUE (fs::is_symlink (folder / "link"));
    EXPECT_TRUE (fs::is_symlink (folder / "a/link"));
  }
}

TEST (OutputFiles, PipesOfTheShellAreRefused)
{
  int pipe[2];
  ASSERT_EQ (::pipe (pipe), 0);
  try {
    OutputFiles().reserve ("/dev/fd/" + std::to_string (pipe[1]));
    FAIL();
  }
  catch (const AppError& error) {
    EXPECT_NE (std::string (error.what()).find ("no regular file"), std::string::npos);
  }
  ::close (pipe[0]);
  ::close (pipe[1]);
}

TEST (OutputFiles, TwoResultsInOneFileAreRefused)
{
  const TemporaryFolder folder;
  fs::create_directory (folder / "a");
  OutputFiles files;
  files.reserve (folder / "1.txt");
  EXPECT_THROW (files.reserve (folder / "1.txt"), AppError);
  EXPECT_THROW (files.reserve (folder / "a/../1.txt"), AppError);
  files.write (folder / "1.txt", "1");
  EXPECT_THROW (files.write (folder / "1.txt", "2"), AppError);
  files.write (folder / "2.txt", "2");
  EXPECT_THROW (files.reserve (folder / "2.txt"), AppError);
  files.commit();
  EXPECT_EQ (readFile (folder / "1.txt"), "1");
  EXPECT_EQ (readFile (folder / "2.txt"), "2");
}

TEST (OutputFiles, NamesOfNoFileAreRefused)
{
  const TemporaryFolder folder;
  OutputFiles files;
  EXPECT_THROW (files.reserve (""), AppError);
  EXPECT_THROW (files.reserve ("-"), AppError);
  EXPECT_NO_THROW (files.reserve (folder / "-"));
  EXPECT_THROW (files.write (folder / "", ""), AppError);
}

TEST (OutputFiles, FoldersOfInputsAreRefused)
{
  const TemporaryFolder folder;
  fs::create_directories (folder / "in/deeper");
  writeFile (folder / "file", "");
  const std::set<fs::path> inputs{folder / "file", folder / "in/.", "sim:room"};
  EXPECT_THROW (refuseInputFolder (inputs, folder / "in"), AppError);
  EXPECT_THROW (refuseInputFolder (inputs, folder / "in/deeper/.."), AppError);
  for (const std::string output : {"", "file", "in/deeper", "missing"})
    EXPECT_NO_THROW (refuseInputFolder (inputs, folder / output)) << output;
}

TEST (OutputFiles, ImpossiblePlacesAreRefused)
{
  const TemporaryFolder folder;
  writeFile (folder / "file", "");
  fs::create_directory (folder / "folder");
  OutputFiles files;
  EXPECT_THROW (files.createFolder (folder / "file"), AppError);
  EXPECT_THROW (files.createFolder (folder / "file/folder"), AppError);
  try {
    files.createFolder ("");
    FAIL();
  }
  catch (const AppError& error) {
    EXPECT_STREQ (error.what(), "'': is no name of a folder to write to; give one");
  }
  EXPECT_THROW (files.write (folder / "folder", ""), AppError);
  EXPECT_THROW (files.write (folder / "nothing/file", ""), AppError);
  EXPECT_THROW (files.write ("/dev/null", ""), AppError);
  EXPECT_THROW (files.write ("/dev/full", ""), AppError);
}
