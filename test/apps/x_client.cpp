// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "x_client.h"

#include <X11/Xlib.h>
#include <X11/Xutil.h>

#include <chrono>
#include <thread>

namespace {

bool
hasTitle (Display* display, Window window, const std::string& title)
{
  XWindowAttributes attributes;
  char* name = nullptr;
  const bool same = XGetWindowAttributes (display, window, &attributes) &&
                    attributes.map_state == IsViewable &&
                    XFetchName (display, window, &name) && title == name;
  if (name)
    XFree (name);
  return same;
}

/** The window, one below it, or 0. */
Window
findBelow (Display* display, Window window, const std::string& title)
{
  if (hasTitle (display, window, title))
    return window;
  Window root, parent, *children = nullptr, found = 0;
  unsigned count = 0;
  if (XQueryTree (display, window, &root, &parent, &children, &count))
    for (unsigned k = 0; k < count && !found; ++k)
      found = findBelow (display, children[k], title);
  if (children)
    XFree (children);
  return found;
}

} // namespace

XClient::XClient() : display_ (XOpenDisplay (nullptr))
{
  // Windows may go while they are looked at.
  XSetErrorHandler ([] (Display*, XErrorEvent*) { return 0; });
}

XClient::~XClient()
{
  if (display_)
    XCloseDisplay (display_);
}

bool
XClient::findWindow (const std::string& title)
{
  window_ = 0;
  for (int i = 0; display_ && !window_ && i < 600; ++i) {
    window_ = findBelow (display_, DefaultRootWindow (display_), title);
    std::this_thread::sleep_for (std::chrono::milliseconds (100));
  }
  return window_ != 0;
}

void
XClient::type (const char* name)
{
  XKeyEvent event{};
  event.display = display_;
  event.window = window_;
  event.root = DefaultRootWindow (display_);
  event.same_screen = True;
  event.keycode = XKeysymToKeycode (display_, XStringToKeysym (name));
  for (const int type : {KeyPress, KeyRelease}) {
    event.type = type;
    XSendEvent (display_,
                window_,
                True,
                type == KeyPress ? KeyPressMask : KeyReleaseMask,
                reinterpret_cast<XEvent*> (&event));
  }
  XFlush (display_);
}
