# SPDX-License-Identifier: BSD-3-Clause
import numpy as np

import alignability
from site_cases import SiteTest


class BuildMapTest(SiteTest):
    def build(self, **options):
        return alignability.build_map(self.folder / "world.sdf", self.folder / "sensor.yaml", self.folder / "occupancy.yaml", **options)

    def test_makes_the_programs_map_to_the_byte(self):
        self.make_map()
        self.build(samples=1).save(self.folder / "by_python")
        for ending in (".tiff", ".yaml"):
            made = (self.folder / ("by_python" + ending)).read_bytes().replace(b"by_python", b"alignability")
            self.assertEqual(made, (self.folder / ("alignability" + ending)).read_bytes())

    def test_takes_what_is_loaded_for_what_is_named(self):
        named = self.build(samples=1, seed=3, range_max=4.0)
        scene = alignability.Scene.load(str(self.folder / "world.sdf"))
        occupancy = alignability.OccupancyMap.load(self.folder / "occupancy.yaml")
        loaded = alignability.build_map(scene, str(self.folder / "sensor.yaml"), occupancy, samples=1, seed=3, range_max=4.0)
        np.testing.assert_array_equal(loaded.alpha, named.alpha)
        self.assertEqual(loaded.seed, 3)
        self.assertIn("range_max: 4", loaded.options)
        self.assertNotIn("scene:", loaded.provenance)

    def test_evaluates_the_cells_asked_for_alone(self):
        made = self.build(samples=1, cells=[(1, 2), (3, 1)])
        rows, columns = np.nonzero(~np.isnan(made.alpha))
        self.assertEqual(set(zip(columns.tolist(), rows.tolist())), {(1, 2), (3, 1)})

    def test_tells_of_its_progress_to_the_end(self):
        told = []
        self.build(samples=1, progress=lambda done, total: told.append((done, total)))
        total = told[-1][1]
        self.assertEqual(told, [(done, total) for done in range(total + 1)])

    def test_goes_on_from_a_checkpoint(self):
        whole = self.build(samples=1)
        kept = self.folder / "kept.part"

        class Enough(Exception):
            pass

        def stop_early(done, total):
            if done == 5:
                raise Enough

        with self.assertRaises(Enough):
            self.build(samples=1, checkpoint=kept, threads=1, progress=stop_early)
        told = []
        resumed = self.build(samples=1, checkpoint=kept, progress=lambda done, total: told.append(done))
        self.assertGreaterEqual(told[0], 5)
        np.testing.assert_array_equal(resumed.alpha, whole.alpha)

    def test_looks_to_all_sides_where_the_sensor_does_not(self):
        text = (self.folder / "sensor.yaml").read_text().replace("{min: -180, max: 180, count: 360}", "{min: -60, max: 60, count: 120}")
        (self.folder / "forward.yaml").write_text(text)
        made = alignability.build_map(
            self.folder / "world.sdf", self.folder / "forward.yaml", self.folder / "occupancy.yaml", samples=1, cells=[(1, 1)]
        )
        self.assertEqual([name for name in made.layers if "heading" in name], [f"alpha_heading_{i}" for i in range(8)])

    def test_refuses_options_as_the_library_does(self):
        with self.assertRaisesRegex(ValueError, "samples must be at least 1"):
            self.build(samples=0)
        with self.assertRaisesRegex(TypeError, r"build_map\(\) got an unexpected keyword argument 'sample'"):
            self.build(sample=1)
        with self.assertRaisesRegex(TypeError, "progress must be a function"):
            self.build(samples=1, progress=3)
        with self.assertRaisesRegex(TypeError, "seed cannot be -1, of type int"):
            self.build(seed=-1)

    def test_warns_of_what_is_left_out_of_a_world(self):
        text = (self.folder / "world.sdf").read_text()
        hill = "<model name='hill'><static>true</static><link name='l'><collision name='c'><geometry><heightmap><uri>h.png</uri></heightmap>"
        (self.folder / "hill.sdf").write_text(text.replace("</world>", hill + "</geometry></collision></link></model></world>"))
        with self.assertWarns(UserWarning):
            alignability.Scene.load(self.folder / "hill.sdf")
