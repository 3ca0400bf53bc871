"""Error against time, ours and Mitsuba 3's: whole renders, one after the other in turns.

    python3 tests/bench/peers.py --program build/Raytracing [--scenes cornell glossy]
        [--spp 16 64 256] [--rounds 5] [--size 256] [--threads 2] [--references FOLDER]
        [--scalar-rounds 1] [--reference-passes 128]

Needs the PyPI package mitsuba and a library libLLVM (validation/mitsuba_setup.py finds it). Prints
a table in Markdown for each scene:

  s           seconds of rendering, median of the rounds. Mitsuba's without loading, building and
              compiling its kernels, for which each picture is rendered once before.
  process s   ours only: the whole program, from start to the written picture
  relMSE      mean of (x - r)^2 / (r^2 + .01) over pixels and channels, less the reference's own
              variance; mean of the rounds, which differ by seed
  efficiency  1 / (relMSE * s); below it, in proportion to the best of Mitsuba's at as many samples
  Mpath/s     camera paths

All bounces, box filter, the program's and Mitsuba's own defaults for roulette. The references are
by Mitsuba too, and stay in FOLDER for the next time. For ours they have the height-correlated GGX
of validation/ggx_correlated.py; for Mitsuba's pictures they have its `roughconductor`, which
differs.
"""

import argparse
import datetime
import json
import pathlib
import platform
import statistics
import subprocess
import tempfile
import time
from dataclasses import dataclass, field

import numpy as np

from mitsuba_process import MitsubaProcess

ROOT = pathlib.Path(__file__).resolve().parents[2]
EPSILON = 0.01
REFERENCE_SPP, REFERENCE_SEED = 64, 100_000
ROULETTE_DEPTH = 5  # Mitsuba's default
OURS = {"ours, reuse off": ["--light-sampling", "point", "--reuse", "1"],
        "ours, --reuse 16": ["--light-sampling", "point", "--reuse", "16"]}
THEIRS = [("llvm_ad_rgb", "multijitter"), ("llvm_ad_rgb", "ldsampler"),
          ("scalar_rgb", "multijitter")]


@dataclass
class Runs:
    """What one program did with one scene and number of samples."""

    seconds: list = field(default_factory=list)
    process_seconds: list = field(default_factory=list)
    errors: list = field(default_factory=list)

    def row(self, name, paths):
        s, error = statistics.median(self.seconds), statistics.mean(self.errors)
        process = statistics.median(self.process_seconds) if self.process_seconds else None
        return Row(name, s, process, error, 1 / (error * s), paths / s / 1e6)


@dataclass
class Row:
    name: str
    seconds: float
    process_seconds: float | None
    error: float
    efficiency: float
    speed: float


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", required=True)
    parser.add_argument("--scenes", nargs="+", default=["cornell", "glossy"])
    parser.add_argument("--spp", nargs="+", type=int, default=[16, 64, 256])
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--scalar-rounds", type=int, default=1, help="of scalar_rgb, which is slow")
    parser.add_argument("--size", type=int, default=256)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--reference-passes", type=int, default=128, help="of 64 samples")
    parser.add_argument("--references", type=pathlib.Path, default=ROOT / "build/peers")
    return parser.parse_args()


def relative_error(image, reference):
    mean, variance = reference
    return (((image - mean) ** 2 - variance) / (mean**2 + EPSILON)).mean()


