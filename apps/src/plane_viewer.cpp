// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/app_error.h>
#include <pcl/apps/encode_pcd.h>
#include <pcl/apps/frame_grabber.h>
#include <pcl/apps/input_notices.h>
#include <pcl/apps/input_options.h>
#include <pcl/apps/output_files.h>
#include <pcl/apps/plane_report.h>
#include <pcl/apps/plane_viewer.h>

#include <boost/format.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <iostream>

namespace pcl {
namespace rgbd_planes {

namespace {

constexpr char keys_help[] =
    "  space  pause, or go on; at the end, from the beginning\n"
    "  .      show one frame more, and pause\n"
    "  d      resolution: VGA, QVGA, QQVGA (every 1st, 2nd, 4th pixel)\n"
    "  w      points as measured, or corrected by --corrected\n"
    "  s      save what is seen as FRAME_view.png, the frame as FRAME_view.pcd\n"
    "  r      look from the camera again\n"
    "  h      show or hide this help\n"
    "  + -    larger or smaller points\n"
    "  q      quit\n"
    "  shift and left click: what plane this is, here and on the terminal\n"
    "  mouse: left turns, middle moves, right or wheel zooms\n";

/** Of text in the window as it opens. */
constexpr std::size_t columns = 110;

} // namespace

std::string
viewerKeysHelp ()
{
  std::string text;
  for (const auto& layer : viewer_layers)
    text += (boost::format ("  %c      show or hide %s: %s\n") % layer.key %
             layer.name % layer.help)
                .str();
  return text + keys_help;
}

PlaneViewer::PlaneViewer (const ViewerOptions& options)
: options_ (options)
, window_ ([this] (char key) { return takeKey (key); },
           [this] (const Eigen::Vector3f& point) { takePoint (point); })
, frames_left_ (options.max_frames)
, frame_ (options.camera_to_base, options.corrected, options.depth_noise)
{}

PlaneViewer::~PlaneViewer()
{
  if (grabber_)
    grabber_->stop();
}

void
PlaneViewer::show (const Frame& frame)
{
  original_ = frame;
  frame_.compute (*original_, options_.step);
  if (times_.empty())
    printNotices();
  times_.push_back (std::chrono::steady_clock::now());
  while (times_.back() - times_.front() > std::chrono::seconds (2))
    times_.pop_front();
  if (!is_view_chosen_)
    is_view_chosen_ = window_.lookFromCamera (frame_.cloud());
  draw();
}

/** What is to be known of the first frame. */
void
PlaneViewer::printNotices() const
{
  SegmenterOptions options;
  options.depth_noise = options_.depth_noise;
  options.find_objects = options.find_obstacles = true;
  InputNotices notices (options);
  notices.add (frame_.frame(), frame_.summary());
  for (const auto& line : notices.lines())
    printNotice (line);
}

void
PlaneViewer::play (pcl::Grabber& grabber)
{
  slot_.connect (grabber);
  grabber_ = &grabber;
  grabber.start();
}

bool
PlaneViewer::update()
{
  constexpr std::chrono::milliseconds patience (10);
  const auto frame = slot_.take (patience);
  if (frame && frames_left_ > 0) { // others come before the grabber has stopped
    if (--frames_left_ == 0)
      grabber_->stop();
    show (*frame);
  }
  window_.processEvents();
  if (statusText() != status_)
    refresh();
  return !window_.isClosed();
}

bool
PlaneViewer::takeKey (char key)
{
  for (std::size_t k = 0; k < viewer_layers.size(); ++k)
    if (key == viewer_layers[k].key) {
      options_.layers.flip (k);
      draw();
      return true;
    }
  switch (key) {
  case ' ':
    pauseOrGoOn();
    break;
  case '.':
    stepOn();
    break;
  case 'd':
    changeResolution();
    return true;
  case 'w':
    switchCorrection();
    return true;
  case 's':
    save();
    break;
  case 'r':
    window_.lookFromCamera (frame_.cloud());
    break;
  case 'h':
    help_is_shown_ = !help_is_shown_;
    window_.showHelp (help_is_shown_ ? viewerKeysHelp() : "");
    break;
  default:
    return false;
  }
  refresh();
  return true;
}

void
PlaneViewer::takePoint (const Eigen::Vector3f& point)
{
  message_ = frame_.summary().name + ": " + frame_.describePlane (point);
  std::cout << message_ << std::endl;
}

void
PlaneViewer::pauseOrGoOn()
{
  if (!grabber_)
    return;
  if (grabber_->isRunning())
    return grabber_->stop();
  frames_left_ = options_.max_frames;
  grabber_->start();
}

void
PlaneViewer::stepOn()
{
  if (!grabber_)
    return;
  grabber_->stop();
  if (auto* player = dynamic_cast<FrameGrabber*> (grabber_))
    return player->trigger();
  frames_left_ = 1;
  grabber_->start();
}

void
PlaneViewer::changeResolution()
{
  if (!original_)
    return;
  const auto& cloud = *original_->cloud;
  const std::uint32_t coarser = 2 * options_.step;
  constexpr std::uint32_t coarsest = 4;
  options_.step = coarser > coarsest || std::min (cloud.width, cloud.height) <= coarser
                      ? 1
                      : coarser;
  computeAgain();
}

void
PlaneViewer::switchCorrection()
{
  if (!options_.corrected) {
    message_ = "points are as measured; start with --corrected to correct them";
    return refresh();
  }
  frame_.setCorrected (!frame_.isCorrected());
  computeAgain();
}

void
PlaneViewer::computeAgain()
{
  if (!original_)
    return refresh();
  frame_.compute (*original_, options_.step);
  draw();
}

void
PlaneViewer::save()
{
  if (!original_)
    return;
  try {
    OutputFiles files;
    files.protect (options_.inputs); // FRAME_view is no frame beside FRAME
    files.createFolder (options_.output);
    const auto file = options_.output / (frame_.summary().name + "_view");
    files.write (file.string() + ".png", encodePng (window_.picture()));
    files.write (file.string() + ".pcd", encodePcd (frame_.cloud()));
    files.commit();
    message_ = "saved " + file.string() + ".png and .pcd";
    std::cout << message_ << std::endl;
  }
  catch (const std::exception& error) {
    message_ = error.what();
    std::cerr << message_ << std::endl;
  }
}

void
PlaneViewer::draw()
{
  if (!original_)
    return;
  const double pixels = window_.interactor().GetSize()[0];
  const auto point_size = static_cast<int> (std::ceil (pixels / frame_.cloud().width));
  window_.showCloud (paintCloud (frame_, options_.layers), point_size);
  window_.showLines (drawLines (frame_, options_.layers));
  refresh();
}

void
PlaneViewer::refresh()
{
  status_ = statusText();
  window_.showStatus (status_);
  window_.render();
}

std::string
PlaneViewer::statusText() const
{
  if (!original_)
    return "waiting for the first frame";
  const FrameSummary& summary = frame_.summary();
  std::string text =
      (boost::format ("%s, %d x %d: %d planes, %d objects, %d obstacles\n%s") %
       summary.name % summary.width % summary.height % summary.planes.size() %
       summary.objects.size() % summary.obstacles.size() %
       stageTimesText (summary.times))
          .str();
  if (grabber_) {
    const double seconds =
        std::chrono::duration<double> (times_.back() - times_.front()).count();
    const double rate =
        seconds > 0. ? static_cast<double> (times_.size() - 1) / seconds : 0.;
    text += (boost::format ("%.1f frames/s, %d dropped, %s\n") % rate %
             slot_.dropped() % (grabber_->isRunning() ? "playing" : "paused"))
                .str();
  }
  text += "shown: " + layerNames (options_.layers) +
          (frame_.isCorrected() ? "   corrected" : "") + "   h: help";
  return message_.empty() ? text : text + '\n' + wrap (message_, columns);
}

} // namespace rgbd_planes
} // namespace pcl
