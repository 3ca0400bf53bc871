"""Float EXR files with the channels R, G, B and variance.R, variance.G, variance.B."""

import mitsuba_setup  # noqa: F401  (chooses the variant)

import mitsuba as mi
import numpy as np

CHANNELS = ["R", "G", "B", "variance.R", "variance.G", "variance.B"]


def write(path, mean, variance, header):
    """`header`: names and texts."""
    values = np.concatenate([mean, variance], axis=2).astype(np.float32)
    bitmap = mi.Bitmap(values, mi.Bitmap.PixelFormat.MultiChannel, channel_names=CHANNELS)
    for name, text in header.items():
        bitmap.metadata()[name] = text
    bitmap.write(str(path))


def read(path):
    """Mean, variance of the mean, both (height, width, 3) in double precision, and the header."""
    bitmap = mi.Bitmap(str(path))
    names = [field.name for field in bitmap.struct_()]
    values = np.array(bitmap, dtype=np.float64)
    ordered = values[..., [names.index(channel) for channel in CHANNELS]]
    return ordered[..., :3], ordered[..., 3:], bitmap.metadata()
