#!/usr/bin/env -S /usr/bin/python3 -u
# SPDX-License-Identifier: BSD-3-Clause
"""soak.py PROGRAM MAPS [--minutes M] [--seed S] [--workers N] [--resident FOLDER]: mixed commands side by side, with faults, for an hour.

Each worker draws one command of the table after another and writes over what the last one of its kind left: one of two variants, whose files
are known to the byte from a first quiet round. About half of them are disturbed: killed by SIGKILL, SIGTERM or SIGINT, on a disk that is filled,
with an input renamed, emptied or cut while they run. Afterwards every file must be one variant's or the other's, a command that was left alone must
have succeeded, and one that was not must have ended with its own exit code and a line about it. With --resident, one process of the Python
package in FOLDER plans and scores all the while, and its memory is watched. Ends with 0 when nothing was found; needs root, for its tmpfs.
"""
import argparse
import collections
import contextlib
import json
import os
import random
import re
import shutil
import signal
import statistics
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

DISK = 96 << 20  # of a worker; twice what its files take
SIGNALS = {"kill": signal.SIGKILL, "terminate": signal.SIGTERM, "interrupt": signal.SIGINT}
FAULTS = [*SIGNALS, "full disk", "input gone", "input empty", "input cut"]
# Yes, no, an error that is told, an interrupt; see `alignability --help`.
OWN_EXITS = {0, 1, 2, 130}


def commands():
    """By name, the variants that write the same files, and the inputs that may be spoilt. Paths are relative to the worker's folder."""
    house, junction, lidar = "maps/warehouse", "maps/t_junction", ["--sensor", "maps/sensors/hdl32e.yaml"]
    world, problem, small = f"{house}/warehouse.sdf", f"{house}/problem.yaml", f"{junction}/problem.yaml"
    build = ["map", "--scene", world, "--occupancy", f"{house}/occupancy.yaml", *lidar, "--range-max", "6.5", "--samples", "2", "-o", "map"]
    plan_files = [problem, f"{house}/occupancy.pgm", f"{house}/alignability.tiff", f"{house}/alignability.yaml"]
    small_files = [small, f"{junction}/occupancy.pgm", f"{junction}/alignability.tiff"]
    return {
        "map": ([[*build, "--polygon", "8,20", "14,20", "14,24", "8,24"], [*build, "--polygon", "30,20", "36,20", "36,24", "30,24"]], [world]),
        "occupancy": ([["occupancy", world, "--z-min", z, "--z-max", "2", "-o", "occupancy"] for z in ("0.1", "0.5")], [world]),
        "scan": ([["scan", "--scene", world, *lidar, "--at", at, "-o", "scan.pcd"] for at in ("5,20,0", "30,20,1")], [world]),
        "sample": ([["sample", f"{junction}/t_junction.sdf", "--spacing", "0.2", "--seed", seed, "-o", "cloud.pcd"] for seed in "12"], [f"{junction}/t_junction.sdf"]),
        "plan": ([["plan", problem, "--weight", weight, "-o", "plan"] for weight in "50"], plan_files),
        "plan by RRT*": ([["plan", small, "--planner", "rrtstar", "--iterations", "300", "--seed", seed, "-o", "rrtstar"] for seed in "12"], small_files),
        "compare": ([["compare", problem, "--html", "compare.html", "--weight", weight, "-o", "compare"] for weight in "52"], plan_files),
        "export": ([["export", problem, "--weight", weight, "-o", "export"] for weight in "52"], plan_files),
        "report": ([["report", file, "-o", "report.html"] for file in (problem, small)], plan_files),
        "validate": ([["validate", "path", small, "kept.csv", "--drive-file", f"{house}/drive.yaml", "--runs", "1", "--drive-seed", seed, "-o", "drive"] for seed in "12"], small_files),
    }


def told_anew(text):
    """Without what differs from run to run: how long it took."""
    return re.sub(rb'("[a-z_]*(?:seconds|_time|time)[a-z_]*":\s*)[-+.0-9e]+', rb"\1?", text)


def files_in(folder):
    # An unfinished build goes on from its .part; a killed one may leave the new file beside the old, under a name of its own.
    return {path.name: told_anew(path.read_bytes()) for path in folder.iterdir() if path.is_file() and ".part" not in path.name}


