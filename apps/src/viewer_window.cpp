// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/display.h>
#include <pcl/apps/fit_camera.h>
#include <pcl/apps/viewer_window.h>
#include <pcl/visualization/interactor_style.h>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCommand.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWorldPointPicker.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

namespace pcl {
namespace rgbd_planes {

namespace {

constexpr char cloud_id[] = "cloud";

/** Gives keys to the handler before PCL, which has a use for nearly all of them, and what is
 * seen at a click with shift. PCL's own picking sometimes tells other points (its issue 3954).
 */
class ViewerStyle : public pcl::visualization::PCLVisualizerInteractorStyle {
public:
  static ViewerStyle*
  New ();

  vtkTypeMacro (ViewerStyle, pcl::visualization::PCLVisualizerInteractorStyle);

  void
  setHandlers (ViewerWindow::KeyHandler take_key, ViewerWindow::PickHandler take_point)
  {
    take_key_ = std::move (take_key);
    take_point_ = std::move (take_point);
  }

protected:
  void
  OnKeyDown () override
  {
    const auto key = static_cast<unsigned char> (Interactor->GetKeyCode());
    taken_ = !Interactor->GetControlKey() && !Interactor->GetAltKey() &&
             take_key_ (static_cast<char> (std::tolower (key)));
    if (!taken_)
      Superclass::OnKeyDown();
  }

  /** Follows OnKeyDown(). */
  void
  OnChar () override
  {
    if (!taken_)
      Superclass::OnChar();
  }

  void
  OnLeftButtonDown () override
  {
    if (Interactor->GetShiftKey())
      pick (Interactor->GetEventPosition());
    Superclass::OnLeftButtonDown();
  }

  /** PCL would draw. */
  void
  OnTimer () override
  {}

private:
  void
  pick (const int* pixel)
  {
    vtkRenderer* renderer = Interactor->FindPokedRenderer (pixel[0], pixel[1]);
    if (renderer->GetZ (pixel[0], pixel[1]) >= 1.)
      return; // nothing but background
    vtkNew<vtkWorldPointPicker> picker;
    picker->Pick (pixel[0], pixel[1], 0., renderer);
    take_point_ (
        Eigen::Map<const Eigen::Vector3d> (picker->GetPickPosition()).cast<float>());
  }

