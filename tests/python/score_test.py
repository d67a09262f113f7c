# SPDX-License-Identifier: BSD-3-Clause
import inspect
import math
import unittest

import numpy as np

import alignability
from site_cases import SiteTest, box, counted_beside, program_json, world


def patch(center, u, v, side=20):
    """Points 5 cm apart on a square around a centre, spanned by two unit vectors."""
    steps = 0.05 * (np.arange(side) - 0.5 * (side - 1))
    i, j = np.meshgrid(steps, steps, indexing="ij")
    return np.asarray(center) + i.reshape(-1, 1) * np.asarray(u) + j.reshape(-1, 1) * np.asarray(v)


X, Y, Z = np.eye(3)


def three_walls():
    return np.concatenate([patch(4 * X, Y, Z), patch(4 * Y, Z, X), patch(-3 * Z, X, Y)])


class AlphaTest(unittest.TestCase):
    def test_of_three_orthogonal_walls_of_equal_counts_is_one(self):
        result = alignability.score(three_walls())
        self.assertAlmostEqual(result.alpha, 1.0, delta=1e-4)
        self.assertEqual((result.planes_kept, result.points, result.dimensions), (3, 1200, 3))
        self.assertAlmostEqual(result.eigenvalues.sum(), 1.0, delta=1e-5)

    def test_of_one_plane_is_zero(self):
        result = alignability.score(patch(4 * X, Y, Z))
        self.assertAlmostEqual(result.alpha, 0.0, delta=1e-6)
        self.assertEqual(result.planes_kept, 1)

    def test_is_the_ratio_of_counts_where_normals_are_orthogonal(self):
        points = np.concatenate([patch(4 * X, Y, Z, 30), patch(4 * Y, Z, X, 20), patch(-3 * Z, X, Y, 10)])
        result = alignability.score(points)
        self.assertAlmostEqual(result.alpha, 100 / 900, delta=1e-4)
        self.assertAlmostEqual(abs(result.weakest_direction[2]), 1.0, delta=1e-4)

    def test_of_three_walls_about_the_mean_is_zero(self):
        self.assertAlmostEqual(alignability.score(three_walls(), moment="about_mean").alpha, 0.0, delta=1e-4)

    def test_of_two_parallel_lines_of_a_2d_lidar_is_zero_and_of_a_corner_is_one(self):
        along = np.linspace(-1, 1, 200)
        wall = np.stack([along, np.full(200, 2.0)], axis=1)
        parallel = alignability.score(np.concatenate([wall, wall * [1, -1]]))
        self.assertEqual(parallel.dimensions, 2)
        self.assertAlmostEqual(parallel.alpha, 0.0, delta=1e-6)
        self.assertTrue(math.isnan(parallel.eigenvalues[2]))
        corner = alignability.score(np.concatenate([wall, wall[:, ::-1]]))
        self.assertAlmostEqual(corner.alpha, 1.0, delta=1e-2)

    def test_comes_with_the_plane_and_normal_of_each_point(self):
        result = alignability.score(three_walls())
        self.assertEqual(result.plane_of_point.shape, (1200,))
        self.assertEqual(sorted(np.unique(result.plane_of_point)), [0, 1, 2])
        self.assertEqual(result.normals.shape, (1200, 3))
        np.testing.assert_allclose(np.abs(result.normals[:400, 0]), 1.0, atol=1e-5)

    def test_arrays_outlive_what_they_came_with(self):
        planes = alignability.score(three_walls()).plane_of_point
        before = planes.copy()
        for _ in range(3):
            alignability.score(three_walls())
        np.testing.assert_array_equal(planes, before)
        with self.assertRaises(ValueError):
            planes[0] = 7

    def test_takes_arrays_of_any_layout_for_what_they_hold(self):
        points = three_walls()
        alpha = alignability.score(points).alpha
        self.assertEqual(alignability.score(points.astype(np.float32)).alpha, alpha)
        self.assertEqual(alignability.score(np.asfortranarray(points)).alpha, alpha)
        self.assertEqual(alignability.score(np.repeat(points, 2, axis=0)[::2]).alpha, alpha)
        self.assertEqual(alignability.score(points.tolist()).alpha, alpha)

    def test_tells_the_readings_that_are_asked_for(self):
        readings = alignability.score(three_walls(), readings=["robust", "centred"]).readings
        self.assertEqual(list(readings), ["robust", "centred"])
        self.assertAlmostEqual(readings["robust"], 1.0, delta=1e-4)
        self.assertEqual(alignability.score(three_walls()).readings, {})


