// SPDX-License-Identifier: BSD-3-Clause
#include "planner/planners.hpp"

#include <ompl/geometric/planners/fmt/FMT.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/prm/PRMstar.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>

#include <algorithm>
#include <stdexcept>

#include "core/input_error.hpp"

namespace alignability {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

// FMT* draws its samples before it starts and takes no other bound.
constexpr unsigned int kFmtSamples = 5000;

ob::PlannerPtr make_rrtstar(const PlannerChoice&, const ob::SpaceInformationPtr& si) {
  auto planner = std::make_shared<og::RRTstar>(si);
  planner->setTreePruning(false);
  planner->setInformedSampling(false);
  planner->setNewStateRejection(false);
  return planner;
}

ob::PlannerPtr make_prmstar(const PlannerChoice&, const ob::SpaceInformationPtr& si) { return std::make_shared<og::PRMstar>(si); }

ob::PlannerPtr make_fmtstar(const PlannerChoice& choice, const ob::SpaceInformationPtr& si) {
  auto planner = std::make_shared<og::FMT>(si);
  planner->setNumSamples(choice.iterations ? static_cast<unsigned int>(*choice.iterations) : kFmtSamples);
  return planner;
}

ob::PlannerPtr make_bitstar(const PlannerChoice&, const ob::SpaceInformationPtr& si) {
  return std::make_shared<og::BITstar>(si, "kBITstar");
}

struct Offer {
  const char* name;
  ob::PlannerPtr (*make)(const PlannerChoice&, const ob::SpaceInformationPtr&);
};

constexpr Offer kOffers[] = {{"rrtstar", make_rrtstar}, {"prmstar", make_prmstar}, {"fmtstar", make_fmtstar}, {"bitstar", make_bitstar}};

}  // namespace

std::vector<std::string> planner_names() {
  std::vector<std::string> names;
  for (const Offer& offer : kOffers) names.emplace_back(offer.name);
  return names;
}

std::optional<std::string> refusal_of_planner(const std::string& name) {
  const std::vector<std::string> names = planner_names();
  if (std::ranges::find(names, name) != names.end()) return std::nullopt;
  std::string list;
  for (const std::string& known : names) list += (list.empty() ? "" : ", ") + known;
  return "unknown planner '" + name + "': there are " + list + did_you_mean(name, names);
}

ob::PlannerPtr make_planner(const PlannerChoice& choice, const ob::SpaceInformationPtr& si) {
  const std::string name = choice.name.empty() ? kDefaultPlanner : choice.name;
  if (const auto refusal = refusal_of_planner(name)) throw std::invalid_argument(*refusal);
  return std::ranges::find(kOffers, name, [](const Offer& offer) { return std::string(offer.name); })->make(choice, si);
}

bool counts_its_own_iterations(const std::string& name) { return name == "fmtstar"; }

}  // namespace alignability
