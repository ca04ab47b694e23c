// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <pcl/apps/app_error.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>

namespace fuzz {

/** A file in memory, for readers that take a path. */
class ScratchFile {
public:
  ScratchFile (const std::uint8_t* bytes, std::size_t size)
  : descriptor_ (::memfd_create ("fuzz", 0))
  , path_ ("/proc/self/fd/" + std::to_string (descriptor_))
  {
    if (::write (descriptor_, bytes, size) != static_cast<ssize_t> (size))
      std::abort();
  }
  ScratchFile (const ScratchFile&) = delete;
  ScratchFile&
  operator= (const ScratchFile&) = delete;
  ~ScratchFile() { ::close (descriptor_); }

  const std::string&
  path () const
  {
    return path_;
  }

private:
  int descriptor_;
  std::string path_;
};

/** A folder beside the fuzzer's own files: it goes with them. */
inline std::filesystem::path
scratchFolder (const std::string& name)
{
  const std::filesystem::path folder = std::filesystem::temp_directory_path() /
                                       (name + '.' + std::to_string (::getpid()));
  std::filesystem::create_directory (folder);
  return folder;
}

/** Bad input may end in an AppError, which has a message, and in nothing else. */
template <typename Reader>
void
mayBeRefused (Reader read)
{
  try {
    read();
  }
  catch (const pcl::rgbd_planes::AppError& error) {
    if (std::string (error.what()).empty())
      std::abort();
  }
}

} // namespace fuzz
