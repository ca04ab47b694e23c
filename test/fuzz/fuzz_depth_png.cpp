// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

// The reader of depth images: files of any bytes, and ones with right checksums, which
// random bytes never have.

#include "scratch_file.h"
#include <fuzzer/FuzzedDataProvider.h>
#include <zlib.h>

#include <pcl/apps/depth_image.h>

#include <vector>

namespace {

std::string
bigEndian (std::uint32_t number)
{
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8)
    bytes += static_cast<char> (number >> shift & 0xff);
  return bytes;
}

std::string
chunk (const std::string& type, const std::string& data)
{
  const std::string body = type + data;
  const auto sum = ::crc32 (
      0, reinterpret_cast<const Bytef*> (body.data()), static_cast<uInt> (body.size()));
  return bigEndian (static_cast<std::uint32_t> (data.size())) + body +
         bigEndian (static_cast<std::uint32_t> (sum));
}

std::string
compress (const std::string& data)
{
  uLongf size = ::compressBound (data.size());
  std::string bytes (size, '\0');
  ::compress (reinterpret_cast<Bytef*> (bytes.data()),
              &size,
              reinterpret_cast<const Bytef*> (data.data()),
              data.size());
  bytes.resize (size);
  return bytes;
}

std::string
anyPng (FuzzedDataProvider& data)
{
  std::string header = bigEndian (data.ConsumeIntegralInRange (0, 40)) +
                       bigEndian (data.ConsumeIntegralInRange (0, 40));
  if (data.ConsumeIntegralInRange (0, 9) == 0)
    header = data.ConsumeBytesAsString (8);
  header +=
      data.ConsumeBool() ? std::string ("\x10\0", 2) : data.ConsumeBytesAsString (2);
  header +=
      std::string (2, '\0') + static_cast<char> (data.ConsumeIntegralInRange (0, 2));
  std::string png = "\x89PNG\r\n\x1a\n" + chunk ("IHDR", header);
  for (int n = data.ConsumeIntegralInRange (0, 3); n > 0; --n) {
    const char* type = data.PickValueInArray ({"gAMA",
                                               "tRNS",
                                               "PLTE",
                                               "sBIT",
                                               "sRGB",
                                               "tEXt",
                                               "iCCP",
                                               "bKGD",
                                               "IEND",
                                               "zzZz"});
    png += chunk (type, data.ConsumeRandomLengthString (40));
  }
  png += chunk ("IDAT", compress (data.ConsumeRandomLengthString (4000)));
  return data.ConsumeBool() ? png + chunk ("IEND", "") : png;
}

} // namespace

extern "C" int
LLVMFuzzerTestOneInput (const std::uint8_t* bytes, std::size_t size)
{
  FuzzedDataProvider data (bytes, size);
  const std::string png =
      data.ConsumeBool() ? anyPng (data) : data.ConsumeRemainingBytesAsString();
  fuzz::mayBeRefused ([&] {
    const fuzz::ScratchFile file (reinterpret_cast<const std::uint8_t*> (png.data()),
                                  png.size());
    const auto image = pcl::rgbd_planes::readDepthPng (file.path());
    const auto cloud =
        pcl::rgbd_planes::toCloud (image, {50.f, 50.f, 20.f, 20.f}, 1000.f);
    if (cloud->size() != std::size_t{image.width} * image.height)
      std::abort();
  });
  return 0;
}
