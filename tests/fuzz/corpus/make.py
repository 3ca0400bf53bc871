#!/usr/bin/env python3
"""Makes the seeds of the fuzzers, in this folder: python3 tests/fuzz/corpus/make.py

What the fuzzers found and was mended lies beside them as found-*; this does not touch it.
The EXR and TIFF pictures come from the packages OpenEXR, tifffile and numpy, the PNG pictures from
zlib alone.
"""
import os
import pathlib
import struct
import zlib

SQUARE = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
OBJ = {
    "bom": b"\xef\xbb\xbf" + SQUARE + b"f 1 2 3 4\n",
    "line-ends": SQUARE.replace(b"\n", b"\r\n") + b"f 1 2 3\rf 1\t3 4",
    "comments": SQUARE + b"f 1 2 3 # note\n# C:\\models\\\nf 1 3 4#note",
    "continued": SQUARE + b"f 1 2 \\\n 3 \\\r\n\\\r4\nl 1 \\\nv 9\n",
    "corners": SQUARE + b"vt 0 0\nvt 1 0\nvn 0 0 1\nf 1// 2// 3//\nf 1/1/1 2/2/0 3/1 4//1\n",
    "negative": SQUARE + b"vn 0 0 1\nf -4//-1 -3 -2\nf 1 2 -9\n",
    "index-0": SQUARE + b"f 1 2 0\n",
    "index-too-large": SQUARE + b"f 1 2 99999999999999999999\n",
    "forward": b"f 1//1 2 3//1\nf 2 3 4\n" + SQUARE + b"vn 0 0 0\n",
    "numbers": b"v +2 .5 1.E-1\nv -0 1e-60 1e38 .5\nv 1 2 3 .1 .2 .3\nv 1 2 3 4 5 6 7\n"
               b"vn 1e30 0 0\n",
    "overflow": b"v 0 1e39 0\n",
    "comma": b"v 1,5 0 0\n",
    "nan": b"v 0 nan inf\n",
    "truncated": b"v 0 0\n",
    "concave": b"v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\nf 1 2 3 4\n",
    "repeated": SQUARE + b"f 1 1 2 3\nf 1 2 2\nf 1 2 1 2\nf 1 2 3 1\n",
    "names": b"mtllib a b.mtl\nmtllib a.mtl c.MTL # two\nusemtl Dark wood\nusemtl Mat #25\nusemtl\n"
             b"g\no x\ns off\n" + SQUARE + b"f 1 2 3\n",
    "others": b"l 1 2\np 1\nvp 0 1\ncurv 1\nfoo\nV 1\nmtllib\n",
}
MTL = {
    "all": b"newmtl red\nKd 1 0.5 .25\nKs +.1 0 1.E-1\nKe 17 12 4\nNs 96.5\nNi 1.45\nd 0.75\n"
           b"illum 2\nPr .3\nPm 1\n",
    "grey": b"newmtl a\nKd 0.5\nKe \\\n2\nnewmtl b\nTr 0.25 # note\nnewmtl a\nd -halo 1\nTr .5\n",
    "others": b"\xef\xbb\xbfnewmtl Material #25\r\nmap_Kd -s 1 1 1 wood.png\rKa 1 1 1\r\nfoo\n",
    "spectral": b"newmtl a\nKd spectral a.rfl\n",
    "early": b"Kd 1 1 1\n",
    "bad": b"newmtl a\nKd 1 -1 0\n",
    "large": b"newmtl a\nKd 2\nNs 1e39\n",
    "twice": b"newmtl a\nKd 1\nKd 0\nillum 9\nPm 1\n",
}
CAMERA = b"[camera]\norigin = [0, 0, 1]\ntarget = [0, 0, 0]\n"
SCENE = {
    "all": CAMERA + b"up = [0, 1, 0]\nfov = 40\n[film]\nwidth = 4\nheight = 0x10\n[render]\n"
           b"spp = 1_000\nlight_sampling = \"point\"\n[materials.a]\ntype = 'ggx'\n"
           b"reflectance = [0.9, 0.8, 1]\nroughness = 0.4\nfresnel = \"schlick\"\n"
           b"[materials.\"b c\"]\ntype = \"diffuse\"\nemission = 3\n[[spheres]]\n"
           b"center = [1, 2, 3.5]\nradius = 1e1\nmaterial = \"a\"\n",
    "model": CAMERA + b"[[models]]\nobj = \"m.obj\"\nscale = [1, -1, 2]\nrotate = [0, 90, 0]\n"
             b"translate = [1e3, 0, 0]\n",
    "inline": b"camera = { origin = [0,0,1], target = [0,0,0] }\nspheres = []\nmaterials = {}\n",
    "nan": CAMERA + b"fov = nan\n",
    "inf": CAMERA + b"up = [0, inf, 0]\n",
    "wrong-type": CAMERA + b"[film]\nwidth = \"4\"\nheight = 1979-05-27T07:32:00Z\n",
    "unknown": CAMERA + b"[film]\nwidht = 4\n",
    "syntax": CAMERA + b"[film\n",
    "deep": CAMERA + b"fov = " + b"[" * 60 + b"]" * 60 + b"\n",
    "texts": CAMERA + b"up = '''\n\\u00e4'''\n\"\\u00e9\" = \"\"\"\\\n  x\\U0001F600\"\"\"\n",
    "empty": b"",
}


