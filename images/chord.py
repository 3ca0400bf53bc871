#!/usr/bin/env python3
"""Draws chord.svg: the exact visibility of a chord of a light. Writes next to itself."""

import math
import pathlib

WIDTH, HEIGHT = 720, 560
AZIMUTH, ELEVATION = math.radians(-24), math.radians(20)  # of the orthographic view
SCALE, CENTRE = 150, (330, 472)

RECEIVER = (0, 0, 0)
LIGHT = [(-1.6, 2.75, -0.8), (1.6, 2.75, -0.8), (1.6, 2.75, 0.8), (-1.6, 2.75, 0.8)]
BEGIN, END = (-1.6, 2.75, 0.25), (1.6, 2.75, 0.25)
OCCLUDER = [(-0.5, 1.25, 0.75), (0.55, 1.55, -0.1), (-0.1, 1.45, -0.75)]
FLOOR = [(-1.9, 0, -0.9), (1.9, 0, -0.9), (1.9, 0, 0.9), (-1.9, 0, 0.9)]


def add(a, b, t=1.0):
    return tuple(x + t * y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def along(a, b, t):
    return add(a, add(b, a, -1), t)


def screen(p):
    x = p[0] * math.cos(AZIMUTH) + p[2] * math.sin(AZIMUTH)
    depth = p[2] * math.cos(AZIMUTH) - p[0] * math.sin(AZIMUTH)
    y = p[1] * math.cos(ELEVATION) - depth * math.sin(ELEVATION)
    return CENTRE[0] + SCALE * x, CENTRE[1] - SCALE * y


def points(corners):
    return " ".join("%.1f,%.1f" % screen(p) for p in corners)


def polygon(corners, style):
    return f'<polygon points="{points(corners)}" {style}/>'


def line(a, b, style):
    return f'<polyline points="{points([a, b])}" {style}/>'


def text(p, dx, dy, words, style=""):
    x, y = screen(p)
    return f'<text x="{x + dx:.1f}" y="{y + dy:.1f}" {style}>{words}</text>'


def crossing():
    """The segment in which the occluder crosses the plane of receiver and chord."""
    normal = cross(BEGIN, END)  # the receiver is the origin
    ends = []
    for a, b in zip(OCCLUDER, OCCLUDER[1:] + OCCLUDER[:1]):
        da, db = dot(normal, a), dot(normal, b)
        if da * db < 0:
            ends.append(along(a, b, da / (da - db)))
    return ends


def parameter(p):
    """Where the ray from the receiver through p, a point of that plane, meets the chord."""
    x = p[0] * BEGIN[1] / p[1]
    return (x - BEGIN[0]) / (END[0] - BEGIN[0])


def draw():
    cut = sorted(crossing(), key=parameter)
    t0, t1 = (parameter(p) for p in cut)
    hidden = [along(BEGIN, END, t) for t in (t0, t1)]
    out = [
        polygon(FLOOR, 'fill="#e8e8e8" stroke="#999"'),
        polygon([RECEIVER, BEGIN, hidden[0]], 'fill="#ffd24d" fill-opacity=".45"'),
        polygon([RECEIVER, hidden[1], END], 'fill="#ffd24d" fill-opacity=".45"'),
        polygon([RECEIVER, cut[0], cut[1]], 'fill="#ffd24d" fill-opacity=".45"'),
        polygon(OCCLUDER, 'fill="#5b7fa6" fill-opacity=".85" stroke="#2f4d6e"'),
        polygon([*cut, hidden[1], hidden[0]], 'fill="#666" fill-opacity=".35"'),
        line(*cut, 'stroke="#c00" stroke-width="3"'),
        polygon(LIGHT, 'fill="#fff6d5" fill-opacity=".75" stroke="#b08a00" stroke-width="1.5"'),
    ]
    for z in (-0.575, -0.35, -0.125, 0.1, 0.4, 0.55, 0.7):  # chords that other samples take
        out.append(line((-1.6, 2.75, z), (1.6, 2.75, z), 'stroke="#d9c27a" stroke-width="1"'))
    for p in (BEGIN, END, *hidden):
        out.append(line(RECEIVER, p, 'stroke="#888" stroke-dasharray="4 4"'))
    out += [
        line(BEGIN, hidden[0], 'stroke="#e07b00" stroke-width="5"'),
        line(hidden[1], END, 'stroke="#e07b00" stroke-width="5"'),
        line(*hidden, 'stroke="#666" stroke-width="3" stroke-dasharray="3 4"'),
        line(RECEIVER, (0, 0.62, 0), 'stroke="#222" stroke-width="2" marker-end="url(#tip)"'),
        '<circle cx="%.1f" cy="%.1f" r="5" fill="#222"/>' % screen(RECEIVER),
        text(RECEIVER, 12, 16, "receiver x"),
        text((0, 0.62, 0), 8, 0, "n", 'font-style="italic"'),
        text(OCCLUDER[0], -10, 18, "occluder", 'fill="#2f4d6e" text-anchor="end"'),
        text(LIGHT[1], -4, -12, "light", 'fill="#8a6c00" text-anchor="end"'),
        text(along(BEGIN, hidden[0], 0.5), 0, -10, "visible", 'fill="#a85a00" text-anchor="middle"'),
        text(along(hidden[1], END, 0.5), 0, -10, "visible", 'fill="#a85a00" text-anchor="middle"'),
        text(along(*hidden, 0.5), 0, -10, "hidden", 'fill="#444" text-anchor="middle"'),
        text(END, 10, 16, "chord", 'fill="#a85a00"'),
    ]
    return out


HEAD = f"""<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" \
font-family="sans-serif" font-size="17">
<title>A chord of a light, seen from a receiver past an occluder</title>
<defs><marker id="tip" viewBox="0 0 8 8" refX="6" refY="4" markerWidth="6" markerHeight="6" \
orient="auto"><path d="M0,0 L8,4 L0,8 z" fill="#222"/></marker></defs>
<rect width="{WIDTH}" height="{HEIGHT}" fill="#fff"/>
"""

path = pathlib.Path(__file__).resolve().with_suffix(".svg")
path.write_text(HEAD + "\n".join(draw()) + "\n</svg>\n")
