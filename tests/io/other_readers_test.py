#!/usr/bin/env python3
"""Reads images that the program writes by other libraries: OpenEXR, Pillow, tifffile.

Usage: other_readers_test.py PROGRAM SCENE

Each library that is not installed is left out and named; the exit code is 77 when there is none.
"""
import importlib
import os
import pathlib
import subprocess
import sys
import tempfile


def library(name):
    try:
        return importlib.import_module(name)
    except ImportError:
        print(f"without {name}, which is not installed")
        return None


def decode_hdr(numpy, data):
    """Decodes a Radiance picture whose rows are run-length encoded by channel."""
    header, _, rest = data.partition(b"\n\n")
    assert header.startswith(b"#?RADIANCE") or header.startswith(b"#?RGBE"), header
    size, _, rest = rest.partition(b"\n")
    height, width = int(size.split()[1]), int(size.split()[3])
    rgbe = numpy.zeros((height, 4, width), numpy.uint8)
    at = 0
    for y in range(height):
        assert rest[at:at + 2] == b"\2\2" and rest[at + 2] * 256 + rest[at + 3] == width
        at += 4
        for channel in range(4):
            row = bytearray()
            while len(row) < width:
                count = rest[at]
                run = count > 128
                row += rest[at + 1:at + 2] * (count - 128) if run else rest[at + 1:at + 1 + count]
                at += 2 if run else 1 + count
            rgbe[y, channel] = numpy.frombuffer(bytes(row), numpy.uint8)
    scale = numpy.ldexp(1.0, rgbe[:, 3].astype(int) - 136)
    return ((rgbe[:, :3] + 0.5 * (rgbe[:, :3] > 0)) * scale[:, None]).transpose(0, 2, 1)


def srgb_codes(numpy, linear):
    """The 8-bit codes of IEC 61966-2-1 before rounding."""
    v = numpy.clip(linear.astype(float), 0, 1)
    return 255 * numpy.where(v <= 0.0031308, 12.92 * v, 1.055 * v ** (1 / 2.4) - 0.055)


def check(name, good):
    print(f"{name}: {'good' if good else 'DIFFERS'}")
    return good


def check_eight_bits(numpy, image, folder, codes):
    """PNG and TIFF hold the rounded codes and the facts; JPEG is near them."""
    results = []
    for name in ("a.png", "a.tif", "a.jpg", "a.bmp", "a.ppm", "a.tga", "a.sgi"):
        picture = image.open(folder / name)
        values = numpy.asarray(picture.convert("RGB")).astype(float)
        most = numpy.abs(values - codes).max()
        mean = numpy.abs(values - codes).mean()
        results.append(check(name, mean < 5 if name == "a.jpg" else most < 0.501))
    text = image.open(folder / "a.png").text
    results.append(check("texts of a.png", text.get("spp") == "2" and "scene_hash" in text))
    description = image.open(folder / "a.tif").tag_v2[270]
    results.append(check("description of a.tif", "spp: 2\n" in description))
    return results


def main(program, scene):
    numpy = library("numpy")
    exr, image = library("OpenEXR"), library("PIL.Image")
    # Without imagecodecs, tifffile does not know the predictor of floats.
    tifffile = library("imagecodecs") and library("tifffile")
    if numpy is None or exr is None or not hasattr(exr, "File"):
        print("OpenEXR 3.3 or newer and numpy are needed")
        return 77
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        size = ["--width", "40", "--height", "30", "--spp", "2", "--quiet"]
        outputs = [a for e in ("exr", "png", "tif", "jpg", "hdr", "bmp", "ppm", "tga", "sgi")
                   for a in ("-o", folder / f"a.{e}")]
        subprocess.run([program, scene, *size, *outputs, "--layers", "variance,depth"], check=True,
                       stdout=subprocess.DEVNULL)
        subprocess.run([program, scene, *size, "--float", "-o", folder / "f.tif"], check=True,
                       stdout=subprocess.DEVNULL)
        file = exr.File(str(folder / "a.exr"), separate_channels=True)
        channels = file.channels()
        rgb = numpy.stack([channels[c].pixels for c in "RGB"], axis=-1)
        results = [check("channels of a.exr", set(channels) == {
            "R", "G", "B", "variance.R", "variance.G", "variance.B", "depth.Z"}),
            check("facts of a.exr", file.header()["spp"] == 2)]
        hdr = decode_hdr(numpy, (folder / "a.hdr").read_bytes())
        error = numpy.abs(hdr - rgb).max(axis=-1) / rgb.max(axis=-1).clip(1e-9)
        results.append(check("a.hdr", error.max() < 1 / 127))
        if image is not None:
            results += check_eight_bits(numpy, image, folder, srgb_codes(numpy, rgb))
        if tifffile is not None:
            results.append(check("f.tif", numpy.array_equal(tifffile.imread(folder / "f.tif"), rgb)))
        return 0 if all(results) else 1


if __name__ == "__main__":
    sys.exit(main(os.path.abspath(sys.argv[1]), sys.argv[2]))
