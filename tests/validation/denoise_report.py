"""Table, chart and strip of pictures of the study denoise.py, from its CSV files."""

import csv
import datetime
import importlib.metadata
import math
import pathlib
import subprocess

SCENES = ["cornell", "cornell_penumbra", "glossy"]
MODES = ["clean", "noisy", "none"]
DECADES = (-5, 0)  # of the error maps: black and white


def write_csv(path, rows):
    rows = list(rows)
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, rows[0], delimiter=";", lineterminator="\n")
        writer.writeheader()
        for row in rows:
            writer.writerow({k: f"{v:.4g}" if isinstance(v, float) else v for k, v in row.items()})


def read_csv(path):
    """Rows by (reuse, spp, mode), numbers as floats."""
    texts = ("scene", "mode")
    with open(path, newline="") as file:
        rows = [{k: v if k in texts else float(v) for k, v in row.items()}
                for row in csv.DictReader(file, delimiter=";")]
    return {(int(r["reuse"]), int(r["spp"]), r["mode"]): r for r in rows}


def processor():
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":")[1].strip()
    return "unknown processor"


def write_machine(arguments, oidn_version):
    version = subprocess.run([arguments.program, "--version"], check=True, capture_output=True,
                             text=True).stdout.splitlines()[0]
    text = (f"{datetime.date.today()}, {processor()}, one thread, seconds of the processor, "
            f"{arguments.size}x{arguments.size} pixels; {version}; Open Image Denoise "
            f"{oidn_version} (pyoidn {importlib.metadata.version('pyoidn')}).")
    (arguments.out / "machine.txt").write_text(text + "\n")


def seconds(row):
    return row["render_cpu_seconds"] + row["denoise_cpu_seconds"]


def error_at(rows, time):
    """The error of undenoised `rows` at a time, by lines in the logarithms; beyond the ends the
    first or last line goes on."""
    points = [(math.log(seconds(row)), math.log(row["error"])) for row in rows]
    x = math.log(time)
    i = next((i for i in range(1, len(points) - 1) if x < points[i][0]), len(points) - 1)
    (x0, y0), (x1, y1) = points[i - 1], points[i]
    return math.exp(y0 + (y1 - y0) * (x - x0) / (x1 - x0))


def curve(rows, reuse, mode):
    return [row for (r, _, m), row in sorted(rows.items()) if r == reuse and m == mode]


def ratios(rows, reuse, mode, against=None):
    """Error of the denoised pictures, relative to undenoised ones of the same time, which share as
    many paths or as many as `against` says."""
    plain = curve(rows, against or reuse, "plain")
    return [row["error"] / error_at(plain, seconds(row)) for row in curve(rows, reuse, mode)]


def crossing(rows, reuse, mode, against=None):
    """Where denoising loses: samples, and seconds of rendering and denoising."""
    values, points = ratios(rows, reuse, mode, against), curve(rows, reuse, mode)
    wins = [i for i, value in enumerate(values) if value < 1]
    if not wins:
        return "everywhere"
    last_win = wins[-1]
    below = f", and below {points[wins[0]]['spp']:.0f}" if wins[0] > 0 else ""
    if last_win == len(values) - 1:
        return f"nowhere up to {points[-1]['spp']:.0f} spp ({values[-1]:.2f} there){below}"
    low, high = math.log(values[last_win]), math.log(values[last_win + 1])
    share = -low / (high - low)
    a, b = points[last_win], points[last_win + 1]

    def between(x, y):
        return math.exp(math.log(x) + share * math.log(y / x))

    return (f"from {between(a['spp'], b['spp']):.0f} spp, {between(seconds(a), seconds(b)):.2g} s, "
            f"on{below}")


def table(rows, reuse):
    yield ("| spp | render s | denoise s | relMSE plain | denoised | variance | squared bias "
           "| at equal time | blocks plain | denoised |")
    yield "|---|---|---|---|---|---|---|---|---|---|"
    plain, denoised = curve(rows, reuse, "plain"), curve(rows, reuse, "clean")
    for p, d, ratio in zip(plain, denoised, ratios(rows, reuse, "clean")):
        yield (f"| {p['spp']:.0f} | {p['render_cpu_seconds']:.3g} "
               f"| {d['denoise_cpu_seconds']:.3f} | {p['error']:.2e} | {d['error']:.2e} "
               f"| {d['variance']:.1e} | {d['bias']:.1e} ± {d['bias_deviation']:.0e} "
               f"| {ratio:.2f} | {p['block_error']:.1e} | {d['block_error']:.1e} |")


