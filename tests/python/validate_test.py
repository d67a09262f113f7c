# SPDX-License-Identifier: BSD-3-Clause
import numpy as np

import alignability
from site_cases import SiteTest, program_json

PATHS = {"south": [(1.5, 1, 0), (3, 1, 0)], "east": [(6.5, 1, 1.5), (6.5, 2.5, 1.5)]}


class ValidateTest(SiteTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.make_map()
        cls.problem = alignability.Problem.load(cls.folder / "problem.yaml")

    def test_drives_as_the_program_to_the_digit(self):
        for name, poses in PATHS.items():
            rows = "".join(f"{x!r},{y!r},{yaw!r}\n" for x, y, yaw in poses)
            (self.folder / (name + ".csv")).write_text("x,y,yaw\n" + rows)
        files = [self.folder / (name + ".csv") for name in PATHS]
        localizers = ["ndt_mcl_product", "scan_matching"]
        told = program_json(
            "validate", "path", self.folder / "problem.yaml", *files, "--runs", 2, "--localizer", ",".join(localizers), "--drive-seed", 5
        )
        validations = alignability.validate(self.problem, PATHS, runs=2, seed=5, localizers=localizers)
        self.assertEqual([validation.localizer for validation in validations], localizers)
        for validation, said in zip(validations, told):
            self.assertEqual(validation.errors.mean.value, said["error"]["mean"])
            self.assertEqual(validation.errors.goal.value, said["goal_error"])
            self.assertEqual([validation.errors.p95.low, validation.errors.p95.high], said["intervals"]["p95"])
            for path in said["paths"]:
                self.assertEqual(validation.by_path[path["name"]].max.value, path["error"]["max"])
            cells = [{"x": cell["x"], "y": cell["y"], "error": cell["error"]} for cell in said["cells"]]
            self.assertEqual([{name: cell[name] for name in ("x", "y", "error")} for cell in validation.cells], cells)

    def test_gives_each_run_as_arrays(self):
        told = []
        (validation,) = alignability.validate(self.problem, PATHS, runs=3, progress=lambda done, total: told.append((done, total)))
        self.assertEqual(validation.localizer, "ndt_mcl_sum")
        self.assertEqual(told, [(done, 6) for done in range(7)])
        runs = validation.runs["south"]
        self.assertEqual(len(runs), 3)
        errors = np.concatenate([run.errors for run in runs])
        self.assertAlmostEqual(errors.mean(), float(validation.by_path["south"].mean), places=12)
        run = runs[0]
        np.testing.assert_allclose(np.hypot(*(run.estimates - run.truth)[:, :2].T), run.errors, atol=1e-15)
        self.assertEqual((run.truth[-1].tolist(), run.s[-1]), ([3.0, 1.0, 0.0], 1.5))
        self.assertEqual(run.seconds.shape, run.errors.shape)

    def test_refuses_what_are_no_paths(self):
        with self.assertRaisesRegex(TypeError, "paths must be a dict of names and poses"):
            alignability.validate(self.problem, [PATHS["south"]])
        with self.assertRaisesRegex(ValueError, "paths must name a path at least"):
            alignability.validate(self.problem, {})
        with self.assertRaisesRegex(ValueError, r"paths\['south'\] must have the shape"):
            alignability.validate(self.problem, {"south": [1.0, 2.0]})
        with self.assertRaisesRegex(ValueError, "a path must be driven at least once"):
            alignability.validate(self.problem, PATHS, runs=0)
        with self.assertRaisesRegex(ValueError, "must be 'ndt_mcl_sum', 'ndt_mcl_product' or 'scan_matching', not 'amcl'"):
            alignability.validate(self.problem, PATHS, localizers=["amcl"])

    def test_says_what_a_problem_of_arrays_lacks(self):
        made = alignability.Problem(
            self.problem.occupancy, self.problem.alignability, self.problem.robot, self.problem.start, self.problem.goal
        )
        with self.assertRaisesRegex(ValueError, "driving needs the key 'drive': a file"):
            alignability.validate(made, PATHS)
        made.drive, made.sensor, made.scene = (self.folder / name for name in ("drive.yaml", "sensor.yaml", "world.sdf"))
        (validation,) = alignability.validate(made, PATHS, runs=1)
        self.assertEqual(list(validation.by_path), list(PATHS))
