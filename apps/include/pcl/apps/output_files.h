// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Files that appear all together or not at all.
 *
 * Each is written under a temporary name beside its place, and renamed by commit().
 * Without commit(), the destructor removes them and the folders created for them.
 * Nothing that was there before is touched until commit(). Errors are AppErrors.
 */
class OutputFiles {
public:
  OutputFiles() = default;
  OutputFiles (const OutputFiles&) = delete;
  OutputFiles&
  operator= (const OutputFiles&) = delete;
  ~OutputFiles();

  /** \brief From now on reserve() and write() refuse to replace these files. */
  void
  protect (const std::vector<std::filesystem::path>& inputs);

  /** \brief Creates \a folder, and those above it, where missing. */
  void
  createFolder (const std::filesystem::path& folder);

  /** \brief Writes an empty file for one that write() fills later: where it cannot be is
   * known before the work is done. Its folder must exist; no other file of this object may
   * have its name. */
  void
  reserve (const std::filesystem::path& file);

  /** \brief Writes a file that was reserved, or else a new one, as reserve() does. */
  void
  write (const std::filesystem::path& file, const std::string& contents);

  /** \brief Puts the files in place, those that were reserved or written first last. Where one
   * cannot be, the others go again; those that they replaced do not come back. */
  void
  commit ();

private:
  struct File {
    std::filesystem::path path;
    std::filesystem::path temporary;
    bool is_reserved = false;
  };

  /** AppError where there can be no file of this name. */
  File&
  add (const std::filesystem::path& name);

  static void
  fill (const File& file, const std::string& contents);

  std::set<std::filesystem::path> protected_;
  std::vector<File> files_;
  /** Where each path is among the files: recordings have a hundred thousand. */
  std::map<std::filesystem::path, std::size_t> place_of_path_;
  std::vector<std::filesystem::path> created_folders_;
};

/** \brief AppError where \a output is one of the folders \a inputs, from which frames are read:
 * the next run would take what is written there for frames, or it may replace what belongs to
 * the recording. */
void
refuseInputFolder (const std::set<std::filesystem::path>& inputs,
                   const std::filesystem::path& output);

} // namespace rgbd_planes
} // namespace pcl
