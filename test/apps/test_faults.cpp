// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "app_test.h"
#include "x_client.h"

#include <gtest/gtest.h>

#include <csignal>

namespace {

struct App {
  const char* executable;
  /** What makes it write all it can into the folder DISK. */
  const char* output;
  const char* simulated_frame = "sim:table_single --resolution qqvga ";
  const char* size_of_files = "--resolution vga ";
};

constexpr App evaluate_detection{EVALUATE_DETECTION, "--json DISK/out.json"};
constexpr App evaluate_normals{EVALUATE_NORMALS, "--json DISK/out.json"};
constexpr App evaluate_planes{EVALUATE_PLANES, "--json DISK/out.json"};
constexpr App measure_depth_noise{MEASURE_DEPTH_NOISE, "--json DISK/out.json"};
constexpr App segment_planes{
    SEGMENT_PLANES, "--objects --obstacles --output DISK/out --json DISK/out.json"};
constexpr App simulate_rgbd{
    SIMULATE_RGBD, "--output DISK/out", "table_single --resolution qqvga "};
constexpr App plane_viewer{
    PLANE_VIEWER, "--frames 3 --base-transform 0,0,1,0,0,0 --screenshot DISK/out.png"};
#ifdef BENCHMARK
constexpr App benchmark{BENCHMARK,
                        "--benchmark_filter=copy_floor/qqvga "
                        "--benchmark_out=DISK/out.json --benchmark_format=json "
                        ">/dev/null",
                        "sim:table_single ",
                        ""};
#endif

void
PrintTo (const App& app, std::ostream* stream)
{
  *stream << app.output;
}

std::string
nameOf (const testing::TestParamInfo<App>& info)
{
  return std::filesystem::path (info.param.executable).filename();
}

/** An application that is started in an empty folder, where something goes wrong. */
class Faults : public AppTest, public testing::WithParamInterface<App> {
protected:
  Faults() : AppTest (GetParam().executable) {}

  void
  SetUp () override
  {
    if (name_ == "pcl_plane_viewer" && !std::getenv ("DISPLAY"))
      GTEST_SKIP() << "there is no display: install the packages xvfb and xauth";
  }

  static std::string
  outputTo (const std::string& disk)
  {
    std::string output = GetParam().output;
    for (std::size_t at; (at = output.find ("DISK")) != std::string::npos;)
      output.replace (at, 4, disk);
    return output;
  }

  /** One line on stderr that holds \a reason, and nothing of the results is left. */
  void
  expectFailed (const Outcome& outcome, const std::string& reason) const
  {
    EXPECT_EQ (outcome.code, 1);
    EXPECT_EQ (outcome.err.rfind (name_ + ": ", 0), 0u) << outcome.err;
    EXPECT_NE (outcome.err.find (reason), std::string::npos) << outcome.err;
    EXPECT_EQ (outcome.err.find ('\n'), outcome.err.size() - 1) << outcome.err;
    EXPECT_FALSE (std::filesystem::exists (folder_ / "out"));
    for (const auto& file : listFolder (folder_.path()))
      EXPECT_EQ (file.find ("out."), std::string::npos) << file;
  }

  /** Only the tables are lost. */
  void
  expectWrittenButNotPrinted (const Outcome& outcome) const
  {
    EXPECT_EQ (outcome.code, 1);
    EXPECT_EQ (outcome.err, name_ + ": cannot write to standard output\n");
    EXPECT_TRUE (std::filesystem::exists (folder_ / "out") ||
                 std::filesystem::exists (folder_ / "out.json"));
    for (const auto& file : listFolder (folder_.path()))
      EXPECT_NE (file.front(), '.') << file;
  }

  /** Whether the application is at work, for a shell. */
  const std::string results_begun_ = "{ [ -e out ] || ls .out.* >/dev/null 2>&1; }";

  /** In the background, shells ignore SIGINT. */
  const std::string interruptible_ = "env --default-signal=INT ";

  /** Is there all the time: Xvfb starts anew when its last client goes. */
  const XClient client_;
};

/** While it writes the results of a simulated frame. */
class OutputFaults : public Faults {
protected:
  const std::string work_ = GetParam().simulated_frame;

