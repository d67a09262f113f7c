# SPDX-License-Identifier: BSD-3-Clause
"""faults_test.py PROGRAM MAPS [METHOD]: what the program leaves behind when disks fill, folders are shut, inputs vanish and it is killed.

Each command writes first where all is well; then the same again under a fault must end with an error of one line, and leave what stood there
to the byte. Ends with 77 where the faults of a method cannot be made here.
"""
import contextlib
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

PROGRAM, MAPS = Path(sys.argv.pop(1)).resolve(), Path(sys.argv.pop(1)).resolve()
SITE = MAPS / "warehouse"
MAP = ["map", "--scene", SITE / "warehouse.sdf", "--occupancy", SITE / "occupancy.yaml", "--sensor", MAPS / "sensors/hdl32e.yaml", "--range-max", "6.5"]
COMMANDS = {
    "occupancy": ["occupancy", SITE / "warehouse.sdf", "--z-min", "0.1", "--z-max", "2", "-o", "out"],
    "map": [*MAP, "--samples", "1", "--cells", "12,22", "-o", "out"],
    "scan": ["scan", "--scene", SITE / "warehouse.sdf", "--sensor", MAPS / "sensors/hdl32e.yaml", "--at", "5,20,0", "-o", "out.pcd"],
    "plan": ["plan", SITE / "problem.yaml", "-o", "out"],
    "compare": ["compare", SITE / "problem.yaml", "--html", "out.html", "-o", "out"],
    "export": ["export", SITE / "problem.yaml", "-o", "out"],
    "report": ["report", SITE / "problem.yaml", "-o", "out.html"],
}


def contents(folder):
    """All but what an unfinished build goes on from."""
    return {path.name: path.read_bytes() for path in folder.iterdir() if not path.name.endswith(".cells.part")}


class Faults(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="alignability-faults-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def run_in(self, folder, command, **more):
        words = [PROGRAM, *map(str, command)]
        return subprocess.run(words, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **more)

    def done_once(self, name, command):
        folder = self.folder / name
        folder.mkdir()
        self.assertEqual(self.run_in(folder, command).returncode, 0)
        return folder

    def expect_refusal(self, folder, command, before, **more):
        run = self.run_in(folder, command, **more)
        self.assertEqual(run.returncode, 2, run.stderr)
        self.assertRegex(run.stderr.strip().splitlines()[-1], r"^out[._a-z]*: |cannot be written|No space|too large|Read-only")
        self.assertEqual(contents(folder), before, "what stood there has changed, or something was left behind")

    def test_files_that_may_not_grow_are_not_torn(self):
        limit = lambda: (resource.setrlimit(resource.RLIMIT_FSIZE, (512, 512)), signal.signal(signal.SIGXFSZ, signal.SIG_IGN))
        for name, command in COMMANDS.items():
            with self.subTest(name):
                folder = self.done_once(name, command)
                before = contents(folder)
                run = self.run_in(folder, command, preexec_fn=limit)
                self.assertEqual(run.returncode, 2, run.stderr)
                after = contents(folder)
                self.assertEqual(after.keys(), before.keys(), "nothing is left behind")
                # Small files, written before the first great one, are whole and the same.
                for file, data in before.items():
                    self.assertEqual(len(after[file]), len(data), file)

    def test_a_full_disk_loses_nothing(self):
        self.mounted("size=8m")
        for name, command in COMMANDS.items():
            with self.subTest(name):
                folder = self.done_once(name, command)
                before = contents(folder)
                with self.full_disk():
                    self.expect_refusal(folder, command, before)
                self.assertEqual(self.run_in(folder, command).returncode, 0, "with room again it works again")
                shutil.rmtree(folder)

    def test_a_folder_that_is_shut_is_named(self):
        self.mounted("size=32m")
        for name, command in COMMANDS.items():
            self.done_once(name, command)
        subprocess.run(["mount", "-o", "remount,ro", self.folder], check=True)
        for name, command in COMMANDS.items():
            with self.subTest(name):
                self.expect_refusal(self.folder / name, command, contents(self.folder / name))

    def test_inputs_that_vanish_or_change_are_told(self):
        for name, spoil in [("vanish", lambda path: path.unlink()), ("empty", lambda path: path.write_bytes(b"")),
                            ("cut short", lambda path: path.write_bytes(path.read_bytes()[:40]))]:
            for victim in ["occupancy.pgm", "occupancy.yaml", "alignability.tiff", "alignability.yaml", "problem.yaml"]:
                with self.subTest(f"{victim}, {name}"):
                    copy = self.folder / "maps"
                    shutil.rmtree(copy, ignore_errors=True)
                    shutil.copytree(MAPS, copy)
                    spoil(copy / "warehouse" / victim)
                    run = self.run_in(self.folder, ["plan", copy / "warehouse/problem.yaml", "-o", "out"])
                    self.assertEqual(run.returncode, 2, run.stderr)
                    self.assertIn(victim, run.stderr)
                    self.assertFalse((self.folder / "out.json").exists())

    def test_inputs_edited_during_a_build_do_not_mix_into_it(self):
        copy = self.folder / "maps"
        shutil.copytree(MAPS, copy)
        command = [word if not isinstance(word, Path) else copy / word.relative_to(MAPS) for word in MAP]
        command += ["--samples", "8", "--polygon", "8,20", "20,20", "20,25", "8,25", "-o", "out"]
        whole = self.run_in(self.folder, command)
        self.assertEqual(whole.returncode, 0, whole.stderr)
        wanted = (self.folder / "out.tiff").read_bytes()
        for path in self.folder.glob("out*"):
            path.unlink()
        build = subprocess.Popen([PROGRAM, *map(str, command)], cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.wait_for_a_checkpoint(build)
        shutil.rmtree(copy)
        self.assertEqual(build.wait(), 0)
        self.assertEqual((self.folder / "out.tiff").read_bytes(), wanted, "it had read them whole")

    def test_a_build_killed_at_any_moment_goes_on_to_the_same_bytes(self):
        command = [*MAP, "--samples", "8", "--polygon", "8,20", "20,20", "20,25", "8,25", "-o", "out"]
        self.assertEqual(self.run_in(self.folder, command).returncode, 0)
        wanted = contents(self.folder)
        for path in self.folder.iterdir():
            path.unlink()
        moments = random.Random(7)
        for _ in range(6):
            build = subprocess.Popen([PROGRAM, *map(str, command)], cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            time.sleep(moments.uniform(0.0, 1.0))
            build.kill()
            build.wait()
        self.assertEqual(self.run_in(self.folder, command).returncode, 0)
        self.assertEqual(contents(self.folder), wanted)

    @contextlib.contextmanager
    def full_disk(self):
        filler = self.folder / "filler"
        try:
            with contextlib.suppress(OSError), open(filler, "wb", buffering=0) as out:
                while out.write(bytes(1 << 12)) > 0:
                    pass
            yield
        finally:
            filler.unlink()

    def wait_for_a_checkpoint(self, build):
        while build.poll() is None and not [path for path in self.folder.iterdir() if path.name.startswith("out")]:
            time.sleep(0.01)

    def mounted(self, options):
        if os.geteuid() != 0 or subprocess.run(["mount", "-t", "tmpfs", "-o", options, "tmpfs", self.folder], stderr=subprocess.DEVNULL).returncode != 0:
            print("a file system of its own cannot be mounted here")
            sys.stdout.flush()
            os._exit(77)
        self.addCleanup(subprocess.run, ["umount", self.folder])


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *(f"Faults.{name}" for name in sys.argv[1:])])
