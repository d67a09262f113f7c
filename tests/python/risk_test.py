# SPDX-License-Identifier: BSD-3-Clause
import unittest

import numpy as np

import alignability
from site_cases import WAREHOUSE, counted_beside


def open_ground(alpha):
    """A problem of 1 m cells with such alpha, and nothing in the way."""
    height, width = np.shape(alpha)
    return alignability.Problem(
        alignability.OccupancyMap.from_array(np.zeros((10 * height, 10 * width)), 0.1),
        alignability.AlignabilityMap.from_array(np.asarray(alpha, dtype=float), 1.0),
        robot=alignability.Robot(radius=0.3),
        start=(1, 1, 0),
        goal=(2, 2, 0),
    )


class RiskFieldTest(unittest.TestCase):
    def test_is_linear_between_the_centres_of_cells(self):
        field = alignability.RiskField(open_ground([[0.1, 0.4], [0.1, 0.4]]))
        np.testing.assert_allclose(field.alpha([[0.5, 0.5], [1.0, 1.0], [1.25, 0.7]]), [0.1, 0.25, 0.325], atol=1e-7)
        np.testing.assert_allclose(field.risk([[0.5, 0.5], [1.0, 1.0], [1.25, 0.7]]), [1.0, 0.5, 0.25], atol=1e-6)
        self.assertEqual(field.risk(np.zeros((0, 2))).shape, (0,))
        self.assertFalse(field.has_headings)

    def test_adds_up_along_the_way(self):
        field = alignability.RiskField(open_ground([[0.1, 0.4]]))
        np.testing.assert_allclose(field.integral([[0.5, 0.5]], [[1.5, 0.5]]), [0.5], atol=1e-7)

    def test_measures_a_path_as_the_plan_did(self):
        problem = alignability.Problem.load(WAREHOUSE / "problem.yaml")
        problem.planner.iterations = 300
        result = alignability.plan(problem)
        figures = alignability.RiskField(problem).measure(result.poses)
        self.assertEqual(figures.length, result.figures.length)
        self.assertEqual(figures.risk_integral, result.figures.risk_integral)

    def test_says_where_the_robot_fits(self):
        area = alignability.DrivableArea(alignability.Problem.load(WAREHOUSE / "problem.yaml"))
        np.testing.assert_array_equal(area.contains([(5, 20, 0), (0.2, 20, 0), (-50, 0, 0)]), [True, False, False])
        np.testing.assert_array_equal(area.connects([(5, 20, 0)] * 2, [(5.5, 20, 0), (-1, 20, 0)]), [True, False])
        self.assertGreater(area.clearance([(5, 20)])[0], 0)

    def test_refuses_what_are_no_poses(self):
        field = alignability.RiskField(open_ground([[0.1, 0.4]]))
        with self.assertRaisesRegex(ValueError, r"poses must have the shape \(N, 3\) or \(N, 2\), not \(2,\)"):
            field.risk([1.0, 2.0])
        with self.assertRaisesRegex(TypeError, "poses must be numbers, not <U1"):
            field.risk([["a", "b"]])
        with self.assertRaisesRegex(ValueError, "poses must be finite; row 1 is not"):
            field.risk([[0.0, 1.0], [np.nan, 1.0]])
        with self.assertRaisesRegex(ValueError, "there are 1 poses to come from and 2 to go to"):
            field.integral([[0.0, 0.0]], [[1.0, 1.0], [2.0, 2.0]])

    def test_wants_a_yaw_where_the_risk_depends_on_it(self):
        problem = alignability.Problem.load(WAREHOUSE.parent / "t_junction/problem.yaml")
        field = alignability.RiskField(problem)
        self.assertTrue(field.has_headings)
        x, y, _ = problem.start
        self.assertEqual(len(set(field.alpha([(x, y, yaw) for yaw in (0.0, 1.6, 3.1)]))), 3)
        with self.assertRaisesRegex(ValueError, "poses need a yaw, on which this risk depends"):
            field.risk([(x, y)])

    def test_lets_other_threads_run_meanwhile(self):
        field = alignability.RiskField(open_ground(np.full((50, 50), 0.3)))
        poses = np.random.default_rng(1).uniform(0, 50, (2_000_000, 3))
        self.assertGreater(counted_beside(lambda: field.integral(poses, poses[::-1])), 0)
