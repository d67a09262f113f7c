// SPDX-License-Identifier: BSD-3-Clause
#include "cli/stations_output.hpp"

#include <algorithm>
#include <cstdio>

#include "core/file.hpp"
#include "core/range.hpp"

namespace alignability::cli {
namespace {

bool is_solved(const PlanResult& plan) { return plan.status == PlanStatus::solved; }

template <typename Value>
Json matrix(const StationPlans& plans, Value value) {
  Json rows = Json::array();
  for (const auto& row : plans) {
    Json values = Json::array();
    for (const PlanResult& plan : row) values.push_back(value(plan));
    rows.push_back(values);
  }
  return rows;
}

template <typename Value>
Json figures(const StationPlans& plans, Value value) {
  return matrix(plans, [&](const PlanResult& plan) { return is_solved(plan) ? Json(value(plan)) : Json(nullptr); });
}

// Quoted where it must be.
std::string csv_text(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + '"';
}

}  // namespace

Json stations_json(std::span<const Station> stations, const StationPlans& plans, double seconds) {
  Json names = Json::array();
  for (const Station& station : stations) names.push_back(station.name);
  return {{"stations", names},
          {"status", matrix(plans, [](const PlanResult& plan) { return Json(to_string(plan.status)); })},
          {"cost", figures(plans, [](const PlanResult& plan) { return plan.cost; })},
          {"length", figures(plans, [](const PlanResult& plan) { return plan.figures.length; })},
          {"blind_length", figures(plans, [](const PlanResult& plan) { return plan.figures.blind_length; })},
          {"risk_integral", figures(plans, [](const PlanResult& plan) { return plan.figures.risk_integral; })},
          {"paths", matrix(plans, [](const PlanResult& plan) { return path_json(plan.path); })},
          {"seconds", seconds}};
}

void write_stations_csv(std::span<const Station> stations, const StationPlans& plans, const std::filesystem::path& csv) {
  std::string text = "from,to,status,cost,length,blind,longest_blind,risk_integral\n";
  for (std::size_t from = 0; from < plans.size(); ++from) {
    for (std::size_t to = 0; to < plans.size(); ++to) {
      const PlanResult& plan = plans[from][to];
      text += csv_text(stations[from].name) + ',' + csv_text(stations[to].name) + ',' + to_string(plan.status);
      const PathFigures& f = plan.figures;
      for (const double value : {plan.cost, f.length, f.blind_length, f.longest_blind, f.risk_integral}) {
        text += is_solved(plan) ? ',' + to_text(value) : ",";
      }
      text += '\n';
    }
  }
  write_file(csv, text);
}

void print_stations(std::span<const Station> stations, const StationPlans& plans, double seconds) {
  std::size_t widest = 8;
  for (const Station& station : stations) widest = std::max(widest, station.name.size());
  const int width = static_cast<int>(widest) + 2;
  std::printf("cost [equivalent m] from (row) to (column), %.2f s\n%*s", seconds, width, "");
  for (const Station& station : stations) std::printf("%*s", width, station.name.c_str());
  std::printf("\n");
  for (std::size_t from = 0; from < plans.size(); ++from) {
    std::printf("%*s", width, stations[from].name.c_str());
    for (const PlanResult& plan : plans[from]) {
      if (is_solved(plan)) {
        std::printf("%*.2f", width, plan.cost);
      } else {
        std::printf("%*s", width, "-");
      }
    }
    std::printf("\n");
  }
}

}  // namespace alignability::cli
