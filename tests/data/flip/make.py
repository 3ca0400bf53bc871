#!/usr/bin/env python3
"""Makes the pictures that tests/study/flip_test.cpp is judged by, in this folder:

    pip install flip-evaluator numpy pillow OpenEXR && python3 tests/data/flip/make.py

test.png and reference.png: edges, colours, gradients, noise and fireflies. flip.exr: the error map
of the package flip-evaluator (the authors' code) between them; its channels R, G and B hold the map
for 67, 30 and 120 pixels per degree. The package's version is in the header.
"""
import importlib.metadata
import os

import flip_evaluator
import numpy
import OpenEXR
from PIL import Image

WIDTH, HEIGHT = 56, 40
os.chdir(os.path.dirname(os.path.abspath(__file__)))

y, x = numpy.mgrid[0:HEIGHT, 0:WIDTH]
reference = numpy.stack([x / WIDTH, y / HEIGHT, 1 - x / WIDTH], axis=2)
reference[8:20, 10:30] = [0.9, 0.1, 0.1]  # edges of saturated colour
reference[25:37, 5:20] = [0.02, 0.03, 0.05]
reference[25:37, 35:50] = numpy.where((x // 2 + y // 2) % 2, 1.0, 0.0)[25:37, 35:50, None]
random = numpy.random.default_rng(1)
test = reference + random.normal(0, 0.04, reference.shape)
test[12, 40] = test[30, 12] = [1, 1, 1]  # fireflies
test[8:20, 28:31] = [0.9, 0.1, 0.1]  # an edge that moved
for name, picture in (("test.png", test), ("reference.png", reference)):
    codes = numpy.round(255 * numpy.clip(picture, 0, 1)).astype(numpy.uint8)
    Image.fromarray(codes).save(name)

maps = []
for ppd in (67.0, 30.0, 120.0):
    values, mean, _ = flip_evaluator.evaluate(
        "reference.png", "test.png", "LDR", applyMagma=False, parameters={"ppd": ppd})
    print(f"{ppd} pixels per degree: mean {mean}")
    maps.append(numpy.asarray(values, dtype=numpy.float32)[:, :, 0])
header = {
    "compression": OpenEXR.ZIP_COMPRESSION,
    "type": OpenEXR.scanlineimage,
    "software": "flip-evaluator " + importlib.metadata.version("flip-evaluator"),
}
with OpenEXR.File(header, {"RGB": numpy.stack(maps, axis=2)}) as file:
    file.write("flip.exr")
