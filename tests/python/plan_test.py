# SPDX-License-Identifier: BSD-3-Clause
import gc
import threading
import unittest

import numpy as np

import alignability
from site_cases import WAREHOUSE, SiteTest, program_json

FIGURES = ("length", "risk_integral", "blind_length", "longest_blind", "alpha_mean", "alpha_min")


class WarehouseTest(unittest.TestCase):
    def setUp(self):
        self.problem = alignability.Problem.load(WAREHOUSE / "problem.yaml")
        self.problem.planner.iterations = 500

    def assert_told_alike(self, result, told):
        self.assertEqual((result.status, result.planner, result.seed), (told["status"], told["planner"], told["seed"]))
        self.assertEqual((result.cost, result.weight, result.lower_bound), (told["cost"], told["weight"], told["lower_bound"]))
        for figure in FIGURES:
            self.assertEqual(getattr(result.figures, figure), told[figure], figure)
        self.assertEqual(result.poses.tolist(), told["path"])

    def test_plans_as_the_program_to_the_digit(self):
        told = program_json("plan", WAREHOUSE / "problem.yaml", "--iterations", 500)
        self.assert_told_alike(alignability.plan(self.problem), told)

    def test_plans_by_another_planner_weight_and_goal_as_the_program(self):
        told = program_json(
            "plan", WAREHOUSE / "problem.yaml", "--iterations", 1500, "--planner", "rrtstar", "--weight", 2, "--seed", 7, "--goal", "20,36,0.5"
        )
        self.problem.planner = alignability.PlannerChoice(name="rrtstar", iterations=1500, seed=7)
        self.problem.weight = 2
        self.problem.goal = np.array([20, 36, 0.5])
        self.assertEqual(self.problem.goal, (20.0, 36.0, 0.5))
        self.assert_told_alike(alignability.plan(self.problem), told)

    def test_compares_as_the_program_to_the_digit(self):
        told = program_json("compare", WAREHOUSE / "problem.yaml", "--iterations", 500)
        comparison = alignability.compare(self.problem)
        self.assertTrue(comparison.solved)
        self.assert_told_alike(comparison.shortest, told["shortest"])
        self.assert_told_alike(comparison.risk_aware, told["risk_aware"])
        self.assertEqual(comparison.length_ratio, told["ratio"]["length"])

    def test_reads_a_problem_with_several_risks(self):
        problem = alignability.Problem.load(WAREHOUSE / "several_risks.yaml")
        problem.planner.iterations = 300
        told = program_json("plan", WAREHOUSE / "several_risks.yaml", "--iterations", 300)
        result = alignability.plan(problem)
        self.assertEqual(result.risk_by_source, told["risk_by_source"])
        self.assertEqual(result.cost, told["cost"])

    def test_poses_outlive_the_result(self):
        poses = alignability.plan(self.problem).poses
        before = poses.copy()
        gc.collect()
        alignability.plan(self.problem)
        np.testing.assert_array_equal(poses, before)
        self.assertEqual(poses.shape[1], 3)
        with self.assertRaises(ValueError):
            poses[0, 0] = 1.0

    def test_threads_plan_one_after_the_other(self):
        self.problem.planner = alignability.PlannerChoice(name="rrtstar", iterations=1000, seed=3)
        alone = alignability.plan(self.problem).poses
        found = [None, None]

        def plan(i):
            found[i] = alignability.plan(self.problem).poses

        threads = [threading.Thread(target=plan, args=(i,)) for i in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for poses in found:
            np.testing.assert_array_equal(poses, alone)

    def test_says_no_without_an_exception(self):
        self.problem.start = (0.2, 20, 0)
        result = alignability.plan(self.problem)
        self.assertEqual((result.status, result.solved), ("start_in_collision", False))
        self.assertEqual((result.cost, result.figures, result.risk_by_source), (None, None, None))
        self.assertEqual(result.poses.shape, (0, 3))
        self.assertIsNone(alignability.compare(self.problem).length_ratio)

    def test_keeps_limits(self):
        self.problem.weight = 0
        self.problem.max_blind_distance = 10
        self.problem.planner = alignability.PlannerChoice(time=1.0)
        result = alignability.plan(self.problem)
        self.assertTrue(result.solved)
        self.assertLessEqual(result.longest_unrecovered, 10 + 1e-9)


class ProblemTest(SiteTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.make_map()

    def test_of_arrays_plans_as_that_of_the_files(self):
        read = alignability.Problem.load(self.folder / "problem.yaml")
        # What a cell of a map is, an array tells but for the layers that planning does not ask for.
        occupancy = alignability.OccupancyMap.from_array(read.occupancy.occupancy, read.occupancy.resolution, read.occupancy.origin)
        alpha = alignability.AlignabilityMap.from_array(read.alignability.alpha, read.alignability.resolution, read.alignability.origin)
        made = alignability.Problem(
            occupancy,
            alpha,
            robot=alignability.Robot(radius=0.3),
            start=(1.5, 3, 0),
            goal=[6.5, 3, 0],
            planner=alignability.PlannerChoice(iterations=2000),
        )
        np.testing.assert_array_equal(alignability.plan(made).poses, alignability.plan(read).poses)

    def test_has_the_librarys_defaults_and_can_be_set(self):
        problem = alignability.Problem.load(self.folder / "problem.yaml")
        self.assertEqual((problem.weight, problem.recovery_distance, problem.max_error), (5.0, 1.0, None))
        self.assertEqual((problem.risk.alpha_critical, problem.risk.alpha_safe, problem.risk.unknown), (0.1, 0.4, "risky"))
        self.assertEqual((problem.motion.space, problem.motion.turn_cost), ("se2", 0.2))
        self.assertEqual((problem.robot.radius, problem.planner.iterations), (0.3, 2000))
        self.assertEqual(repr(alignability.PlannerChoice()), "PlannerChoice(name='', time=2.0, iterations=None, seed=1)")
        other = problem.copy()
        other.motion.space = "r2"
        other.risk.min_alpha = 0.01
        other.start = (1, 1, 0)
        self.assertEqual((problem.motion.space, problem.risk.min_alpha, problem.start), ("se2", None, (1.5, 3.0, 0.0)))
        other.robot = alignability.Robot(footprint=[(-0.3, -0.2), (0.3, -0.2), (0.3, 0.2), (-0.3, 0.2)])
        corners = other.robot.footprint
        other.robot.footprint = []
        self.assertEqual([corner.tolist() for corner in corners], [[-0.3, -0.2], [0.3, -0.2], [0.3, 0.2], [-0.3, 0.2]])

    def test_refuses_what_does_not_fit(self):
        problem = alignability.Problem.load(self.folder / "problem.yaml")
        with self.assertRaisesRegex(ValueError, "space must be 'r2', 'se2', 'dubins' or 'reeds_shepp', not 'se3'"):
            problem.motion.space = "se3"
        with self.assertRaisesRegex(TypeError, "goal cannot be"):
            problem.goal = (1, 2)
        with self.assertRaisesRegex(TypeError, "weight cannot be 'much', of type str"):
            problem.weight = "much"
        with self.assertRaises(AttributeError):
            alignability.plan(problem).status = "solved"

    def test_refuses_values_where_a_file_would(self):
        problem = alignability.Problem.load(self.folder / "problem.yaml")
        nan = float("nan")
        for owner, name, value, fault in [
            (problem, "weight", -1, "weight must be at least 0"),
            (problem, "weight", nan, "weight must be at least 0"),
            (problem, "goal", (5, 3, float("inf")), "goal must be finite"),
            (problem, "recovery_distance", 0, "recovery_distance must be greater than 0"),
            (problem.planner, "seed", 0, "seed must be from 1 to 4294967295"),
            (problem.planner, "iterations", 0, "iterations must be from 1 to 4294967295"),
            (problem.planner, "time", nan, "time must be greater than 0"),
            (problem.risk, "alpha_safe", 1.5, "alpha_safe must be from 0 to 1"),
            (problem.robot, "radius", 0, "radius must be greater than 0"),
            (problem.goal_tolerance, "position", -1, "position must be greater than 0"),
        ]:
            before = getattr(owner, name)
            with self.assertRaisesRegex(ValueError, fault):
                setattr(owner, name, value)
            self.assertEqual(getattr(owner, name), before)

    def test_knows_its_keywords(self):
        problem = alignability.Problem.load(self.folder / "problem.yaml")
        with self.assertRaisesRegex(TypeError, r"PlannerChoice\(\) got an unexpected keyword argument 'iteration'"):
            alignability.PlannerChoice(iteration=5)
        problem.motion = alignability.Motion(space="r2")
        problem.robot.footprint = [(-1, -1), (1, -1), (0, 1)]
        with self.assertRaisesRegex(ValueError, "a footprint has a heading, and the space r2 has none"):
            alignability.plan(problem)