class RefusalTest(unittest.TestCase):
    def test_of_shapes_that_are_no_points(self):
        for shape in [(5,), (5, 4), (2, 3, 2), (2, 2, 2, 3), ()]:
            with self.assertRaisesRegex(ValueError, r"points must have the shape \(N, 3\), \(N, 2\) or \(H, W, 3\), not"):
                alignability.score(np.zeros(shape))

    def test_of_integers_which_may_be_millimetres(self):
        with self.assertRaisesRegex(TypeError, "points must be floats, not int64"):
            alignability.score(np.zeros((5, 3), dtype=np.int64))
        for given in ["points", None, [[1.0, 2.0], [3.0]]]:
            with self.assertRaises(TypeError):
                alignability.score(given)

    def test_of_keywords_that_are_none(self):
        with self.assertRaisesRegex(TypeError, r"score\(\) got an unexpected keyword argument 'strid'"):
            alignability.score(three_walls(), strid=2)
        with self.assertRaisesRegex(TypeError, "stride cannot be 'two', of type str"):
            alignability.score(three_walls(), stride="two")
        with self.assertRaisesRegex(ValueError, "engine must be 'native' or 'pcl', not 'plc'"):
            alignability.score(three_walls(), engine="plc")
        with self.assertRaisesRegex(ValueError, "the stride must be 1 to 4"):
            alignability.score(three_walls(), stride=9)
        with self.assertRaisesRegex(ValueError, "dimensions cannot be 'three' for points of two coordinates"):
            alignability.score(np.zeros((5, 2)), dimensions="three")

    def test_leaves_defaults_to_see(self):
        parameters = inspect.signature(alignability.score).parameters
        self.assertEqual(parameters["normal_neighbours"].default, 30)
        self.assertEqual(parameters["engine"].default, "native")
        self.assertEqual(parameters["readings"].default, [])


class SimulatedTest(SiteTest):
    def test_plain_corridor_without_noise_is_zero_and_weak_along_it(self):
        corridor = world(box("floor", "0 0 -0.05", "80 3 0.1"), box("left", "0 1.6 1.5", "80 0.2 3"), box("right", "0 -1.6 1.5", "80 0.2 3"))
        (self.folder / "corridor.sdf").write_text(corridor)
        scan = alignability.simulate_scan(self.folder / "corridor.sdf", self.folder / "sensor.yaml", (0, 0, 0), range_max=6.5)
        result = alignability.score(scan, sensor=self.folder / "sensor.yaml")
        self.assertLess(result.alpha, 1e-4)
        self.assertAlmostEqual(abs(result.weakest_direction[0]), 1.0, delta=1e-3)

    def test_scan_and_score_are_the_programs(self):
        self.run_program("scan", "--scene", "world.sdf", "--sensor", "sensor.yaml", "--at", "1.5,1.5,0.3", "--seed", "4", "-o", "scan.pcd")
        told = program_json("score", "scan.pcd", "--sensor", "sensor.yaml", "--readings", "robust,information", folder=self.folder)
        scan = alignability.read_scan(self.folder / "scan.pcd")
        self.assertEqual(scan.shape, (15, 360, 3))
        scene = alignability.Scene.load(self.folder / "world.sdf")
        simulated = alignability.simulate_scan(scene, self.folder / "sensor.yaml", (1.5, 1.5, 0.3), seed=4)
        np.testing.assert_array_equal(simulated, scan)
        result = alignability.score(scan, sensor=self.folder / "sensor.yaml", readings=["robust", "information"])
        self.assertEqual(result.alpha, told["alpha"])
        self.assertEqual(list(result.eigenvalues), told["eigenvalues"])
        self.assertEqual((result.planes_found, result.planes_kept, result.points), (told["planes_found"], told["planes_kept"], told["points"]))
        self.assertEqual(result.readings["robust"], told["robust"])
        self.assertEqual(result.plane_of_point.shape, (15, 360))

    def test_lets_other_threads_run_meanwhile(self):
        scan = alignability.simulate_scan(self.folder / "world.sdf", self.folder / "sensor.yaml", (1.5, 1.5, 0.3))
        self.assertGreater(counted_beside(lambda: [alignability.score(scan) for _ in range(10)]), 0)
