# SPDX-License-Identifier: BSD-3-Clause
"""A small site in a folder of its own, and the program to hold the package against."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import threading
import time
import unittest

SOURCE = pathlib.Path(os.environ["ALIGNABILITY_SOURCE_DIR"])
WAREHOUSE = SOURCE / "maps/warehouse"


def counted_beside(work):
    """How far another thread counts while `work` runs, where the interpreter's lock is taken from no one who holds it."""
    counted = 0
    done = threading.Event()

    def count():
        nonlocal counted
        while not done.is_set():
            counted += 1
            time.sleep(1e-4)

    interval = sys.getswitchinterval()
    sys.setswitchinterval(1000)
    thread = threading.Thread(target=count)
    thread.start()
    try:
        before = counted
        work()
        return counted - before
    finally:
        done.set()
        thread.join()
        sys.setswitchinterval(interval)


def program(*arguments, folder="."):
    """Runs the command line; its exit code, output and errors."""
    words = [os.environ["ALIGNABILITY_PROGRAM"], *map(str, arguments)]
    return subprocess.run(words, cwd=folder, capture_output=True, text=True, check=False)


def program_json(*arguments, folder="."):
    outcome = program(*arguments, "--json", folder=folder)
    assert outcome.returncode in (0, 1), outcome.stderr
    return json.loads(outcome.stdout)


def box(name, pose, size):
    return (
        f"<model name='{name}'><static>true</static><pose>{pose} 0 0 0</pose><link name='link'><collision name='collision'>"
        f"<geometry><box><size>{size}</size></box></geometry></collision></link></model>\n"
    )


def world(*boxes):
    return "<?xml version='1.0'?>\n<sdf version='1.7'><world name='small'>\n" + "".join(boxes) + "</world></sdf>\n"


ROOM = world(
    box("floor", "4 3 -0.05", "8.4 6.4 0.1"),
    box("west", "-0.1 3 1.5", "0.2 6.4 3"),
    box("east", "8.1 3 1.5", "0.2 6.4 3"),
    box("south", "4 -0.1 1.5", "8.4 0.2 3"),
    box("north", "4 6.1 1.5", "8.4 0.2 3"),
    box("block", "4 3 1.5", "2 1 3"),
)
SENSOR = """name: coarse
elevation_deg: {min: -40, max: 30, count: 15}
azimuth_deg: {min: -180, max: 180, count: 360}
range: {min: 0.2, max: 30, stddev: 0.005}
rate: 10
mount: {xyz: [0, 0, 1], rpy_deg: [0, 0, 0]}
"""
PROBLEM = """map: occupancy.yaml
alignability: alignability.yaml
robot: {radius: 0.3}
start: [1.5, 3, 0]
goal: [6.5, 3, 0]
planner: {iterations: 2000, seed: 1}
scene: world.sdf
sensor: sensor.yaml
drive: drive.yaml
"""
DRIVE = "odometry: {scale_bias: 0.02}\nparticles: 50\n"


class SiteTest(unittest.TestCase):
    """Cases in a folder that holds world.sdf, sensor.yaml, occupancy.yaml and, once made, alignability.yaml of problem.yaml."""

    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = pathlib.Path(temporary.name)
        for name, text in {"world.sdf": ROOM, "sensor.yaml": SENSOR, "problem.yaml": PROBLEM, "drive.yaml": DRIVE}.items():
            (cls.folder / name).write_text(text)
        cls.run_program("occupancy", "world.sdf", "--z-min", "0.1", "--z-max", "2", "-o", "occupancy")

    @classmethod
    def run_program(cls, *arguments):
        outcome = program(*arguments, folder=cls.folder)
        assert outcome.returncode == 0, outcome.stderr
        return outcome

    @classmethod
    def make_map(cls):
        cls.run_program(
            "map", "--scene", "world.sdf", "--occupancy", "occupancy.yaml", "--sensor", "sensor.yaml", "--samples", "1", "-o", "alignability"
        )

    def contents(self):
        """Of every file in the folder."""
        return {file.name: file.read_bytes() for file in self.folder.iterdir()}