class Bench:
    def __init__(self, arguments, folder):
        self.arguments = arguments
        self.picture = pathlib.Path(folder) / "ours.exr"
        self.stats = pathlib.Path(folder) / "stats.json"
        self.mitsuba = {variant: MitsubaProcess(variant, arguments.threads)
                        for variant in {v for v, _ in THEIRS}}

    def reference(self, scene, conductor):
        """Mean and variance of the mean, made where they are not yet there."""
        size = self.arguments.size
        path = self.arguments.references / f"{scene}_{conductor}_{size}.npz"
        if not path.exists():
            path.parent.mkdir(parents=True, exist_ok=True)
            mean, variance = self.mitsuba["llvm_ad_rgb"].reference(
                scene_path(scene), size, {"conductor": conductor}, REFERENCE_SPP,
                self.arguments.reference_passes, REFERENCE_SEED)
            np.savez(path, mean=mean, variance=variance)
        stored = np.load(path)
        return stored["mean"], stored["variance"]

    def run_ours(self, scene, spp, seed, options, runs, reference):
        size, threads = str(self.arguments.size), str(self.arguments.threads)
        command = [self.arguments.program, str(scene_path(scene)), "--width", size, "--height",
                   size, "--spp", str(spp), "--threads", threads, "--seed", str(seed), "--quiet",
                   "--output", str(self.picture), "--stats", str(self.stats), *options]
        start = time.perf_counter()
        subprocess.run(command, check=True)
        runs.process_seconds.append(time.perf_counter() - start)
        runs.seconds.append(json.loads(self.stats.read_text())["render_seconds"])
        runs.errors.append(relative_error(read_exr(self.picture), reference))

    def run_theirs(self, scene, spp, seed, variant, sampler, runs, reference):
        settings = {"sampler": sampler, "roulette_depth": ROULETTE_DEPTH,
                    "conductor": "roughconductor"}
        seconds, image = self.mitsuba[variant].render(scene_path(scene), self.arguments.size,
                                                      settings, spp, seed)
        runs.seconds.append(seconds)
        runs.errors.append(relative_error(image, reference))

    def measure(self, scene, spp):
        """Rows of all programs, Mitsuba's last."""
        ours = self.reference(scene, "ggxcorrelated")
        theirs = self.reference(scene, "roughconductor")
        runs = {name: Runs() for name in OURS}
        runs |= {f"Mitsuba {v}, {s}": Runs() for v, s in THEIRS}
        for seed in range(1, self.arguments.rounds + 1):
            for name, options in OURS.items():
                self.run_ours(scene, spp, seed, options, runs[name], ours)
            for variant, sampler in THEIRS:
                if variant == "scalar_rgb" and seed > self.arguments.scalar_rounds:
                    continue
                self.run_theirs(scene, spp, seed, variant, sampler,
                                runs[f"Mitsuba {variant}, {sampler}"], theirs)
        paths = spp * self.arguments.size**2
        return [r.row(name, paths) for name, r in runs.items() if r.seconds]


def scene_path(name):
    return ROOT / "scenes" / f"{name}.toml"


def read_exr(path):
    import sys

    sys.path.insert(0, str(ROOT / "tests/validation"))
    import mitsuba_setup  # noqa: F401
    import mitsuba as mi

    return np.array(mi.Bitmap(str(path)).convert(mi.Bitmap.PixelFormat.RGB), dtype=np.float64)


def processor():
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":")[1].strip()
    return platform.processor()


def print_table(scene, spp_rows):
    print(f"\n{scene}:\n")
    print("| spp | program | s | process s | relMSE | efficiency | to Mitsuba's best | Mpath/s |")
    print("|---|---|---|---|---|---|---|---|")
    for spp, rows in spp_rows:
        best = max(row.efficiency for row in rows if row.name.startswith("Mitsuba"))
        for r in rows:
            process = "" if r.process_seconds is None else f"{r.process_seconds:.2f}"
            print(f"| {spp} | {r.name} | {r.seconds:.2f} | {process} | {r.error:.2e} | "
                  f"{r.efficiency:.3g} | {r.efficiency / best:.2f} | {r.speed:.2f} |", flush=True)


def main():
    arguments = parse_arguments()
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(arguments, folder)
        ours = subprocess.run([arguments.program, "--version"], check=True, capture_output=True,
                              text=True).stdout.splitlines()[0]
        print(f"{datetime.date.today()}, {processor()}, {arguments.threads} threads, "
              f"{arguments.size}x{arguments.size} pixels; {ours}; "
              f"Mitsuba {bench.mitsuba['llvm_ad_rgb'].version()}")
        for scene in arguments.scenes:
            print_table(scene, [(spp, bench.measure(scene, spp)) for spp in arguments.spp])


if __name__ == "__main__":
    main()
