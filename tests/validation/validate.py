"""Renders the validated scenes with our program and with Mitsuba 3 and compares the pictures.

    python3 tests/validation/validate.py --program build/Raytracing [--scenes cornell ...]
        [--size 64] [--spp 512] [--light-sampling METHOD]

Prints, for direct light only and for all bounces, the ratio of the means of R, G and B with its
95 % interval: of the whole picture and of the pixels that do not show the light. Of the latter,
also the shares of z beyond 1.96 and 3. Variances come from 16 replicates, so 6 % and .5 % are
expected (Student's t with about 30 degrees of freedom).

Exit code 0 where all pictures agree; 1 where one does not: a p-value of the means or of the
chi-square of blocks of 8 x 8 pixels is so small that agreeing renderers would show one in 1000 runs
of this program (Sidak's correction); 77 where Mitsuba cannot be used.
"""

import argparse
import pathlib
import subprocess
import sys
import tempfile

REPLICATES = 16
MITSUBA_SPP = 64  # of each replicate; a square, for its stratified samples


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", required=True)
    parser.add_argument("--scenes", nargs="*")
    parser.add_argument("--size", type=int, default=64)
    parser.add_argument("--spp", type=int, default=512)
    parser.add_argument("--light-sampling", default="solid-angle")
    return parser.parse_args()


def render_ours(arguments, scene_path, max_depth, folder):
    """Mean and variance of our program, from replicates of Sobol' samples."""
    import picture

    path = pathlib.Path(folder) / "ours.exr"
    command = [arguments.program, str(scene_path), "--quiet", "--variance", "--output", str(path),
               "--width", str(arguments.size), "--height", str(arguments.size),
               "--spp", str(arguments.spp), "--replicates", str(REPLICATES), "--seed", "1",
               # The intervals of means take the pixels as independent.
               "--reuse", "1", "--light-sampling", arguments.light_sampling]
    if max_depth is not None:
        command += ["--max-depth", str(max_depth)]
    subprocess.run(command, check=True)
    mean, variance, _ = picture.read(path)
    return mean, variance


def describe(means):
    """Ratios with their 95 % intervals."""
    pairs = zip(means.ratio, 1.96 * means.deviation)
    return " ".join(f"{ratio:.5f}+-{width:.5f}" for ratio, width in pairs)


def agree(name, ours, theirs, level):
    """Prints a line; whether no p-value is below the level."""
    import comparison as c
    import numpy as np

    whole = c.compare_means(ours, theirs)
    ours, theirs = c.without_light(ours, theirs), c.without_light(theirs, theirs)
    rest = c.compare_means(ours, theirs)
    z = np.abs(c.pixel_z(ours, theirs))
    p = min(whole.p_values() + rest.p_values() + c.block_p_values(ours, theirs))
    print(f"{name}: {'agree' if p >= level else 'DIFFER'}, least p {p:.2g}\n"
          f"  means {describe(whole)}\n  without the light {describe(rest)}\n"
          f"  pixels beyond 1.96: {100 * (z > 1.96).mean():.2f} %, beyond 3: "
          f"{100 * (z > 3).mean():.2f} %", flush=True)
    return p >= level


def validate(arguments, folder):
    """Whether all pictures agree."""
    import mitsuba_render
    from render_reference import KINDS, ROOT, SCENES
    from scene_reader import read_scene

    names = arguments.scenes or SCENES
    tests = len(names) * len(KINDS) * 9
    level = 1 - (1 - 1e-3) ** (1 / tests)
    results = []
    for name in names:
        path = ROOT / "scenes" / f"{name}.toml"
        for kind, max_depth in KINDS.items():
            ours = render_ours(arguments, path, max_depth, folder)
            theirs = mitsuba_render.render(read_scene(path), arguments.size, max_depth,
                                           spp=MITSUBA_SPP, passes=REPLICATES, seed=1000)
            results.append(agree(f"{name} {kind}", ours, theirs, level))
    return all(results)


def main():
    arguments = parse_arguments()
    try:
        import ggx_correlated
    except ImportError as error:
        print(f"skipped: {error}")
        return 77
    ggx_correlated.check()
    with tempfile.TemporaryDirectory() as folder:
        return 0 if validate(arguments, folder) else 1


if __name__ == "__main__":
    sys.exit(main())