  /** Runs the application where "disk" is a file system of its own, after commands of a
   * shell; prints what is on it afterwards. */
  Outcome
  runOnDisk (const std::string& options, const std::string& before) const
  {
    return shell ("mkdir -p disk && unshare -rm sh -c \"mount -t tmpfs -o size=64k" +
                  options + " none disk && " + before + " { " + application_ + " " +
                  work_ + outputTo ("disk") +
                  "; code=\\$?; ls -A disk; exit \\$code; }\"");
  }
};

bool
cannotMount ()
{
  return std::system ("unshare -rm mount -t tmpfs none /mnt 2>/dev/null") != 0;
}

/** While it reads depth images: 1.png, 2.png and 3.png of the folder "in". */
class InputFaults : public Faults {
protected:
  void
  SetUp () override
  {
    Faults::SetUp();
    std::filesystem::create_directory (folder_ / "in");
    writePng (folder_ / "frame.png", 160, std::vector<std::uint16_t> (160 * 160, 1000));
    frame_ = readFile (folder_ / "frame.png");
    for (const char* name : {"in/1.png", "in/2.png", "in/3.png"})
      writeFile (folder_ / name, frame_);
  }

  /** Starts the application and, when it is about to read the second frame, runs
   * commands of a shell, which find its process as $pid and the pipe the frame comes
   * through as 3. */
  Outcome
  runAndInterfere (const std::string& commands) const
  {
    return shell ("rm in/2.png; mkfifo in/2.png; " + interruptible_ + application_ +
                  " in" + camera_ + outputTo (".") + "& pid=$!; exec 3>in/2.png; " +
                  commands + "; exec 3>&-; wait $pid");
  }

  std::string frame_;
  const std::string camera_ =
      std::string (" --intrinsics 131,131,79.5,79.5 --depth-scale 1000 ") +
      GetParam().size_of_files;
};

/** Of applications that print results, and work while their files are open. */
class PrintedOutputFaults : public OutputFaults {};
class PrintedInputFaults : public InputFaults {};

} // namespace

TEST_P (OutputFaults, FullDisk)
{
  if (cannotMount())
    GTEST_SKIP() << "needs a file system of its own, which 'unshare -rm' may not mount";
  const Outcome outcome = runOnDisk ("", "cat /dev/zero >disk/all_of_it 2>/dev/null;");
  expectFailed (outcome, "No space left on device");
  EXPECT_EQ (outcome.out, "all_of_it\n");
}

TEST_P (OutputFaults, ReadOnlyDisk)
{
  if (cannotMount())
    GTEST_SKIP() << "needs a file system of its own, which 'unshare -rm' may not mount";
  const Outcome outcome = runOnDisk (",ro", "");
  expectFailed (outcome, "Read-only file system");
  EXPECT_EQ (outcome.out, "");
}

TEST_P (OutputFaults, NoFolderCanBeThere)
{
  writeFile (folder_ / "file", "");
  expectRefused (work_ + outputTo ("file"), "file");
  expectRefused (work_ + outputTo ("/proc"), "/proc/out");
}

/** As where a user's share of a disk is used up; a pipe takes the message. */
TEST_P (OutputFaults, NoBytesMayBeWritten)
{
  const Outcome outcome =
      shell ("{ { (ulimit -f 0; { " + application_ + " " + work_ + outputTo (".") +
             "; } 2>&1 >/dev/null; echo $? >&3) | cat >&2; } 3>&1; } | "
             "(read code; exit $code)");
  expectFailed (outcome, "File too large");
}

TEST_P (PrintedOutputFaults, FullStandardOutput)
{
  expectWrittenButNotPrinted (run (work_ + outputTo (".") + " >/dev/full"));
}

TEST_P (PrintedOutputFaults, InterruptionAtAnyTime)
{
  const Outcome outcome = shell (interruptible_ + application_ + " " + work_ +
                                 outputTo (".") + "& pid=$!; until " + results_begun_ +
                                 "; do :; done; "
                                 "kill -INT $pid; wait $pid");
  expectFailed (outcome, "interrupted; nothing was written");
  EXPECT_EQ (outcome.out, "");
}

TEST_P (InputFaults, TruncatedFiles)
{
  const std::string options = camera_ + outputTo (".");
  for (const std::size_t size :
       {std::size_t{0}, frame_.size() / 2, frame_.size() - 9}) {
    writeFile (folder_ / "in/3.png", frame_.substr (0, size));
    expectRefused ("in" + options, "in/3.png: ");
  }
  std::string points;
  for (int i = 0; i < 160 * 160; ++i)
    points += "0 0 1\n";
  const std::string pcd = asciiPcd ("x y z", 160, 160, points);
  for (const std::size_t size : {std::size_t{0}, std::size_t{60}, pcd.size() / 2}) {
    writeFile (folder_ / "half.pcd", pcd.substr (0, size));
    expectRefused ("half.pcd " + outputTo ("."), "half.pcd: ");
  }
}

