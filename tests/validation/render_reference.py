"""Makes the stored references of tests/render/mitsuba_slow_test.cpp anew, with Mitsuba 3.

    python3 tests/validation/render_reference.py        # takes some minutes

Needs the packages mitsuba (and with it numpy) and the library libLLVM. For each validated scene,
direct light only and all bounces: tests/data/mitsuba/<scene>_<kind>.exr, float32, 48 x 48. R, G, B
are means of 16384 samples per pixel; variance.R, .G and .B are the variances of these means, from
256 passes of 64 stratified samples. The header tells the version of Mitsuba: the stored ones are by
3.9.1. The means of the pictures are known to .013 % (one standard deviation). Make them anew only
when a scene is meant to change.
"""

import pathlib

import mitsuba_render
import mitsuba as mi
import numpy as np
import picture
from scene_reader import read_scene

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENES = ["cornell", "glossy", "sphere_r0.4", "sphere_r0.8", "teapot_diffuse", "teapot_metal"]
KINDS = {"direct": 1, "all": None}  # --max-depth
SIZE, SPP, PASSES, SEED = 48, 64, 256, 1


def main():
    folder = ROOT / "tests/data/mitsuba"
    folder.mkdir(exist_ok=True)
    for name in SCENES:
        scene = read_scene(ROOT / "scenes" / f"{name}.toml")
        for kind, max_depth in KINDS.items():
            mean, variance = mitsuba_render.render(scene, SIZE, max_depth, SPP, PASSES, SEED)
            header = {
                "software": f"Mitsuba {mi.__version__} with a height-correlated GGX plugin",
                "scene": f"scenes/{name}.toml",
                "max_depth": "unlimited" if max_depth is None else str(max_depth),
                "spp": str(SPP * PASSES),
                "replicates": str(PASSES),
                "sampler": "multijitter",
                "seed": str(SEED),
            }
            picture.write(folder / f"{name}_{kind}.exr", mean, variance, header)
            error = np.sqrt(variance.sum((0, 1))) / mean.sum((0, 1))
            print(f"{name} {kind}: mean {mean.mean((0, 1))} +- {100 * error} %", flush=True)


if __name__ == "__main__":
    main()
