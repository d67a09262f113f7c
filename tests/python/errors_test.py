# SPDX-License-Identifier: BSD-3-Clause
import alignability
from site_cases import SiteTest, program


class ErrorsTest(SiteTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.make_map()

    def told_by_both(self, call, *arguments):
        """The error of a call, which must have the text that the program prints."""
        outcome = program(*arguments)
        self.assertEqual(outcome.returncode, 2)
        with self.assertRaises(ValueError) as raised:
            call()
        told = outcome.stderr.strip().removeprefix("alignability: ")
        self.assertEqual(str(raised.exception), told)
        return raised.exception

    def problem_with(self, text):
        bad = self.folder / "bad.yaml"
        bad.write_text((self.folder / "problem.yaml").read_text() + text)
        return bad

    def test_are_the_programs_and_say_where(self):
        bad = self.problem_with("risk: {wieght: 5}\n")
        error = self.told_by_both(lambda: alignability.Problem.load(bad), "plan", bad)
        self.assertIsInstance(error, alignability.InputError)
        self.assertIn("unknown key 'wieght' (did you mean 'weight'?)", str(error))
        self.assertEqual((error.file, error.line, error.column), (str(bad), 10, 8))

    def test_are_the_programs_for_files_that_are_not_there(self):
        gone = self.folder / "gone.yaml"
        error = self.told_by_both(lambda: alignability.Problem.load(gone), "plan", gone)
        self.assertEqual((error.line, error.column), (0, 0))
        self.told_by_both(lambda: alignability.read_scan(gone), "score", gone)

    def test_come_out_of_work_on_another_thread(self):
        bad = self.folder / "bad_sensor.yaml"
        bad.write_text((self.folder / "sensor.yaml").read_text() + "colour: red\n")
        arguments = (self.folder / "world.sdf", bad, self.folder / "occupancy.yaml")
        self.told_by_both(
            lambda: alignability.build_map(*arguments),
            *("map", "--scene", arguments[0], "--sensor", bad, "--occupancy", arguments[2], "-o", self.folder / "never"),
        )

    def test_of_planning_are_the_programs(self):
        problem = alignability.Problem.load(self.folder / "problem.yaml")
        problem.planner.name = "lbtrrt"
        self.told_by_both(lambda: alignability.plan(problem), "plan", self.folder / "problem.yaml", "--planner", "lbtrrt")

    def test_of_driving_are_the_programs(self):
        lacking = self.folder / "lacking.yaml"
        lacking.write_text((self.folder / "problem.yaml").read_text().replace("drive: drive.yaml\n", ""))
        path = self.folder / "path.csv"
        path.write_text("x,y,yaw\n1.5,3,0\n2,3,0\n")
        problem = alignability.Problem.load(lacking)
        error = self.told_by_both(
            lambda: alignability.validate(problem, {"path": [(1.5, 3, 0), (2, 3, 0)]}), "validate", "path", lacking, path
        )
        self.assertIsInstance(error, alignability.InputError)

    def test_name_files_in_any_encoding(self):
        name = str(self.folder / "h\udcff.yaml")
        with self.assertRaises(alignability.InputError) as raised:
            alignability.Problem.load(name)
        self.assertEqual(raised.exception.file, name)
