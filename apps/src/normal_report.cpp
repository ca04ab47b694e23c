// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/normal_report.h>
#include <pcl/apps/statistics.h>

#include <nlohmann/json.hpp>

#include <iomanip>
#include <sstream>

namespace pcl {
namespace rgbd_planes {

namespace {

void
addFigures (const NormalDeviations& deviations, nlohmann::ordered_json& json)
{
  json["mean_deg"] = deviations.mean();
  json["median_deg"] = deviations.median();
  json["over_25_percent"] = deviations.over25Percent();
  json["coverage_percent"] = deviations.coveragePercent();
}

} // namespace

std::string
normalTable (const std::vector<NormalResult>& results)
{
  std::ostringstream table;
  const auto number = [&] (double value, int width, int digits) {
    table << std::setw (width) << numberText (value, digits);
  };
  // clang-format off
  table << "method                      size   reference  "
           "     ms    mean  median  >25 deg  covered | interior  >25 deg |    edges  >25 deg\n"
           "                                              "
           "            deg     deg        %        % | mean deg        % | mean deg        %\n";
  // clang-format on
  for (const auto& result : results) {
    table << std::left << std::setw (28) << result.method << std::setw (7)
          << result.resolution << std::setw (11) << result.reference << std::right;
    number (median (result.milliseconds), 7, 2);
    number (result.all.mean(), 8, 2);
    number (result.all.median(), 8, 2);
    number (result.all.over25Percent(), 9, 2);
    number (result.all.coveragePercent(), 9, 1);
    for (const auto* part : {&result.interior, &result.edges}) {
      table << " |";
      number (part->mean(), 9, 2);
      number (part->over25Percent(), 9, 2);
    }
    table << '\n';
  }
  return table.str();
}

std::string
normalTableJson (const std::vector<NormalResult>& results)
{
  auto rows = nlohmann::ordered_json::array();
  for (const auto& result : results) {
    nlohmann::ordered_json row;
    row["method"] = result.method;
    row["resolution"] = result.resolution;
    row["ms_median"] = median (result.milliseconds);
    addFigures (result.all, row);
    row["reference"] = result.reference;
    addFigures (result.tangent_there, row["tangent_there"]);
    for (const auto& [key, part] :
         {std::pair{"interior", &result.interior},
          std::pair{"edges", &result.edges},
          std::pair{"tangent_there_edges", &result.tangent_there_edges}}) {
      row[key] = nullptr;
      if (result.reference == "truth")
        addFigures (*part, row[key]);
    }
    rows.push_back (std::move (row));
  }
  return nlohmann::ordered_json{{"results", rows}}.dump (2) + '\n';
}

} // namespace rgbd_planes
} // namespace pcl
