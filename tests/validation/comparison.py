"""z-tests between two pictures whose means have known, independent errors."""

import math
from dataclasses import dataclass

import numpy as np

BLOCK = 8  # pixels
LIGHT_RADIANCE = 5.0  # the lights have 31 and more, all else less than 3


def normal_p_value(z):
    """Two-sided."""
    return math.erfc(abs(z) / math.sqrt(2))


def chi_square_p_value(statistic, degrees):
    """Upper tail, by the cube-root approximation of Wilson and Hilferty (1931)."""
    spread = 2 / (9 * degrees)
    z = ((statistic / degrees) ** (1 / 3) - (1 - spread)) / math.sqrt(spread)
    return math.erfc(z / math.sqrt(2)) / 2


@dataclass
class Means:
    """Ratio of the means of two pictures and its standard deviation, one for each channel."""

    ratio: np.ndarray
    deviation: np.ndarray

    def p_values(self):
        return [normal_p_value(z) for z in (self.ratio - 1) / self.deviation]


def compare_means(ours, theirs):
    """Of pairs (mean, variance of the mean), (height, width, 3) each."""
    expected = theirs[0].sum((0, 1))
    error = np.sqrt((ours[1] + theirs[1]).sum((0, 1)))
    return Means(ours[0].sum((0, 1)) / expected, error / expected)


def pixel_z(ours, theirs):
    """z of all pixels and channels; 0 where both pictures are black."""
    difference, variance = ours[0] - theirs[0], ours[1] + theirs[1]
    black = (difference == 0) & (variance == 0)
    return np.where(black, 0.0, difference / np.sqrt(np.where(black, 1.0, variance)))


def blocks(picture):
    """Sums over blocks of BLOCK x BLOCK pixels of the pair (mean, variance)."""

    def sums(values):
        height, width, channels = values.shape
        return values.reshape(height // BLOCK, BLOCK, width // BLOCK, BLOCK, channels).sum((1, 3))

    return sums(picture[0]), sums(picture[1])


def block_p_values(ours, theirs):
    """Of the chi-square of the blocks, one for each channel."""
    z = pixel_z(blocks(ours), blocks(theirs))
    return [chi_square_p_value((z[..., c] ** 2).sum(), (z[..., c] != 0).sum()) for c in range(3)]


def without_light(picture, reference):
    """The pair with black pixels where the reference shows the light or the edge of it.

    They are a hundred times brighter than the others, so that the noise of the edge alone would be
    that of the picture; and an edge gives few different values, which no z-test is made for."""
    light = np.pad(reference[0].max(2) > LIGHT_RADIANCE, 1)
    near = np.lib.stride_tricks.sliding_window_view(light, (3, 3)).any((2, 3))
    return tuple(np.where(near[..., None], 0.0, values) for values in picture)
