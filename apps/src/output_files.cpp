// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <unistd.h>

#include <pcl/apps/app_error.h>
#include <pcl/apps/output_files.h>

#include <cerrno>
#include <cstring>
#include <fstream>

namespace fs = std::filesystem;

namespace pcl {
namespace rgbd_planes {

namespace {

/** The same for all names of a file, also before it is there. */
fs::path
placeOf (const fs::path& name)
{
  fs::path place = fs::weakly_canonical (fs::current_path() / name);
  while (fs::is_symlink (place)) // to a file that is not there
    place = fs::weakly_canonical (place.parent_path() / fs::read_symlink (place));
  return place;
}

/** Those of a file that it replaces, as far as the file system has them. */
void
keepPermissions (const fs::path& old_file, const fs::path& new_file)
{
  std::error_code ignored;
  const fs::file_status status = fs::status (old_file, ignored);
  if (fs::exists (status))
    fs::permissions (new_file, status.permissions(), ignored);
}

} // namespace

OutputFiles::~OutputFiles()
{
  std::error_code ignored;
  for (const auto& file : files_)
    fs::remove (file.temporary, ignored);
  for (auto folder = created_folders_.rbegin(); folder != created_folders_.rend();
       ++folder)
    fs::remove (*folder, ignored);
}

void
OutputFiles::protect (const std::vector<fs::path>& inputs)
{
  for (const auto& input : inputs)
    protected_.insert (fs::weakly_canonical (input));
}

void
OutputFiles::createFolder (const fs::path& folder)
{
  if (folder.empty())
    throw AppError ("'': is no name of a folder to write to; give one");
  std::error_code error;
  if (fs::is_directory (folder, error)) {
    if (::access (folder.c_str(), W_OK | X_OK) != 0)
      throw AppError (folder.string() + ": cannot write to this folder: " +
                      std::strerror (errno) + "; choose another one");
    return;
  }
  if (folder.has_parent_path() && folder.parent_path() != folder)
    createFolder (folder.parent_path());
  if (folder.has_filename() && fs::create_directory (folder, error))
    created_folders_.push_back (folder);
  if (!fs::is_directory (folder))
    throw AppError (folder.string() + ": cannot create this folder: " +
                    error.message() + "; choose another one");
}

OutputFiles::File&
OutputFiles::add (const fs::path& name)
{
  if (!name.has_filename())
    throw AppError ("'" + name.string() + "': is no name of a file to write; give one");
  std::error_code error;
  if (name == "-" || fs::equivalent (name, "/dev/stdout", error))
    throw AppError (name.string() +
                    ": standard output has the tables; give the name of a file");
  // A pipe of the shell has no place.
  const fs::file_status status = fs::status (name, error);
  if (fs::exists (status) && !fs::is_regular_file (status))
    throw AppError (name.string() +
                    ": is there and no regular file; choose another name");
  const fs::path path = placeOf (name);
  if (place_of_path_.count (path))
    throw AppError (name.string() +
                    ": two results of this run would be in this file; choose another "
                    "name for one of them");
  if (protected_.count (path))
    throw AppError (name.string() +
                    ": is an input, which would be replaced; choose another name");
  const std::string temporary =
      "." + path.filename().string() + "." + std::to_string (::getpid()) + ".part";
  place_of_path_.emplace (path, files_.size());
  files_.push_back ({path, path.parent_path() / temporary});
  return files_.back();
}

void
OutputFiles::reserve (const fs::path& name)
{
  File& file = add (name);
  file.is_reserved = true;
  fill (file, "");
}

void
OutputFiles::write (const fs::path& name, const std::string& contents)
{
  const auto known = place_of_path_.find (placeOf (name));
  const bool is_reserved =
      known != place_of_path_.end() && files_[known->second].is_reserved;
  File& file = is_reserved ? files_[known->second] : add (name);
  file.is_reserved = false;
  fill (file, contents);
}

void
OutputFiles::fill (const File& file, const std::string& contents)
{
  std::error_code ignored;
  fs::remove (file.temporary, ignored); // a reserved one may be read-only
  errno = 0;
  std::ofstream stream (file.temporary, std::ios::binary);
  if (stream)
    keepPermissions (file.path, file.temporary);
  stream << contents;
  stream.close();
  if (!stream)
    throw AppError (file.path.string() + ": cannot write this file: " +
                    std::strerror (errno) + "; choose another place");
}

void
OutputFiles::commit()
{
  std::vector<fs::path> appeared;
  for (; !files_.empty(); files_.pop_back()) {
    const auto& [path, temporary, is_reserved] = files_.back();
    std::error_code error, ignored;
    const bool is_new = !fs::exists (path, ignored);
    fs::rename (temporary, path, error);
    if (error) {
      for (const auto& file : appeared)
        fs::remove (file, ignored);
      throw AppError (path.string() + ": cannot write this file: " + error.message() +
                      "; choose another place");
    }
    if (is_new)
      appeared.push_back (path);
  }
  place_of_path_.clear();
  created_folders_.clear();
}

void
refuseInputFolder (const std::set<fs::path>& inputs, const fs::path& output)
{
  std::error_code error;
  for (const auto& input : inputs)
    if (fs::is_directory (input, error) && fs::equivalent (input, output, error))
      throw AppError (output.string() +
                      ": is a folder of INPUT, where results may replace files of the "
                      "recording or be taken for frames; choose another folder");
}

} // namespace rgbd_planes
} // namespace pcl