class Reference:
    """What each command writes where all is well."""

    def __init__(self, program, maps, folder):
        self.files = collections.defaultdict(lambda: collections.defaultdict(set))
        shutil.copytree(maps, folder / "maps")
        subprocess.run([program, "plan", "maps/t_junction/problem.yaml", "-o", "kept"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        self.kept = (folder / "kept.csv").read_bytes()
        for name, (variants, _) in commands().items():
            for words in variants:
                before = files_in(folder)
                run = subprocess.run([program, *words], cwd=folder, capture_output=True)
                if run.returncode != 0:
                    sys.exit(f"{' '.join(words)}: {run.stderr.decode()}")
                for file, data in files_in(folder).items():
                    if before.get(file) != data or file in self.files[name]:
                        self.files[name][file].add(data)

    def faults_of(self, name, folder):
        own = self.files[name]
        return [file for file, data in files_in(folder).items() if file in own and data not in own[file]]


class Worker(threading.Thread):
    def __init__(self, number, options, reference, folder):
        super().__init__()
        self.options, self.reference, self.folder = options, reference, folder
        self.draw = random.Random(f"{options.seed} {number}")
        self.found, self.runs = [], []
        folder.mkdir()
        subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={DISK}", "tmpfs", folder], check=True)
        shutil.copytree(options.maps, folder / "maps")
        (folder / "kept.csv").write_bytes(reference.kept)

    def run(self):
        while time.monotonic() < self.options.end:
            try:
                self.one_command()
            except Exception as error:  # a fault of this script counts as well: it must not go unseen
                self.found.append(f"soak.py: {error!r}")
                return

    def one_command(self):
        name = self.draw.choice(list(commands()))
        variants, inputs = commands()[name]
        words = self.draw.choice(variants)
        fault = self.draw.choice(FAULTS) if self.draw.random() < 0.5 else None
        begin = time.monotonic()
        with tempfile.TemporaryFile() as err:  # on another disk than the one that fills
            with self.disturbed_disk(fault):
                process = subprocess.Popen([self.options.program, *words], cwd=self.folder, stdout=subprocess.DEVNULL, stderr=err)
                with self.disturbed_input(fault, self.folder / self.draw.choice(inputs)):
                    if fault in SIGNALS:
                        time.sleep(self.draw.uniform(0.0, 1.5))
                        os.kill(process.pid, SIGNALS[fault])  # not by send_signal, which might wait for it
                    _, status, usage = os.wait4(process.pid, 0)
                    process.returncode = os.waitstatus_to_exitcode(status)
            err.seek(0)
            said = err.read().decode(errors="replace")
        self.runs.append((name, fault, process.returncode, time.monotonic() - begin, usage.ru_maxrss))
        self.judge(name, words, fault, process.returncode, said)

    def judge(self, name, words, fault, code, said):
        tell = lambda what: self.found.append(f"{name}, {fault}, exit {code}: {what}: {' '.join(words)}\n    {said.strip()[-500:]}")
        if fault is None and code != 0:
            tell("failed though left alone")
        if code not in OWN_EXITS and not (fault in SIGNALS and -code in (SIGNALS[fault],)):
            tell("did not end by itself")
        if code == 2 and not said.strip():
            tell("said nothing of its error")
        # A text that is cut at the end of a line may be whole YAML, which says something else.
        is_another = fault == "input cut" and code in (0, 1)
        for file in self.reference.faults_of(name, self.folder):
            if not is_another:
                tell(f"{file} is neither variant's")
                shutil.copy(self.folder / file, self.options.keep)
            (self.folder / file).unlink()
        if fault is None:  # what killed ones left under names of their own would fill the disk in time
            for path in self.folder.glob(".*"):
                path.unlink()

    @contextlib.contextmanager
    def disturbed_disk(self, fault):
        if fault != "full disk":
            yield
            return
        filler = self.folder / "filler.part"
        with contextlib.suppress(OSError), open(filler, "wb", buffering=0) as out:
            while out.write(bytes(1 << 12)) > 0:
                pass
        os.truncate(filler, max(0, filler.stat().st_size - self.draw.choice([0, 1 << 12, 1 << 16, 1 << 18])))
        try:
            yield
        finally:
            filler.unlink()

    @contextlib.contextmanager
    def disturbed_input(self, fault, file):
        if fault is None or not fault.startswith("input"):
            yield
            return
        time.sleep(self.draw.choice([0.0, 0.0, 0.05, 0.2, 0.5]))
        data = file.read_bytes()
        if fault == "input gone":
            file.unlink()
        else:
            file.write_bytes(b"" if fault == "input empty" else data[: self.draw.randrange(len(data))])
        try:
            yield
        finally:
            file.write_bytes(data)


RESIDENT = """
import sys, alignability as a
problem, scan = sys.argv[1], sys.argv[2]
pages = lambda: int(open('/proc/self/statm').read().split()[1]) * 4096
done = 0
while sys.stdin.readable():
    a.plan(a.Problem.load(problem)); a.score(a.read_scan(scan)); done += 1
    print(done, pages(), flush=True)
"""


class Resident(threading.Thread):
    """One process that never ends, and what memory it holds after each round: with one arena, for glibc gives threads new ones by chance."""

    def __init__(self, options, problem, scan):
        super().__init__(daemon=True)
        self.process = subprocess.Popen(["/usr/bin/python3", "-c", RESIDENT, problem, scan], env={**os.environ, "PYTHONPATH": str(options.resident), "MALLOC_ARENA_MAX": "1"},
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.bytes, self.found = [], []

    def run(self):
        for line in self.process.stdout:
            self.bytes.append(int(line.split()[1]))

    def finish(self):
        if self.process.poll() is not None:
            self.found.append(f"the resident process ended by {self.process.returncode}: {self.process.stderr.read()[-500:]}")
        self.process.kill()
        self.process.wait()
        return self.bytes


def quarters(values):
    quarter = max(1, len(values) // 4)
    return statistics.median(values[:quarter]), statistics.median(values[-quarter:])


def told(workers, resident, rounds):
    runs = [run for worker in workers for run in worker.runs]
    print(f"\n{len(runs)} commands, {sum(fault is not None for _, fault, *_ in runs)} of them disturbed")
    print(f"\n{'command':14} {'runs':>5} {'median s':>9} {'largest MiB, first and last quarter':>36}")
    for name in commands():
        own = [run for run in runs if run[0] == name and run[1] is None and run[2] == 0]
        if not own:
            continue
        first, last = quarters([run[4] / 1024 for run in own])
        print(f"{name:14} {sum(run[0] == name for run in runs):5} {statistics.median(run[3] for run in own):9.2f} {first:27.1f} {last:8.1f}")
    print(f"\n{'fault':14} {'runs':>5}   exits")
    for fault in [None, *FAULTS]:
        codes = collections.Counter(run[2] for run in runs if run[1] == fault)
        print(f"{str(fault or 'left alone'):14} {sum(codes.values()):5}   " + ", ".join(f"{count} by {code}" for code, count in sorted(codes.items())))
    if resident and rounds:
        first, last = quarters(rounds[len(rounds) // 10:])
        print(f"\nresident: {len(rounds)} rounds, {first / 2**20:.1f} MiB in the first quarter after a tenth to warm up, {last / 2**20:.1f} MiB in the last")
        if last > 1.05 * first:
            resident.found.append("the resident process grew by more than 5 %")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=lambda text: Path(text).resolve())
    parser.add_argument("maps", type=lambda text: Path(text).resolve())
    parser.add_argument("--minutes", type=float, default=60.0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--resident", type=lambda text: Path(text).resolve())
    options = parser.parse_args()
    signal.signal(signal.SIGINT, signal.default_int_handler)  # which children of a background job would ignore
    folder = Path(tempfile.mkdtemp(prefix="alignability-soak-"))
    options.keep = folder / "found"
    options.keep.mkdir()
    workers, resident = [], None
    try:
        quiet = folder / "quiet"
        quiet.mkdir()
        reference = Reference(options.program, options.maps, quiet)
        print(f"{sum(len(files) for files in reference.files.values())} files of {len(commands())} commands are known", flush=True)
        options.end = time.monotonic() + 60.0 * options.minutes
        if options.resident:
            resident = Resident(options, quiet / "maps/t_junction/problem.yaml", quiet / "scan.pcd")
            resident.start()
        for number in range(options.workers):
            workers.append(Worker(number, options, reference, folder / f"worker{number}"))
        for worker in workers:
            worker.start()
        for worker in workers:
            worker.join()
        rounds = resident.finish() if resident else []
        told(workers, resident, rounds)
        found = [what for source in [*workers, *([resident] if resident else [])] for what in source.found]
        print(f"\n{len(found)} found" + "".join(f"\n- {what}" for what in found))
        return 1 if found else 0
    finally:
        for worker in workers:
            subprocess.run(["umount", worker.folder], check=False)
        if not any(options.keep.iterdir()):
            shutil.rmtree(folder, ignore_errors=True)


if __name__ == "__main__":
    sys.exit(main())
