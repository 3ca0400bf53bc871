"""Mitsuba 3 in a process of its own, since a process knows one variant only."""

import multiprocessing
import os
import pathlib
import sys
import time

VALIDATION = pathlib.Path(__file__).resolve().parents[1] / "validation"


class MitsubaProcess:
    """Renders on request, with the variant and the number of threads given."""

    def __init__(self, variant, threads):
        context = multiprocessing.get_context("spawn")
        self._pipe, theirs = context.Pipe()
        self._process = context.Process(target=_serve, args=(theirs, variant, threads), daemon=True)
        self._process.start()

    def version(self):
        return self._ask("version")

    def render(self, scene_path, size, settings, spp, seed):
        """Seconds of rendering alone, and the picture. `settings`: keywords of Settings."""
        return self._ask("render", str(scene_path), size, settings, spp, seed)

    def reference(self, scene_path, size, settings, spp, passes, seed):
        """Mean, and variance of the mean, of independent passes."""
        return self._ask("reference", str(scene_path), size, settings, spp, passes, seed)

    def _ask(self, *request):
        self._pipe.send(request)
        return self._pipe.recv()


def _serve(pipe, variant, threads):
    os.environ["RAYTRACING_MITSUBA_VARIANT"] = variant
    sys.path.insert(0, str(VALIDATION))
    import mitsuba_render  # chooses the variant

    import drjit as dr
    import mitsuba as mi
    import numpy as np
    from scene_reader import read_scene

    dr.set_thread_count(threads)
    scenes = {}

    def built(path, size, settings):
        key = (path, size, tuple(sorted(settings.items())))
        if key not in scenes:
            scenes[key] = mitsuba_render.build(read_scene(path), size, None,
                                               mitsuba_render.Settings(**settings))
        return scenes[key]

    def render(path, size, settings, spp, seed):
        scene = built(path, size, settings)
        if not variant.startswith("scalar"):  # compile the kernels: multijitter's hold the seed
            np.array(mi.render(scene, spp=spp, seed=seed))
        start = time.perf_counter()
        image = np.array(mi.render(scene, spp=spp, seed=seed))  # waits for the end
        return time.perf_counter() - start, image.astype(np.float64)

    def reference(path, size, settings, spp, passes, seed):
        return mitsuba_render.render(read_scene(path), size, None, spp, passes, seed,
                                     mitsuba_render.Settings(**settings))

    answers = {"version": lambda: mi.__version__, "render": render, "reference": reference}
    while True:
        try:
            name, *arguments = pipe.recv()
        except EOFError:
            return
        pipe.send(answers[name](*arguments))
