// SPDX-License-Identifier: BSD-3-Clause
#include "planner/planners.hpp"

#include <ompl/geometric/planners/cforest/CForest.h>
#include <ompl/geometric/planners/fmt/BFMT.h>
#include <ompl/geometric/planners/fmt/FMT.h>
#include <ompl/geometric/planners/informedtrees/ABITstar.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/prm/LazyPRM.h>
#include <ompl/geometric/planners/prm/LazyPRMstar.h>
#include <ompl/geometric/planners/prm/PRMstar.h>
#include <ompl/geometric/planners/rrt/RRTXstatic.h>
#include <ompl/geometric/planners/rrt/RRTsharp.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>

#include <algorithm>
#include <stdexcept>

#include "core/input_error.hpp"
#include "planner/field_planner.hpp"
#include "planner/refused_planners.hpp"

namespace alignability {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

// FMT* and BFMT* draw their samples before they start and take no other bound.
constexpr unsigned int kFmtSamples = 5000;

template <typename Planner>
ob::PlannerPtr make(const PlannerChoice&, const ob::SpaceInformationPtr& si) {
  return std::make_shared<Planner>(si);
}

template <typename Planner>
ob::PlannerPtr make_with_samples(const PlannerChoice& choice, const ob::SpaceInformationPtr& si) {
  auto planner = std::make_shared<Planner>(si);
  planner->setNumSamples(choice.iterations ? static_cast<unsigned int>(*choice.iterations) : kFmtSamples);
  return planner;
}

ob::PlannerPtr make_field(const PlannerChoice& choice, const ob::SpaceInformationPtr& si) {
  auto planner = std::make_shared<FieldPlanner>(si);
  if (choice.iterations) planner->set_search_iterations(*choice.iterations);
  return planner;
}

ob::PlannerPtr make_rrtstar(const PlannerChoice&, const ob::SpaceInformationPtr& si) {
  auto planner = std::make_shared<og::RRTstar>(si);
  planner->setTreePruning(false);
  planner->setInformedSampling(true);  // by the certified bounds, unlike the rest
  planner->setNewStateRejection(false);
  return planner;
}

template <typename Planner>
ob::PlannerPtr make_without_rejection(const PlannerChoice&, const ob::SpaceInformationPtr& si) {
  auto planner = std::make_shared<Planner>(si);
  planner->setInformedSampling(false);
  planner->setSampleRejection(false);
  return planner;
}

// BIT* and ABIT* warn of any other name, since they join k-nearest neighbours.
template <typename Planner>
ob::PlannerPtr make_batched(const PlannerChoice& choice, const ob::SpaceInformationPtr& si) {
  return std::make_shared<Planner>(si, choice.name == "abitstar" ? "kABITstar" : "kBITstar");
}

// OMPL 1.5.2's lazy road maps free their states when cleared, not when destroyed.
template <typename Planner>
ob::PlannerPtr make_cleared_at_end(const PlannerChoice&, const ob::SpaceInformationPtr& si) {
  return {new Planner(si), [](Planner* planner) {
            planner->clear();
            delete planner;
          }};
}

ob::PlannerPtr make_cforest(const PlannerChoice&, const ob::SpaceInformationPtr& si) {
  auto planner = std::make_shared<og::CForest>(si);
  planner->setFocusSearch(false);  // it prunes
  return planner;
}

struct Offer {
  const char* name;
  ob::PlannerPtr (*make)(const PlannerChoice&, const ob::SpaceInformationPtr&);
};

constexpr Offer kOffers[] = {
    {"field", make_field},
    {"rrtstar", make_rrtstar},
    {"rrtsharp", make_without_rejection<og::RRTsharp>},
    {"rrtxstatic", make_without_rejection<og::RRTXstatic>},
    {"cforest", make_cforest},
    {"prm", make<og::PRM>},
    {"prmstar", make<og::PRMstar>},
    {"lazyprm", make_cleared_at_end<og::LazyPRM>},
    {"lazyprmstar", make_cleared_at_end<og::LazyPRMstar>},
    {"fmtstar", make_with_samples<og::FMT>},
    {"bfmtstar", make_with_samples<og::BFMT>},
    {"bitstar", make_batched<og::BITstar>},
    {"abitstar", make_batched<og::ABITstar>},
};

}  // namespace

std::vector<std::string> planner_names() {
  std::vector<std::string> names;
  for (const Offer& offer : kOffers) names.emplace_back(offer.name);
  return names;
}

std::optional<std::string> refusal_of_planner(const std::string& name) {
  const std::vector<std::string> names = planner_names();
  if (std::ranges::find(names, name) != names.end()) return std::nullopt;
  if (const char* reason = reason_against(name)) return "OMPL's planner '" + name + "' is not offered: " + reason;
  std::string list;
  for (const std::string& known : names) list += (list.empty() ? "" : ", ") + known;
  return "unknown planner '" + name + "': there are " + list + did_you_mean(name, names);
}

std::optional<std::string> refusal_of_planner(const std::string& name, MotionSpace space) {
  if (const auto refusal = refusal_of_planner(name)) return refusal;
  if (const char* reason = reason_against(name, space)) {
    std::string text = "the planner '" + name;
    text += "' is not offered in the space ";
    return text + to_string(space) + ": " + reason;
  }
  return std::nullopt;
}

ob::PlannerPtr make_planner(const PlannerChoice& choice, const ob::SpaceInformationPtr& si) {
  const std::string name = choice.name.empty() ? kDefaultPlanner : choice.name;
  if (const auto refusal = refusal_of_planner(name)) throw std::invalid_argument(*refusal);
  return std::ranges::find(kOffers, name, [](const Offer& offer) { return std::string(offer.name); })->make(choice, si);
}

bool counts_its_own_iterations(const std::string& name) { return name == "field" || name == "fmtstar" || name == "bfmtstar"; }

bool gains_from_bounds(const std::string& name) { return name == "bitstar" || name == "abitstar" || name == "rrtstar"; }

bool reports_its_first_solution(const std::string& name) { return name != "cforest"; }

}  // namespace alignability