TEST_P (InputFaults, WrongIntrinsics)
{
  const std::string scale = " --depth-scale 1000 ", options = scale + outputTo (".");
  expectRefused ("in" + options, "add --intrinsics");
  expectRefused ("in --intrinsics 131,131,79.5,79.5 " + outputTo ("."),
                 "add --depth-scale");
  for (const std::string intrinsics : {"",
                                       "131,131,79.5",
                                       "0,0,0,0",
                                       "-1,1,1,1",
                                       "nan,1,1,1",
                                       "1,1,inf,1",
                                       "131;131;79;79"})
    expectRefused ("in --intrinsics '" + intrinsics + "'" + options, "--intrinsics");
  writeFile (folder_ / "in/depth.txt", "1.5 1.png\n");
  expectRefused ("in " + outputTo ("."), "1.png: has 160 x 160 pixels, for which no");
}

TEST_P (InputFaults, FilesThatChange)
{
  for (const std::string change : {"rm in/3.png",
                                   ": >in/3.png",
                                   "head -c 100 frame.png >in/3.png",
                                   "echo text >in/3.png",
                                   "rm in/3.png; mkdir in/3.png"}) {
    expectFailed (runAndInterfere (change + "; cat frame.png >&3"), "in/3.png: ");
    std::filesystem::remove_all (folder_ / "in/3.png");
    writeFile (folder_ / "in/3.png", frame_);
  }
  expectFailed (runAndInterfere ("head -c 100 frame.png >&3"), "in/2.png: ");
}

TEST_P (InputFaults, Signals)
{
  std::signal (SIGHUP, SIG_DFL); // nohup has programs ignore it
  for (const std::string signal : {"INT", "TERM", "HUP"}) {
    const Outcome outcome =
        runAndInterfere ("kill -" + signal + " $pid; cat frame.png >&3");
    expectFailed (outcome, "interrupted; nothing was written");
    EXPECT_EQ (outcome.out, "");
  }
}

TEST_P (PrintedInputFaults, SignalsEndTheWaitForAPipe)
{
  std::filesystem::remove (folder_ / "in/1.png");
  const Outcome outcome = shell ("mkfifo in/1.png; " + application_ + " in" + camera_ +
                                 outputTo (".") + "& pid=$!; until " + results_begun_ +
                                 " && "
                                 "grep -q '^State:.S' /proc/$pid/status; do :; done; "
                                 "kill -TERM $pid; wait $pid");
  expectFailed (outcome, "interrupted; nothing was written");
}

TEST_P (PrintedOutputFaults, IgnoredSignalsStayIgnored)
{
  const Outcome outcome = shell ("trap '' INT TERM HUP; " + application_ + " " + work_ +
                                 outputTo (".") + "& pid=$!; until " + results_begun_ +
                                 "; do :; done; "
                                 "kill -INT $pid; kill -TERM $pid; kill -HUP $pid; "
                                 "wait $pid");
  EXPECT_EQ (outcome.code, 0) << outcome.err;
}

TEST_P (PrintedInputFaults, ReaderOfTheResultsThatEnds)
{
  const Outcome outcome = shell ("rm in/2.png; mkfifo in/2.png results; " +
                                 application_ + " in" + camera_ + outputTo (".") +
                                 " >results & pid=$!; : <results; "
                                 "cat frame.png >in/2.png; wait $pid");
  expectWrittenButNotPrinted (outcome);
}

namespace {

const auto readers = testing::Values (evaluate_detection,
                                      evaluate_normals,
                                      evaluate_planes,
                                      measure_depth_noise,
                                      segment_planes);
const auto simulator = testing::Values (simulate_rgbd);
const auto viewer = testing::Values (plane_viewer);

} // namespace

INSTANTIATE_TEST_SUITE_P (Apps, OutputFaults, readers, nameOf);
INSTANTIATE_TEST_SUITE_P (Apps, PrintedOutputFaults, readers, nameOf);
INSTANTIATE_TEST_SUITE_P (Apps, InputFaults, readers, nameOf);
INSTANTIATE_TEST_SUITE_P (Apps, PrintedInputFaults, readers, nameOf);
INSTANTIATE_TEST_SUITE_P (Simulator, OutputFaults, simulator, nameOf);
INSTANTIATE_TEST_SUITE_P (Simulator, PrintedOutputFaults, simulator, nameOf);
INSTANTIATE_TEST_SUITE_P (Viewer, OutputFaults, viewer, nameOf);
INSTANTIATE_TEST_SUITE_P (Viewer, InputFaults, viewer, nameOf);
#ifdef BENCHMARK
const auto times = testing::Values (benchmark);
INSTANTIATE_TEST_SUITE_P (Benchmark, OutputFaults, times, nameOf);
INSTANTIATE_TEST_SUITE_P (Benchmark, PrintedOutputFaults, times, nameOf);
INSTANTIATE_TEST_SUITE_P (Benchmark, InputFaults, times, nameOf);
INSTANTIATE_TEST_SUITE_P (Benchmark, PrintedInputFaults, times, nameOf);
#endif
