// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report/report.hpp"

namespace alignability::test {

struct SampleReport {
  PlanProblem problem;
  Report report;

  RiskField risk() const { return RiskField(problem.alignability, problem.occupancy, problem.query.risk); }
};

/// Two ways around a block, the straight one blind, with made-up errors of two localizers; a map without values in one corner.
SampleReport sample_report();

/// The same on a map that is poor when the robot looks along x, by eight headings.
SampleReport sample_report_by_heading();

}  // namespace alignability::test
