# SPDX-License-Identifier: BSD-3-Clause
"""cluster_test.py [METHOD]: maps built by several processes, which are ranks of MPI on this machine.

Ends with 77 where there is no mpirun, or the program was built without MPI.
"""
import json
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent / "python"))
import unittest

from site_cases import SiteTest, program

PROGRAM = os.environ["ALIGNABILITY_PROGRAM"]
# As root, with more ranks than processors, each waiting in turns.
ENVIRONMENT = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1", OMPI_MCA_mpi_yield_when_idle="1")
SITE = ["--scene", "world.sdf", "--occupancy", "occupancy.yaml", "--sensor", "sensor.yaml"]
FEW = ["map", *SITE, "--samples", "2", "--threads", "1"]
MANY = ["map", *SITE, "--samples", "24", "--threads", "1"]
SITES = """sensor: sensor.yaml
occupancy: occupancy.yaml
samples: 2
sites:
  - {name: one, scene: world.sdf}
  - {name: two, scene: missing.sdf}
  - {name: three, scene: world.sdf, headings: 2}
"""


def mpirun(ranks, *words):
    return ["mpirun", "--oversubscribe", "-n", str(ranks), PROGRAM, *words]


def records_in(checkpoint):
    """How many cells it holds at least: a record of such a map is 36 bytes, after a header of 34."""
    return (checkpoint.stat().st_size - 34) // 36 if checkpoint.exists() else 0


def ranks_under(launcher):
    """The process of each rank."""
    found = {}
    for process in Path("/proc").glob("[0-9]*"):
        try:
            if Path(os.readlink(process / "exe")) != Path(PROGRAM).resolve():
                continue
            environment = dict(word.split("=", 1) for word in (process / "environ").read_text().split("\0") if "=" in word)
            if int((process / "stat").read_text().rpartition(")")[2].split()[1]) == launcher.pid:
                found[int(environment["OMPI_COMM_WORLD_RANK"])] = int(process.name)
        except OSError:
            continue
    return found


