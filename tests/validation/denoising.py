"""Pictures of the program, their denoising by Open Image Denoise, and errors over seeds.

Needs the PyPI packages pyoidn, OpenEXR and numpy.
"""

import pathlib
import statistics
import subprocess
import time
from dataclasses import dataclass

import numpy as np
import OpenEXR
import pyoidn

ROOT = pathlib.Path(__file__).resolve().parents[2]
EPSILON = 0.01  # of relMSE, as in `Raytracing compare`
BLOCK = 8  # pixels
REFERENCE_SEEDS = (100_000, 100_001)
MODES = ["clean", "noisy", "none"]  # cleanAux set; not set; no albedo and normal


@dataclass
class Picture:
    """Linear channels, float32, (height, width, 3) each, and the seconds of one thread."""

    colour: np.ndarray
    albedo: np.ndarray
    normal: np.ndarray
    cpu_seconds: float
    render_seconds: float


def render(program, scene, size, spp, reuse, seed, folder):
    """One thread, so that the seconds of the processor are those of the wall of an idle machine."""
    path = pathlib.Path(folder) / "render.exr"
    command = [program, str(ROOT / "scenes" / f"{scene}.toml"), "--quiet", "--threads", "1",
               "--width", str(size), "--height", str(size), "--spp", str(spp),
               "--reuse", str(reuse), "--seed", str(seed), "--layers", "albedo,normal",
               "--output", str(path)]
    subprocess.run(command, check=True)
    file = OpenEXR.File(str(path), separate_channels=True)
    channels, facts = file.channels(), file.header()

    def layer(names):
        planes = [channels[name].pixels for name in names]
        return np.ascontiguousarray(np.stack(planes, axis=2), dtype=np.float32)

    return Picture(layer(["R", "G", "B"]), layer(["albedo.R", "albedo.G", "albedo.B"]),
                   layer(["normal.X", "normal.Y", "normal.Z"]),
                   float(facts["cpu_seconds"][0]), float(facts["render_seconds"][0]))


class Denoiser:
    """Open Image Denoise on one thread of the processor."""

    def __init__(self):
        self.device = pyoidn.Device()
        self.device.set_int("numThreads", 1)
        self.device.set_bool("setAffinity", False)
        self.device.commit()
        self._check()
        # Loading the weights is a cost of the start, as building the scene is of a render.
        grey = np.full((128, 128, 3), 0.5, dtype=np.float32)
        for mode in MODES:
            self(Picture(grey, grey, grey, 0, 0), mode)

    def __call__(self, picture, mode):
        """The denoised colours and the processor's seconds of committing and executing."""
        result = np.zeros_like(picture.colour)
        with pyoidn.Filter(self.device, pyoidn.OIDN_FILTER_TYPE_RT) as oidn:
            images = {pyoidn.OIDN_IMAGE_COLOR: picture.colour, pyoidn.OIDN_IMAGE_OUTPUT: result}
            if mode != "none":
                images[pyoidn.OIDN_IMAGE_ALBEDO] = picture.albedo
                images[pyoidn.OIDN_IMAGE_NORMAL] = picture.normal
            for name, image in images.items():
                oidn.set_image(name, image, pyoidn.OIDN_FORMAT_FLOAT3)
            oidn.set_bool("hdr", True)
            oidn.set_bool("cleanAux", mode == "clean")
            start = time.process_time()
            oidn.commit()
            oidn.execute()
            seconds = time.process_time() - start
        self._check()
        return result, seconds

    def version(self):
        number = self.device.get_int("version")
        return f"{number // 10000}.{number // 100 % 100}.{number % 100}"

    def _check(self):
        error = self.device.get_error()
        if error is not None:
            raise RuntimeError(f"Open Image Denoise: {error}")


class Reference:
    """Two independent halves. Products of the differences to one and to the other hold no error of
    the reference, on average."""

    def __init__(self, halves):
        self.halves = [np.asarray(half, dtype=np.float64) for half in halves]
        self.mean = (self.halves[0] + self.halves[1]) / 2
        self.weight = 1 / (self.mean**2 + EPSILON)

    def own_error(self):
        """relMSE of the mean of the halves."""
        return ((self.halves[0] - self.halves[1]) ** 2 / 4 * self.weight).mean()

    def squares(self, picture):
        """An estimate of (picture - truth)^2 in each pixel."""
        return (picture - self.halves[0]) * (picture - self.halves[1])

    def error(self, picture):
        """relMSE."""
        return (self.squares(picture) * self.weight).mean()

    def of_blocks(self):
        """The same for means of blocks."""
        return Reference([block_means(half) for half in self.halves])


def make_reference(program, scene, size, spp, folder):
    """By shared paths, which converge fastest; they are as unbiased as unshared ones."""
    return Reference([render(program, scene, size, spp, 16, seed, folder).colour
                      for seed in REFERENCE_SEEDS])


def block_means(picture):
    height, width, channels = picture.shape
    shape = (height // BLOCK, BLOCK, width // BLOCK, BLOCK, channels)
    return picture.reshape(shape).mean((1, 3))


@dataclass
class Errors:
    """Means over seeds; error = variance + bias."""

    error: float
    error_deviation: float  # standard error of the mean over the seeds
    variance: float
    bias: float  # squared, less the variance of the mean that it is taken from
    bias_deviation: float  # by the jackknife over the seeds
    block_error: float  # of means over blocks


def squared_bias(pictures, reference):
    mean, variance = pictures.mean(0), pictures.var(0, ddof=1)
    squares = reference.squares(mean) - variance / len(pictures)
    return (squares * reference.weight).mean()


def measure(pictures, reference):
    """Errors of pictures that differ only by their seeds."""
    pictures = np.asarray(pictures, dtype=np.float64)
    n = len(pictures)
    errors = [reference.error(picture) for picture in pictures]
    parts = [squared_bias(np.delete(pictures, i, axis=0), reference) for i in range(n)]
    blocks = reference.of_blocks()
    return Errors(
        statistics.mean(errors), statistics.stdev(errors) / n**0.5,
        (pictures.var(0, ddof=1) * reference.weight).mean(), squared_bias(pictures, reference),
        ((n - 1) / n * sum((p - statistics.mean(parts)) ** 2 for p in parts)) ** 0.5,
        statistics.mean(blocks.error(block_means(picture)) for picture in pictures))
