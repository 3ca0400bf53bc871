"""Error, bias and time of pictures denoised by Open Image Denoise, beside pictures that are not.

    python3 tests/validation/denoise.py check --program build/Raytracing
    python3 tests/validation/denoise.py study --program build/Raytracing --out images/denoise
        [--scenes cornell ...] [--size 128] [--seeds 6] [--longest 16] [--reference-spp 512]
    python3 tests/validation/denoise.py report --out images/denoise

`check` renders the Cornell Box and checks the layers for denoisers and what denoising does to the
error. Exit code 0 where all holds; 1 where it does not; 77 where a package is missing.

`study` renders scenes at 1, 2, 4 ... 1024 spp with and without shared paths, leaves out what would
take more than --longest seconds, denoises each picture, and writes <scene>.csv, anew after each
seed. Above 64 spp it takes half as many seeds. `report` makes the tables and the chart from these
files; `study` ends with it. strip.png shows the Cornell Box at 4 spp.

Needs the PyPI packages pyoidn, OpenEXR and numpy; the study also pillow, and gnuplot.
"""

import argparse
import pathlib
import statistics
import sys
import tempfile

SCENES = ["cornell", "cornell_penumbra", "glossy"]
REUSES = [1, 16]
SPPS = [2**i for i in range(11)]
FEW_SEEDS_ABOVE = 64  # spp
STRIP_SPP = 4


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    commands = parser.add_subparsers(dest="command", required=True)
    check, study, report = (commands.add_parser(n) for n in ("check", "study", "report"))
    for command, size, seeds in ((check, 64, 4), (study, 128, 6)):
        command.add_argument("--program", required=True)
        command.add_argument("--size", type=int, default=size)
        command.add_argument("--seeds", type=int, default=seeds)
    study.add_argument("--scenes", nargs="+", default=SCENES)
    study.add_argument("--longest", type=float, default=16)
    study.add_argument("--reference-spp", type=int, default=512, help="of each of two halves")
    for command in (study, report):
        command.add_argument("--out", type=pathlib.Path, required=True)
    return parser.parse_args()


class Study:
    """All pictures of one scene, by (reuse, spp, mode); the mode "plain" is not denoised."""

    def __init__(self, arguments, scene, denoiser, folder):
        self.arguments, self.scene = arguments, scene
        self.denoiser, self.folder = denoiser, folder
        self.pictures, self.seconds, self.wall = {}, {}, {}

    def _run(self, reuse, spp, seed):
        """Renders and denoises at once, so that both meet the same state of the machine."""
        import denoising as d

        picture = d.render(self.arguments.program, self.scene, self.arguments.size, spp, reuse,
                           seed, self.folder)
        self._add((reuse, spp, "plain"), picture.colour, picture.cpu_seconds)
        self.wall.setdefault((reuse, spp), []).append(picture.render_seconds)
        for mode in d.MODES:
            self._add((reuse, spp, mode), *self.denoiser(picture, mode))
        return picture.cpu_seconds

    def _add(self, key, colour, seconds):
        self.pictures.setdefault(key, []).append(colour)
        self.seconds.setdefault(key, []).append(seconds)

    def run(self, after_seed):
        too_long = dict.fromkeys(REUSES, SPPS[-1] + 1)
        for seed in range(1, self.arguments.seeds + 1):
            for spp in SPPS:
                if spp > FEW_SEEDS_ABOVE and seed > self.arguments.seeds // 2:
                    continue
                for reuse in (r for r in REUSES if spp < too_long[r]):
                    seconds = self._run(reuse, spp, seed)
                    if seed == 1 and 2 * seconds > self.arguments.longest:
                        too_long[reuse] = 2 * spp
            print(f"{self.scene}: seed {seed} of {self.arguments.seeds} done", flush=True)
            if seed > 1:  # One seed has no variance.
                after_seed()

    def rows(self, reference):
        import denoising as d

        for (reuse, spp, mode), pictures in sorted(self.pictures.items()):
            yield {"scene": self.scene, "reuse": reuse, "spp": spp, "mode": mode,
                   "seeds": len(pictures),
                   "render_cpu_seconds": statistics.median(self.seconds[reuse, spp, "plain"]),
                   "render_wall_seconds": statistics.median(self.wall[reuse, spp]),
                   "denoise_cpu_seconds": (0 if mode == "plain" else
                                           statistics.median(self.seconds[reuse, spp, mode])),
                   **vars(d.measure(pictures, reference)),
                   "reference_error": reference.own_error()}


def run_study(arguments):
    import denoise_report
    import denoising as d

    arguments.out.mkdir(parents=True, exist_ok=True)
    denoiser = d.Denoiser()
    with tempfile.TemporaryDirectory() as folder:
        for scene in arguments.scenes:
            reference = d.make_reference(arguments.program, scene, arguments.size,
                                         arguments.reference_spp, folder)
            print(f"{scene}: reference, relMSE {reference.own_error():.2g}", flush=True)
            study = Study(arguments, scene, denoiser, folder)
            table = arguments.out / f"{scene}.csv"
            study.run(lambda: denoise_report.write_csv(table, study.rows(reference)))
            if scene == "cornell":
                pairs = [[study.pictures[reuse, STRIP_SPP, mode][0] for mode in ("plain", "clean")]
                         for reuse in REUSES]
                denoise_report.write_strip(arguments.out / "strip.png", pairs, reference)
    denoise_report.write_machine(arguments, denoiser.version())
    denoise_report.write_report(arguments.out)


def main():
    arguments = parse_arguments()
    if arguments.command == "report":
        import denoise_report

        denoise_report.write_report(arguments.out)
        return 0
    try:
        import denoising  # noqa: F401
    except (ImportError, OSError) as error:  # no package, or a package without its library
        print(f"skipped: {error}")
        return 77
    if arguments.command == "study":
        run_study(arguments)
        return 0
    import denoise_check

    return 0 if denoise_check.run(arguments) else 1


if __name__ == "__main__":
    sys.exit(main())