def chunk(name, data):
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


def png(colour, depth, rows, extra=b"", interlace=0, width=2):
    header = struct.pack(">IIBBBBB", width, 2, depth, colour, 0, 0, interlace)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + extra +
            chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


PNG = {
    "rgb8": png(2, 8, bytes(range(14)), chunk(b"tEXt", b"seed\x003") + chunk(b"sRGB", b"\0")),
    "rgb16": png(2, 16, bytes(26)),
    "grey1": png(0, 1, b"\0\x80\1\x40"),
    "grey-transparent": png(0, 8, bytes(6), chunk(b"tRNS", b"\0\7")),
    "palette": png(3, 2, b"\0\x10\0\x40", chunk(b"PLTE", bytes(range(6)))),
    "rgba": png(6, 8, b"\0" + b"\xff" * 8 + b"\2" + b"\0" * 8),
    "gamma": png(0, 8, bytes(6), chunk(b"gAMA", struct.pack(">I", 45455))),
    "hdr10": png(2, 8, bytes(14), chunk(b"cICP", b"\x09\x10\0\1")),
    "profile": png(2, 8, bytes(14), chunk(b"iCCP", b"a\0\0" + zlib.compress(bytes(132)))),
    "linear": png(0, 8, bytes(6), chunk(b"gAMA", struct.pack(">I", 100000))),
    "interlaced": png(0, 8, bytes(6), interlace=1),
    "text": png(0, 8, bytes(6), chunk(b"zTXt", b"a\0\0" + zlib.compress(b"x" * 99)) +
                chunk(b"iTXt", b"b\0\0\0\0\0text")),
    "huge": b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 65536, 60000, 8, 2,
                                                             0, 0, 0)),
}


def write_exr(folder):
    import numpy
    import OpenEXR
    values = numpy.arange(24, dtype=numpy.float32).reshape(4, 6) / 24

    def write(name, channels, **header):
        path = str(folder / name)
        header.setdefault("type", OpenEXR.scanlineimage)
        OpenEXR.File(header, channels).write(path)

    rgb = {c: values for c in "RGB"}
    for name in ("NO", "RLE", "ZIPS", "ZIP", "PIZ", "PXR24", "B44", "DWAA"):
        kind = numpy.float16 if name in ("B44", "PIZ") else numpy.float32
        write(name.lower(), {c: v.astype(kind) for c, v in rgb.items()},
              compression=getattr(OpenEXR, name + "_COMPRESSION"))
    write("layers", {**rgb, "variance.R": values, "id": values.astype(numpy.uint32)},
          compression=OpenEXR.ZIP_COMPRESSION, scene_hash="00ff", spp=64, seconds=0.25)
    write("tiled", rgb, compression=OpenEXR.ZIP_COMPRESSION, type=OpenEXR.tiledimage,
          tiles=OpenEXR.TileDescription())
    write("grey", {"Y": values}, compression=OpenEXR.NO_COMPRESSION)
    write("blender", {"a.Combined." + c: values for c in "RGB"} | {"a.Depth.Z": values},
          compression=OpenEXR.ZIP_COMPRESSION)
    write("xyz", rgb, compression=OpenEXR.ZIP_COMPRESSION,
          chromaticities=(1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1 / 3, 1 / 3))
    parts = [OpenEXR.Part({"type": OpenEXR.scanlineimage}, rgb, name) for name in ("left", "right")]
    OpenEXR.File(parts).write(str(folder / "parts"))
    write("no-green", {"R": values, "B": values}, compression=OpenEXR.RLE_COMPRESSION)


def write_tiff(folder):
    import numpy
    import tifffile
    rgb = numpy.arange(72, dtype=numpy.uint8).reshape(4, 6, 3)

    def write(name, values, **options):
        options.setdefault("photometric", "rgb")
        tifffile.imwrite(folder / name, values, software="", metadata=None, **options)

    write("rgb8", rgb)
    write("rgb16", rgb.astype(numpy.uint16) * 257, byteorder=">")
    write("float", rgb.astype(numpy.float32) / 72, compression="zlib")
    write("half", rgb.astype(numpy.float16) / 72)
    write("planes", rgb.transpose(2, 0, 1), planarconfig="separate")
    write("grey", rgb[..., 0], photometric="minisblack", rowsperstrip=1)
    write("white", rgb[..., 0], photometric="miniswhite")
    write("rgba", numpy.full((4, 6, 4), 255, numpy.uint8), extrasamples=["unassalpha"])
    write("tiled", numpy.zeros((32, 32, 3), numpy.uint8), tile=(16, 16), compression="zlib")
    write("big", rgb, bigtiff=True)
    write("described", rgb, description="spp: 64\nscene_hash: 00ff")
    tifffile.imwrite(folder / "pages", numpy.stack([rgb, rgb]), photometric="rgb", metadata=None)


here = pathlib.Path(os.path.abspath(__file__)).parent
for folder, seeds in (("obj", OBJ), ("mtl", MTL), ("scene", SCENE), ("png", PNG)):
    (here / folder).mkdir(exist_ok=True)
    for name, data in seeds.items():
        (here / folder / name).write_bytes(data)
(here / "exr").mkdir(exist_ok=True)
write_exr(here / "exr")
(here / "tiff").mkdir(exist_ok=True)
write_tiff(here / "tiff")