  ViewerWindow::KeyHandler take_key_;
  ViewerWindow::PickHandler take_point_;
  bool taken_ = false;
};

vtkStandardNewMacro (ViewerStyle);

vtkSmartPointer<vtkTextActor>
makeText (bool at_top)
{
  const auto text = vtkSmartPointer<vtkTextActor>::New();
  text->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  text->SetPosition (0.01, at_top ? 0.99 : 0.01);
  vtkTextProperty* property = text->GetTextProperty();
  property->SetFontFamilyToCourier();
  property->SetFontSize (15);
  property->SetBackgroundColor (0., 0., 0.);
  property->SetBackgroundOpacity (0.6);
  if (at_top)
    property->SetVerticalJustificationToTop();
  return text;
}

} // namespace

ViewerWindow::ViewerWindow (KeyHandler take_key, PickHandler take_point)
: lines_ (vtkSmartPointer<vtkActor>::New())
, status_ (makeText (true))
, help_ (makeText (false))
{
  checkDisplay();
  ViewerStyle* style = ViewerStyle::New(); // PCL takes it over
  style->setHandlers (std::move (take_key), std::move (take_point));
  int no_arguments = 0;
  visualizer_ = std::make_unique<pcl::visualization::PCLVisualizer> (
      no_arguments, nullptr, "pcl_plane_viewer", style);
  visualizer_->getRenderWindow()->SetMultiSamples (0);
  visualizer_->setSize (1024, 768);
  visualizer_->setShowFPS (false);
  style->RemoveObservers (vtkCommand::LeftButtonPressEvent); // PCL's picking
  lines_->SetMapper (vtkSmartPointer<vtkPolyDataMapper>::New());
  lines_->GetProperty()->SetLineWidth (2.f);
  lines_->GetProperty()->LightingOff();
  lines_->PickableOff();
  vtkRenderer* renderer = visualizer_->getRendererCollection()->GetFirstRenderer();
  renderer->AddActor (lines_);
  renderer->AddActor2D (status_);
  renderer->AddActor2D (help_);
  showLines ({});
  interactor().CreateRepeatingTimer (1); // without, ProcessEvents() waits for an event
}

ViewerWindow::~ViewerWindow() = default;

void
ViewerWindow::showCloud (const pcl::PointCloud<pcl::PointXYZRGB>& cloud, int point_size)
{
  const auto shown = cloud.makeShared();
  if (!visualizer_->updatePointCloud (shown, cloud_id))
    visualizer_->addPointCloud (shown, cloud_id);
  if (std::exchange (point_size_, point_size) != point_size)
    visualizer_->setPointCloudRenderingProperties (
        pcl::visualization::PCL_VISUALIZER_POINT_SIZE, point_size, cloud_id);
}

void
ViewerWindow::showLines (const std::vector<ColouredLine>& lines)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents (3);
  for (const auto& line : lines) {
    cells->InsertNextCell (static_cast<int> (line.points.size()));
    for (const auto& p : line.points) {
      cells->InsertCellPoint (points->InsertNextPoint (p.x(), p.y(), p.z()));
      colours->InsertNextTuple3 (line.colour.r, line.colour.g, line.colour.b);
    }
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints (points);
  data->SetLines (cells);
  data->GetPointData()->SetScalars (colours);
  vtkPolyDataMapper::SafeDownCast (lines_->GetMapper())->SetInputData (data);
}

void
ViewerWindow::showStatus (const std::string& text)
{
  status_->SetInput (text.c_str());
}

void
ViewerWindow::showHelp (const std::string& text)
{
  help_->SetInput (text.c_str());
}

bool
ViewerWindow::lookFromCamera (const pcl::PointCloud<pcl::PointXYZRGB>& cloud)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double points = 0.;
  for (const auto& point : cloud)
    if (std::isfinite (point.z)) {
      sum += point.getVector3fMap().cast<double>();
      points += 1.;
    }
  if (points == 0.)
    return false;
  const Eigen::Vector3d centre = sum / points;
  const Eigen::Vector3d up (0., -1., 0.);
  const Eigen::Vector3d eye = 0.15 * centre.norm() * up - 0.2 * centre;
  visualizer_->setCameraPosition (eye.x(),
                                  eye.y(),
                                  eye.z(),
                                  centre.x(),
                                  centre.y(),
                                  centre.z(),
                                  up.x(),
                                  up.y(),
                                  up.z());
  const double focal = fitCamera (cloud).fy;
  const double angle = 2. * std::atan2 (0.5 * cloud.height, focal);
  visualizer_->setCameraFieldOfView (std::clamp (1.1 * angle, 0.3, 1.2));
  return true;
}

void
ViewerWindow::render()
{
  visualizer_->getRenderWindow()->Render();
}

void
ViewerWindow::processEvents()
{
  interactor().ProcessEvents();
}

Picture
ViewerWindow::picture()
{
  render();
  vtkRenderWindow& window = *visualizer_->getRenderWindow();
  const int width = window.GetSize()[0], height = window.GetSize()[1];
  vtkNew<vtkUnsignedCharArray> rgb;
  window.GetPixelData (0, 0, width - 1, height - 1, 1, rgb);
  Picture picture (static_cast<std::uint32_t> (width),
                   static_cast<std::uint32_t> (height));
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u) {
      const unsigned char* pixel =
          rgb->GetPointer (3 * ((height - 1 - v) * width + u)); // from the bottom
      picture (u, v) = {pixel[0], pixel[1], pixel[2]};
    }
  return picture;
}

vtkRenderWindowInteractor&
ViewerWindow::interactor()
{
  return *visualizer_->getRenderWindow()->GetInteractor();
}

} // namespace rgbd_planes
} // namespace pcl