def summary(scenes):
    """Where denoising loses, for each scene, reuse and mode."""
    yield ("| scene | `--reuse` | `cleanAux` | without `cleanAux` | colours only "
           "| `cleanAux`, against undenoised `--reuse 16` |")
    yield "|---|---|---|---|---|---|"
    for name, rows in scenes.items():
        for reuse in sorted({key[0] for key in rows}):
            cells = [crossing(rows, reuse, mode) for mode in MODES]
            cells.append(crossing(rows, reuse, "clean", against=16))
            yield f"| {name} | {reuse} | {' | '.join(cells)} |"


def modes(scenes, spps=(1, 4, 16, 64, 256)):
    """relMSE of the three modes."""
    yield f"| scene | `--reuse` | {' | '.join(f'{spp} spp' for spp in spps)} |"
    yield "|---" * (len(spps) + 2) + "|"
    for name, rows in scenes.items():
        for reuse in sorted({key[0] for key in rows}):
            cells = [", ".join(f"{rows[reuse, spp, mode]['error']:.1e}" for mode in MODES)
                     if (reuse, spp, "clean") in rows else "" for spp in spps]
            yield f"| {name} | {reuse} | {' | '.join(cells)} |"


def check_of_plain(scenes):
    """How far from 0 the squared bias of undenoised pictures was measured; they have none."""
    plain = [row for rows in scenes.values() for key, row in rows.items() if key[2] == "plain"]
    zs = [abs(row["bias"]) / row["bias_deviation"] for row in plain]
    return (f"The squared bias of undenoised pictures, which have none, is more than two standard "
            f"errors from 0 in {sum(z > 2 for z in zs)} of {len(zs)} cases, and {max(zs):.1f} at "
            f"most. Student's t, with as many degrees of freedom as seeds but one, has heavy tails. "
            f"The error of the reference, common to all rows of a scene, is not in the ±.")


def write_report(out):
    """denoise.md and denoise.png."""
    names = [name for name in SCENES if (out / f"{name}.csv").exists()]
    scenes = {name: read_csv(out / f"{name}.csv") for name in names}
    lines = ["# Denoising", "", (out / "machine.txt").read_text().strip(), "",
             "Where the denoised picture has the larger relMSE at equal time (in parentheses: its "
             "relMSE, relative to that of the undenoised one):", "", *summary(scenes), "",
             "relMSE with `cleanAux`, with albedo and normal but without it, with colours only:",
             "", *modes(scenes), "", check_of_plain(scenes)]
    for name, rows in scenes.items():
        own = next(iter(rows.values()))["reference_error"]
        for reuse in sorted({key[0] for key in rows}):
            lines += ["", f"## {name}, `--reuse {reuse}`", "",
                      f"The reference has a relMSE of {own:.1e}, which is subtracted.", "",
                      *table(rows, reuse)]
    (out / "denoise.md").write_text("\n".join(lines) + "\n")
    script = pathlib.Path(__file__).with_suffix(".gp").resolve()
    subprocess.run(["gnuplot", "-e", f"scenes = '{' '.join(names)}'", str(script)], check=True,
                   cwd=out)


def write_strip(path, pairs, reference):
    """A row for each pair (undenoised, denoised): both, their error maps, the reference."""
    import numpy as np
    from PIL import Image

    def display(linear):
        x = np.clip(linear, 0, 1)
        return np.where(x <= 0.0031308, 12.92 * x, 1.055 * x ** (1 / 2.4) - 0.055)

    def error_map(picture):
        error = ((picture - reference.mean) ** 2 * reference.weight).mean(2, keepdims=True)
        decades = np.log10(np.maximum(error, 1e-30))
        grey = np.clip((decades - DECADES[0]) / (DECADES[1] - DECADES[0]), 0, 1)
        return np.repeat(grey, 3, axis=2)

    rows = []
    for pair in pairs:
        tiles = [*map(display, pair), *map(error_map, pair), display(reference.mean)]
        rows.append(np.concatenate([np.pad(t, ((2, 2), (2, 2), (0, 0)), constant_values=1)
                                    for t in tiles], axis=1))
    values = np.round(255 * np.concatenate(rows)).astype(np.uint8)
    Image.fromarray(values).save(path, optimize=True)
