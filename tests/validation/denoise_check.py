"""What denoise.py checks in the Cornell Box: the layers for denoisers, the gain at few samples, the
bias at many.

At few samples, unshared paths: the noise of the pixels is independent, as denoisers assume. At many
samples, shared paths: the picture is soon better than what the denoiser makes of it. There the two
are compared at equal samples; at equal time the undenoised picture would have more of them, so that
no time has to be measured.

At 64x64 with Open Image Denoise 2.5.1 and four seeds, denoising lowers relMSE 12.4 times at 4 spp,
raises it 1.57 times at 512 spp, and the squared bias is 28 of its standard errors. The thresholds
are far from that because other versions have other weights. The pictures of a seed are fixed, so
that nothing else changes from run to run.
"""

import tempfile

import denoising as d
import numpy as np

SCENE, FEW, MANY, REFERENCE = "cornell", 4, 512, 1024  # spp
LEAST_GAIN = 4
LEAST_LOSS = 1.2
LEAST_BIAS = 4  # standard errors
ROUNDING = 1e-5  # of means of float32


def said(text, holds):
    print(f"{'good' if holds else 'BAD '}  {text}", flush=True)
    return holds


def layers_are_in_range(picture):
    """Open Image Denoise documents 0 to 1 for albedo and -1 to 1 for normals, of any length."""
    length = np.linalg.norm(picture.normal.astype(np.float64), axis=2)
    return all([
        said(f"albedo from {picture.albedo.min():.4g} to {picture.albedo.max():.4g}",
             picture.albedo.min() >= 0 and picture.albedo.max() <= 1 + ROUNDING),
        said(f"longest normal {length.max():.7g}", length.max() <= 1 + ROUNDING),
        # Zeros everywhere would be in range too.
        said(f"normals of length 1: {100 * (length > 1 - ROUNDING).mean():.0f} %",
             (length > 1 - ROUNDING).mean() > 0.5),
    ])


def few_samples(arguments, denoiser, reference, folder):
    pictures = [d.render(arguments.program, SCENE, arguments.size, FEW, 1, seed, folder)
                for seed in range(1, arguments.seeds + 1)]
    plain = d.measure([p.colour for p in pictures], reference)
    denoised = d.measure([denoiser(p, "clean")[0] for p in pictures], reference)
    gain = plain.error / denoised.error
    return all([
        *[layers_are_in_range(p) for p in pictures[:1]],
        said(f"{FEW} spp, unshared: relMSE {plain.error:.3g}, denoised {denoised.error:.3g}, "
             f"{gain:.1f} times less (at least {LEAST_GAIN})", gain >= LEAST_GAIN)])


def many_samples(arguments, denoiser, reference, folder):
    pictures = [d.render(arguments.program, SCENE, arguments.size, MANY, 16, seed, folder)
                for seed in range(1, arguments.seeds + 1)]
    plain = d.measure([p.colour for p in pictures], reference)
    denoised = d.measure([denoiser(p, "clean")[0] for p in pictures], reference)
    loss, z = denoised.error / plain.error, denoised.bias / denoised.bias_deviation
    return all([
        layers_are_in_range(pictures[0]),
        said(f"{MANY} spp, shared: relMSE {plain.error:.3g}, denoised {denoised.error:.3g}, "
             f"{loss:.2f} times as much (at least {LEAST_LOSS})", loss >= LEAST_LOSS),
        said(f"squared bias {denoised.bias:.3g}, {z:.1f} standard errors (at least {LEAST_BIAS}); "
             f"undenoised {plain.bias:.2g} +- {plain.bias_deviation:.1g}", z >= LEAST_BIAS)])


def run(arguments):
    """Whether all holds."""
    denoiser = d.Denoiser()
    print(f"Open Image Denoise {denoiser.version()}, {arguments.size}x{arguments.size} pixels, "
          f"{arguments.seeds} seeds")
    with tempfile.TemporaryDirectory() as folder:
        reference = d.make_reference(arguments.program, SCENE, arguments.size, REFERENCE, folder)
        return all([check(arguments, denoiser, reference, folder)
                    for check in (few_samples, many_samples)])