class Cluster(SiteTest):
    def setUp(self):
        kept = {"world.sdf", "sensor.yaml", "problem.yaml", "drive.yaml", "occupancy.yaml", "occupancy.pgm"}
        for file in self.folder.iterdir():
            if file.name not in kept:
                shutil.rmtree(file) if file.is_dir() else file.unlink()

    def run_ranks(self, command, **more):
        return subprocess.run(command, cwd=self.folder, env=ENVIRONMENT, capture_output=True, text=True, check=False, **more)

    def expect_success(self, outcome):
        self.assertEqual(outcome.returncode, 0, outcome.stdout + outcome.stderr)

    def map_files(self, name, *words):
        """What one process makes of it."""
        self.expect_success(program(*words, "-o", name, folder=self.folder))
        return self.files_of(name, name)

    def files_of(self, name, told):
        return {ending: (self.folder / (name + ending)).read_bytes().replace(name.encode(), told.encode()) for ending in (".tiff", ".yaml")}

    def expect_same_bytes(self, ranks, *words):
        alone = self.map_files("alone", *words)
        for number in ranks:
            with self.subTest(ranks=number):
                outcome = self.run_ranks(mpirun(number, *words, "-o", "shared"))
                self.expect_success(outcome)
                self.assertEqual(outcome.stdout.count("cells from"), 1, "one rank speaks for all")
                self.assertEqual(outcome.stderr, "")
                self.assertEqual(self.files_of("shared", "alone"), alone)
                self.assertFalse((self.folder / "shared.part").exists())

    def start_until(self, records, command, checkpoint="out.part"):
        launcher = subprocess.Popen(command, cwd=self.folder, env=ENVIRONMENT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        end = time.monotonic() + 120
        while records_in(self.folder / checkpoint) < records and launcher.poll() is None and time.monotonic() < end:
            time.sleep(0.002)
        self.assertIsNone(launcher.poll(), "it was too fast to be disturbed")
        return launcher

    def test_one_two_and_three_ranks_write_the_same_bytes(self):
        self.expect_same_bytes([1, 2, 3], *FEW, "--readings", "robust")

    def test_headings_are_shared_to_the_same_bytes(self):
        self.expect_same_bytes([2], *FEW, "--headings", "3")

    def test_a_part_and_an_update_are_shared_to_the_same_bytes(self):
        self.expect_same_bytes([2], *FEW, "--cells", "0,0", "3,1", "7,5")
        self.map_files("before", *FEW)
        self.expect_same_bytes([3], *FEW, "--polygon", "0,0", "4,0", "4,4", "--update", "before.yaml")

    def test_threads_are_those_asked_for_or_this_ranks_share(self):
        alone = self.map_files("alone", *FEW)
        for threads in ("0", "3"):
            self.expect_success(self.run_ranks(mpirun(2, *FEW[:-1], threads, "-o", "shared")))
            self.assertEqual(self.files_of("shared", "alone"), alone)

    def test_what_one_process_began_ranks_go_on_with_and_the_reverse(self):
        whole = self.map_files("alone", *MANY)
        for first, then in ([PROGRAM, *MANY], mpirun(2, *MANY)), (mpirun(2, *MANY), [PROGRAM, *MANY]):
            begun = self.start_until(8, [*first, "-o", "out"])
            begun.send_signal(signal.SIGINT)
            begun.communicate()
            self.assertFalse((self.folder / "out.yaml").exists())
            self.assertGreaterEqual(records_in(self.folder / "out.part"), 8)
            outcome = self.run_ranks([*then, "-o", "out"])
            self.expect_success(outcome)
            self.assertIn("cells are there; going on from them", outcome.stderr)
            self.assertEqual(self.files_of("out", "alone"), whole)
            (self.folder / "out.yaml").unlink()

    def test_a_rank_that_dies_ends_the_job_and_the_next_start_goes_on(self):
        whole = self.map_files("alone", *MANY)
        moments = random.Random(11)
        for rank in (1, 0, 2):
            with self.subTest(rank=rank):
                job = self.start_until(records_in(self.folder / "out.part") + moments.randint(1, 6), [*mpirun(3, *MANY), "-o", "out"])
                os.kill(ranks_under(job)[rank], signal.SIGKILL)
                error = job.communicate(timeout=60)[1]
                self.assertNotEqual(job.returncode, 0)
                self.assertRegex(error, rf"rank {rank} with PID \d+ on node \S+ exited on signal 9")
        self.expect_success(self.run_ranks(mpirun(2, *MANY, "-o", "out")))
        self.assertEqual(self.files_of("out", "alone"), whole)

    def test_ranks_that_read_other_inputs_are_refused(self):
        (self.folder / "stale.sdf").write_text((self.folder / "world.sdf").read_text().replace("4 3 1.5", "4.1 3 1.5"))
        for scene, fault in ("stale.sdf", "has another input than rank 0 on"), ("absent.sdf", "absent.sdf: no such file"):
            other = [scene if word == "world.sdf" else word for word in FEW]
            command = [*mpirun(1, *FEW, "-o", "out"), ":", "-n", "1", PROGRAM, *other, "-o", "out"]
            outcome = self.run_ranks(command)
            self.assertEqual(outcome.returncode, 2)
            self.assertRegex(outcome.stderr, rf"(?m)^alignability: rank 1 on \S+:? .*{fault}")
            self.assertEqual(outcome.stderr.count("alignability: "), 1)
            self.assertFalse(list(self.folder.glob("out*")))

    def test_what_is_wrong_for_all_is_told_once(self):
        outcome = self.run_ranks(mpirun(2, *FEW, "--update", "missing.yaml", "-o", "out"))
        self.assertEqual(outcome.returncode, 2)
        self.assertEqual(outcome.stderr.count("--update takes"), 1, outcome.stderr)
        outcome = self.run_ranks(mpirun(2, "map", "--sceen", "world.sdf"))
        self.assertEqual(outcome.returncode, 2)
        self.assertEqual(outcome.stderr.count("unknown option '--sceen'"), 1, outcome.stderr)

    def test_a_full_disk_ends_the_job_with_its_name(self):
        limit = lambda: (resource.setrlimit(resource.RLIMIT_FSIZE, (1 << 12, 1 << 12)), signal.signal(signal.SIGXFSZ, signal.SIG_IGN))
        plain = dict(ENVIRONMENT, OMPI_MCA_btl="self,tcp")
        command = ["mpirun", "--oversubscribe", "-n", "2", "sh", "-c", 'ulimit -f 1; trap "" XFSZ; exec "$@"', "sh", PROGRAM, *FEW, "-o", "out"]
        outcome = subprocess.run(command, cwd=self.folder, env=plain, capture_output=True, text=True, check=False)
        self.assertEqual(outcome.returncode, 2, outcome.stderr)
        self.assertRegex(outcome.stderr, r"(?m)^out\.part: cannot be written: ")

    def test_other_commands_are_refused_to_several_processes(self):
        for command in (["plan", "problem.yaml"], ["map", "--merge", "a.yaml", "b.yaml", "--occupancy", "occupancy.yaml", "-o", "out"]):
            outcome = self.run_ranks(mpirun(2, *command))
            self.assertEqual(outcome.returncode, 2)
            self.assertEqual(outcome.stderr.count("is the work of one process, and 2 were started"), 1, outcome.stderr)
        self.assertEqual(self.run_ranks(mpirun(1, "occupancy", "world.sdf", "--z-min", "0.1", "--z-max", "2", "-o", "sliced")).returncode, 0)

    def test_mpi_is_not_touched_without_a_launcher(self):
        no_such_mpi = dict(ENVIRONMENT, OMPI_MCA_pml="none_such")
        alone = subprocess.run([PROGRAM, *FEW, "-o", "out"], cwd=self.folder, env=no_such_mpi, capture_output=True, check=False)
        self.assertEqual(alone.returncode, 0)
        launched = subprocess.run(mpirun(1, *FEW, "-o", "out"), cwd=self.folder, env=no_such_mpi, capture_output=True, check=False)
        self.assertNotEqual(launched.returncode, 0)

    def test_sites_are_shared_one_after_the_other(self):
        (self.folder / "sites.yaml").write_text(SITES)
        alone = program("map", "--sites", "sites.yaml", "--json", folder=self.folder)
        self.assertEqual(alone.returncode, 1, alone.stderr)
        made = {name: self.files_of(name, name) for name in ("one", "three")}
        for name in made:
            (self.folder / (name + ".yaml")).unlink()
        shared = self.run_ranks(mpirun(3, "map", "--sites", "sites.yaml", "--json"))
        self.assertEqual(shared.returncode, 1, shared.stderr)
        self.assertEqual([site["status"] for site in json.loads(shared.stdout)], ["built", "failed", "built"])
        self.assertEqual({name: self.files_of(name, name) for name in made}, made)
        again = self.run_ranks(mpirun(2, "map", "--sites", "sites.yaml", "--json"))
        self.assertEqual([site["status"] for site in json.loads(again.stdout)], ["kept", "failed", "kept"])

    def test_the_slurm_script_builds_sites_under_another_launcher(self):
        (self.folder / "sites.yaml").write_text(SITES.replace("missing.sdf", "world.sdf"))
        environment = dict(ENVIRONMENT, LAUNCHER="mpirun --oversubscribe -n 2", ALIGNABILITY=PROGRAM)
        script = Path(os.environ["ALIGNABILITY_SOURCE_DIR"]) / "demos/cluster.slurm"
        outcome = subprocess.run(["bash", script, "sites.yaml"], cwd=self.folder, env=environment, capture_output=True, text=True, check=False)
        self.expect_success(outcome)
        self.assertIn("3 built, 0 kept, 0 failed", outcome.stdout)


if __name__ == "__main__":
    if os.environ["ALIGNABILITY_HAS_MPI"] != "1" or shutil.which("mpirun") is None:
        print("skipped: there is no mpirun, or the program was built without MPI")
        sys.exit(77)
    unittest.main(argv=[sys.argv[0], *(f"Cluster.{name}" for name in sys.argv[1:])])
