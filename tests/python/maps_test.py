# SPDX-License-Identifier: BSD-3-Clause
import gc
import pathlib
import tempfile
import unittest

import numpy as np

import alignability
from site_cases import WAREHOUSE


class FolderTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)


class AlignabilityMapTest(FolderTest):
    def test_goes_from_an_array_to_files_and_back(self):
        alpha = np.array([[0.25, 0.5, np.nan], [1.0, 0.0, 0.125]])
        alignability.AlignabilityMap.from_array(alpha, 2.0, (-3, 4.5)).save(self.folder / "map.yaml")
        self.assertEqual(sorted(file.name for file in self.folder.iterdir()), ["map.tiff", "map.yaml"])
        read = alignability.AlignabilityMap.load(self.folder / "map.yaml")
        np.testing.assert_array_equal(read.alpha, alpha)
        self.assertEqual(read.alpha.dtype, np.float32)
        self.assertEqual((read.resolution, read.origin, read.shape, read.layers), (2.0, (-3.0, 4.5), (2, 3), ["alpha"]))

    def test_has_its_bottom_row_first(self):
        warehouse = alignability.AlignabilityMap.load(WAREHOUSE / "alignability.yaml")
        occupancy = alignability.OccupancyMap.load(WAREHOUSE / "occupancy.yaml")
        self.assertEqual(warehouse.shape, (45, 60))
        # The plain corridor, in the middle of its length, and the lobby that the problem starts in.
        self.assertLess(warehouse.alpha[22, 30], 0.1)
        self.assertGreater(warehouse.alpha[20, 5], 0.1)
        self.assertEqual(occupancy.occupancy[200, 50], 0.0)

    def test_shows_its_layers_without_a_copy_as_long_as_anyone_looks(self):
        warehouse = alignability.AlignabilityMap.load(WAREHOUSE / "alignability.yaml")
        alpha = warehouse.alpha
        self.assertTrue(np.shares_memory(alpha, warehouse.layer("alpha")))
        before = alpha.copy()
        del warehouse
        gc.collect()
        np.testing.assert_array_equal(alpha, before)
        with self.assertRaisesRegex(ValueError, "read-only"):
            alpha[0, 0] = 0.5

    def test_copies_what_it_is_made_of(self):
        alpha = np.full((2, 2), 0.5, dtype=np.float32)
        made = alignability.AlignabilityMap.from_array(alpha, 1.0)
        alpha[:] = 0.0
        self.assertEqual(made.alpha.min(), 0.5)

    def test_keeps_what_it_was_made_with(self):
        warehouse = alignability.AlignabilityMap.load(WAREHOUSE / "alignability.yaml")
        self.assertIn("Velodyne", warehouse.sensor)
        self.assertIn("range_max: 6.5", warehouse.options)
        with self.assertRaisesRegex(KeyError, "there is no layer 'alhpa' .did you mean 'alpha'"):
            warehouse.layer("alhpa")

    def test_refuses_what_is_no_alignability(self):
        make = alignability.AlignabilityMap.from_array
        with self.assertRaisesRegex(ValueError, "alpha must be from 0 to 1, or NaN"):
            make(np.array([[1.5]]), 1.0)
        with self.assertRaisesRegex(ValueError, r"alpha must have the shape \(H, W\), not \(3,\)"):
            make(np.zeros(3), 1.0)
        with self.assertRaisesRegex(TypeError, "alpha must be floats, not int8"):
            make(np.zeros((2, 2), dtype=np.int8), 1.0)
        with self.assertRaisesRegex(ValueError, "resolution must be greater than 0"):
            make(np.zeros((2, 2)), 0.0)
        with self.assertRaisesRegex(ValueError, "alpha must have a cell at least"):
            make(np.zeros((0, 2)), 1.0)


class OccupancyMapTest(FolderTest):
    def test_goes_from_an_array_to_files_and_back(self):
        occupancy = np.array([[0.0, 1.0, np.nan], [0.0, 0.0, 1.0]])
        alignability.OccupancyMap.from_array(occupancy, 0.5, (1, 2)).save(self.folder / "map")
        read = alignability.OccupancyMap.load(self.folder / "map.yaml")
        np.testing.assert_array_equal(read.occupancy, occupancy)
        self.assertEqual((read.resolution, read.origin, read.shape), (0.5, (1.0, 2.0), (2, 3)))

    def test_refuses_percentages(self):
        with self.assertRaisesRegex(TypeError, "occupancy must be floats, not int8"):
            alignability.OccupancyMap.from_array(np.full((2, 2), 100, dtype=np.int8), 0.1)
        with self.assertRaises(ValueError):
            alignability.OccupancyMap.from_array(np.full((2, 2), 100.0), 0.1)
