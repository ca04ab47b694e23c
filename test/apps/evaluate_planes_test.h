// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "app_test.h"

#include <nlohmann/json.hpp>

/** A test that runs pcl_evaluate_planes. */
class EvaluatePlanesTest : public AppTest {
protected:
  EvaluatePlanesTest() : AppTest (EVALUATE_PLANES) {}

  nlohmann::json
  results () const
  {
    return nlohmann::json::parse (readFile (folder_ / "table.json"))["results"];
  }
};
