# SPDX-License-Identifier: BSD-3-Clause
import ast
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import alignability

# pybind11's classes have a metaclass of its own, and tell of their constructors in words alone.
ALLOWED = """alignability\\.[A-Z]\\w+
alignability\\.[A-Z]\\w+\\.__init__
"""


class StubsTest(unittest.TestCase):
    def run_mypy(self, *arguments, folder="."):
        environment = {**os.environ, "MYPYPATH": str(pathlib.Path(alignability.__file__).parent.parent)}
        return subprocess.run([sys.executable, "-m", *arguments], cwd=folder, env=environment, capture_output=True, text=True, check=False)

    def test_agree_with_the_module(self):
        with tempfile.TemporaryDirectory() as folder:
            allowed = pathlib.Path(folder) / "allowed"
            allowed.write_text(ALLOWED)
            outcome = self.run_mypy("mypy.stubtest", "alignability", "--allowlist", str(allowed), folder=folder)
        self.assertEqual(outcome.returncode, 0, outcome.stdout + outcome.stderr)

    def test_name_all_that_the_module_has(self):
        stub = ast.parse((pathlib.Path(alignability.__file__).parent / "__init__.pyi").read_text())
        named = {node.name for node in stub.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
        self.assertEqual(named | {"__version__"}, set(alignability.__all__))

    def test_name_the_attributes_that_options_have(self):
        stub = (pathlib.Path(alignability.__file__).parent / "__init__.pyi").read_text()
        for name in ("GoalTolerance", "Motion", "PlannerChoice", "RiskOptions", "Robot"):
            options = getattr(alignability, name)()
            declared = stub.split(f"class {name}:")[1].split("def __init__")[0]
            self.assertEqual(
                [line.split(":")[0].strip() for line in declared.strip().splitlines()],
                [word.split("=")[0] for word in repr(options).split("(", 1)[1].removesuffix(")").split(", ")],
            )

    def test_tell_a_type_checker_what_is_wrong(self):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "user.py").write_text(
                "import alignability\n"
                "problem = alignability.Problem.load('problem.yaml')\n"
                "problem.weight = 2\n"
                "result = alignability.plan(problem)\n"
                "length: float = result.poses.sum()\n"
                "alignability.score([[0.0, 0.0, 0.0]], strid=2)\n"
            )
            outcome = self.run_mypy("mypy", "--strict", "user.py", folder=folder)
        self.assertIn('user.py:6: error: Unexpected keyword argument "strid" for "score"', outcome.stdout)
        self.assertIn("Found 1 error in 1 file", outcome.stdout)
