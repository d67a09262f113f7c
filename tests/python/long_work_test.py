# SPDX-License-Identifier: BSD-3-Clause
"""The lock of the interpreter, signals and the caller's progress functions, with all that lasts. Work here has no end of its own."""

import signal
import subprocess
import sys
import threading
import time

import numpy as np

import alignability
from site_cases import SiteTest, counted_beside

ENDLESS = {
    "build_map": """
alignability.build_map("world.sdf", "sensor.yaml", "occupancy.yaml", samples=100_000, progress=tell)
""",
    "plan": """
problem.planner = alignability.PlannerChoice(name="rrtstar", time=100_000)
tell(0, 0)
alignability.plan(problem)
""",
    "compare": """
problem.planner = alignability.PlannerChoice(name="prmstar", time=100_000)
tell(0, 0)
alignability.compare(problem)
""",
    "validate": """
alignability.validate(problem, {"path": [(1.5, 1, 0), (6.5, 1, 0)] * 100}, runs=1000, progress=tell)
""",
}
HEAD = """
import signal
import alignability

signal.signal(signal.SIGINT, signal.default_int_handler)  # whatever started this may ignore it
problem = alignability.Problem.load("problem.yaml")

def tell(done, total):
    print("under way", flush=True)
"""


class LongWorkTest(SiteTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.make_map()

    def endless_build(self, **options):
        files = [self.folder / name for name in ("world.sdf", "sensor.yaml", "occupancy.yaml")]
        return alignability.build_map(*files, samples=100_000, **options)

    def test_ends_with_keyboard_interrupt_and_changes_no_file(self):
        before = self.contents()
        for name, script in ENDLESS.items():
            with self.subTest(name):
                child = subprocess.Popen(
                    [sys.executable, "-c", HEAD + script], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
                )
                self.addCleanup(child.kill)
                self.assertEqual(child.stdout.readline(), "under way\n")
                time.sleep(0.2)
                child.send_signal(signal.SIGINT)
                _, errors = child.communicate(timeout=120)
                self.assertEqual(child.returncode, -signal.SIGINT, errors)
                self.assertIn("KeyboardInterrupt", errors)
                self.assertEqual(self.contents(), before)

    def test_lets_a_signals_handler_raise_what_it_likes(self):
        class TimeIsUp(Exception):
            pass

        def handler(number, frame):
            raise TimeIsUp

        self.addCleanup(signal.signal, signal.SIGALRM, signal.signal(signal.SIGALRM, handler))
        signal.setitimer(signal.ITIMER_REAL, 0.3)
        with self.assertRaises(TimeIsUp):
            self.endless_build()

    def test_lets_a_signals_handler_return(self):
        handled = []
        self.addCleanup(signal.signal, signal.SIGALRM, signal.signal(signal.SIGALRM, lambda number, frame: handled.append(number)))
        reached = threading.Event()

        def wait_for_the_handler(done, total):
            # The handler runs on the thread that called, while this is another.
            if not reached.is_set():
                signal.raise_signal(signal.SIGALRM)
                while not handled:
                    time.sleep(0.01)
                reached.set()

        files = [self.folder / name for name in ("world.sdf", "sensor.yaml", "occupancy.yaml")]
        made = alignability.build_map(*files, samples=1, progress=wait_for_the_handler)
        self.assertEqual(handled, [signal.SIGALRM])
        self.assertFalse(np.isnan(made.alpha).all())

    def test_stops_with_what_a_progress_function_raises(self):
        error = RuntimeError("enough")
        calls = []

        def progress(done, total):
            calls.append(done)
            raise error

        with self.assertRaises(RuntimeError) as raised:
            self.endless_build(progress=progress)
        self.assertIs(raised.exception, error)
        self.assertEqual(len(calls), 1)
        with self.assertRaises(RuntimeError):
            problem = alignability.Problem.load(self.folder / "problem.yaml")
            alignability.validate(problem, {"path": [(1.5, 1, 0), (6.5, 1, 0)]}, runs=1000, progress=progress)

    def test_lets_other_threads_run_meanwhile(self):
        files = [self.folder / name for name in ("world.sdf", "sensor.yaml", "occupancy.yaml")]
        self.assertGreater(counted_beside(lambda: alignability.build_map(*files, samples=1)), 0)

    def test_may_be_called_by_threads_that_are_not_the_main_one(self):
        made = []
        files = [self.folder / name for name in ("world.sdf", "sensor.yaml", "occupancy.yaml")]
        threads = [threading.Thread(target=lambda: made.append(alignability.build_map(*files, samples=1))) for _ in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        np.testing.assert_array_equal(made[0].alpha, made[1].alpha)
