// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <string>

struct _XDisplay;

/** Looks for windows on the display and types into them, as a person would. */
class XClient {
public:
  XClient();
  ~XClient();

  /** Waits for a window that is shown and has a title; false after a minute without. */
  bool
  findWindow (const std::string& title);

  /** Presses and releases a key in that window; \a name as X has it. */
  void
  type (const char* name);

private:
  _XDisplay* display_;
  unsigned long window_ = 0;
};
