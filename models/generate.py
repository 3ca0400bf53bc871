#!/usr/bin/env python3
"""Writes the OBJ and MTL files of this folder. Standard library only; always the same bytes.

Every mesh is checked before it is written: see check_towards and check_smooth.
"""

import math
import pathlib

HERE = pathlib.Path(__file__).resolve().parent


def add(a, b):
    return tuple(x + y for x, y in zip(a, b))


def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def mul(a, s):
    return tuple(x * s for x in a)


def dot(a, b):
    return math.fsum(x * y for x, y in zip(a, b))  # same result in every Python


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    return mul(a, 1 / math.sqrt(dot(a, a)))


def mean(points):
    return tuple(math.fsum(c) / len(points) for c in zip(*points))


def polygon_normal(points):
    """Unit normal (Newell's method)."""
    p = points[0]
    return unit(mean([cross(sub(a, p), sub(b, p)) for a, b in zip(points, points[1:] + [p])]))


# The Cornell box: room, light and two blocks. Measured data of Cornell's Program of Computer
# Graphics. Corners in the published order; their first corner stays first in the file.

MATERIALS = {
    "white": {"Kd": (0.725, 0.71, 0.68)},
    "red": {"Kd": (0.63, 0.065, 0.05)},
    "green": {"Kd": (0.14, 0.45, 0.091)},
    "light": {"Kd": (0, 0, 0), "Ke": (47.8348, 38.5664, 31.0808)},
}

T, Z, L = 548.8, 559.2, 548.7  # the ceiling's height, the room's depth, the light's height
ROOM = [
    ("floor", "white", [(552.8, 0, 0), (0, 0, 0), (0, 0, Z), (549.6, 0, Z)]),
    ("light", "light", [(343, L, 227), (343, L, 332), (213, L, 332), (213, L, 227)]),
    ("ceiling", "white", [(556, T, 0), (556, T, Z), (0, T, Z), (0, T, 0)]),
    ("back_wall", "white", [(549.6, 0, Z), (0, 0, Z), (0, T, Z), (556, T, Z)]),
    ("green_wall", "green", [(0, 0, Z), (0, 0, 0), (0, T, 0), (0, T, Z)]),
    ("red_wall", "red", [(552.8, 0, 0), (549.6, 0, Z), (556, T, Z), (556, T, 0)]),
]
ROOM_CENTRE = (278, 274.4, 279.6)

BLOCK_TOPS = {
    "short_block": [(130, 165, 65), (82, 165, 225), (240, 165, 272), (290, 165, 114)],
    "tall_block": [(423, 330, 247), (265, 330, 296), (314, 330, 456), (472, 330, 406)],
}


def check_towards(corners, point):
    """The polygon faces the point."""
    assert dot(polygon_normal(corners), unit(sub(point, mean(corners)))) > 0.5, corners


def block_faces(top):
    """The top and the four sides of a block that stands on the floor, facing outward."""
    def down(p):
        return (p[0], 0, p[2])

    faces = [top] + [[a, down(a), down(b), b] for a, b in zip(top, top[1:] + top[:1])]
    centre = mean(top + [down(p) for p in top])
    for face in faces:
        check_towards(face[::-1], centre)
    return faces


def quads_obj(comment, groups):
    lines = ["# " + line for line in comment] + ["mtllib cornell_box.mtl"]
    numbers = {}
    body = []
    for name, material, faces in groups:
        body += ["g " + name, "usemtl " + material]
        for face in faces:
            for p in face:
                if p not in numbers:
                    numbers[p] = len(numbers) + 1
                    lines.append("v %g %g %g" % p)
            body.append("f " + " ".join(str(numbers[p]) for p in face))
    return "\n".join(lines + body) + "\n"


def cornell():
    room = []
    for name, material, corners in ROOM:
        check_towards(corners, ROOM_CENTRE)
        room.append((name, material, [corners]))
    assert polygon_normal(ROOM[1][2]) == (0, -1, 0)
    blocks = [(name, "white", block_faces(top)) for name, top in BLOCK_TOPS.items()]
    mtl = ["# Reflectances and the light's radiance of the Cornell box (R, G, B)."]
    for name, values in MATERIALS.items():
        mtl.append("newmtl " + name)
        mtl += ["%s %g %g %g" % ((key,) + rgb) for key, rgb in values.items()]
    return {
        "cornell_box.mtl": "\n".join(mtl) + "\n",
        "cornell_box.obj": quads_obj(["The Cornell box, measured data, millimetres."],
                                     room + blocks),
        "cornell_room.obj": quads_obj(["The Cornell box without its blocks, millimetres."], room),
    }


# Smooth meshes: a list of triangles, each three (position, normal) corners.

def fixed(v):
    """The vector as it stands in the file, without negative zeros."""
    return " ".join("%.7f" % (round(x, 7) + 0.0) for x in v)


class SmoothMesh:
    """Indexed triangles; equal texts of positions and of normals are one."""

    def __init__(self):
        self.positions, self.normals, self.groups = {}, {}, []

    def group(self, name):
        self.groups.append((name, []))

    def triangle(self, corners):
        face = []
        for position, normal in corners:
            face.append((self.positions.setdefault(fixed(position), len(self.positions)),
                         self.normals.setdefault(fixed(normal), len(self.normals))))
        if len({p for p, _ in face}) == 3:  # at a pole only one of two is left
            self.groups[-1][1].append(face)

    def faces(self, groups=None):
        return [face for name, faces in self.groups if not groups or name in groups
                for face in faces]

    def obj(self, comment):
        lines = ["# " + line for line in comment]
        lines += ["v " + p for p in self.positions] + ["vn " + n for n in self.normals]
        for name, faces in self.groups:
            lines.append("g " + name)
            lines += ["f " + " ".join("%d//%d" % (p + 1, n + 1) for p, n in face)
                      for face in faces]
        return "\n".join(lines) + "\n"

    def check_smooth(self, pieces, open_edges):
        """No degenerate triangle; each corner's normal is of unit length and on the triangle's
        side; neighbours wind alike, each edge belongs to two triangles, except `open_edges` of
        them; each piece (a tuple of groups) winds outward, told from its signed volume."""
        points = [tuple(map(float, p.split())) for p in self.positions]
        normals = [tuple(map(float, n.split())) for n in self.normals]
        edges = set()
        for face in self.faces():
            a, b, c = (points[p] for p, _ in face)
            flat = cross(sub(b, a), sub(c, a))
            size = max(dot(sub(p, q), sub(p, q)) for p, q in ((a, b), (b, c), (c, a)))
            assert math.sqrt(dot(flat, flat)) > 1e-3 * size, (a, b, c)
            for _, n in face:
                assert abs(dot(normals[n], normals[n]) - 1) < 1e-5
                assert dot(unit(flat), normals[n]) > 0.3, (a, b, c, normals[n])
            for (p, _), (q, _) in zip(face, face[1:] + face[:1]):
                assert (p, q) not in edges, (points[p], points[q])
                edges.add((p, q))
        assert sum((q, p) not in edges for p, q in edges) == open_edges
        for piece in pieces:
            faces = [[points[p] for p, _ in face] for face in self.faces(piece)]
            centre = mean([p for face in faces for p in face])
            assert sum(dot(sub(a, centre), cross(sub(b, centre), sub(c, centre)))
                       for a, b, c in faces) > 0, piece


def sphere(subdivisions):
    """Icosahedron, each triangle cut into four `subdivisions` times; the normal is the position."""
    g = (1 + math.sqrt(5)) / 2
    corners = [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g),
               (0, -1, -g), (0, 1, -g), (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]
    triangles = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4),
                 (11, 10, 2), (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8),
                 (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    triangles = [[unit(corners[i]) for i in t] for t in triangles]
    for _ in range(subdivisions):
        finer = []
        for a, b, c in triangles:
            ab, bc, ca = unit(add(a, b)), unit(add(b, c)), unit(add(c, a))
            finer += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        triangles = finer
    mesh = SmoothMesh()
    mesh.group("sphere")
    for t in triangles:
        mesh.triangle([(p, p) for p in t])
    mesh.check_smooth([("sphere",)], 0)
    assert len(mesh.faces()) == 20 * 4 ** subdivisions
    return mesh.obj(["Sphere of radius 1 around the origin, %d triangles; normal = position."
                     % len(mesh.faces())])


def bezier(t):
    """Weights of a cubic and of its derivative."""
    s = 1 - t
    return ((s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t),
            (-3 * s * s, 3 * s * s - 6 * s * t, 6 * s * t - 3 * t * t, 3 * t * t))


def patch_point(patch, i, j, n):
    """Position and normal of a 4 x 4 patch at (i/n, j/n); i runs over the rows."""
    def evaluate(rows, columns):
        return tuple(math.fsum(r * c * p[axis] for r, row in zip(rows, patch) for c, p in
                         zip(columns, row)) for axis in range(3))

    (u, du), (v, dv) = bezier(i / n), bezier(j / n)
    if i == 0 and len(set(patch[0])) == 1:  # a pole: the tangents along the patch's two sides
        normal = cross(evaluate(du, bezier(1)[0]), evaluate(du, bezier(0)[0]))
    else:
        normal = cross(evaluate(u, dv), evaluate(du, v))  # outward
    return evaluate(u, v), unit(normal)


def share_normals(grids):
    """Where patches meet smoothly (less than 15 degrees apart), gives them one normal."""
    found = {}
    for _, grid in grids:
        for key in grid:
            position, normal = grid[key]
            groups = found.setdefault(fixed(position), [])
            for members in groups:
                if dot(members[0][2], normal) > math.cos(math.radians(15)):
                    members.append((grid, key, normal))
                    break
            else:
                groups.append([(grid, key, normal)])
    for groups in found.values():
        for members in groups:
            normal = unit(mean([n for _, _, n in members]))
            for grid, key, _ in members:
                grid[key] = (grid[key][0], normal)


def teapot(n):
    """Each of the 32 Bezier patches as n x n quads cut in two."""
    patches, vertices = [], []
    for line in (HERE / "newell_teapot.txt").read_text().splitlines():
        words = line.split()
        if words[0] == "patch":
            patches.append((words[1], [int(w) for w in words[2:]]))
        elif words[0] == "vertex":
            x, y, z = map(float, words[1:])
            vertices.append((x, z, -y))  # y up
    grids = []
    for part, numbers in patches:
        patch = [[vertices[k] for k in numbers[4 * r:4 * r + 4]] for r in range(4)]
        grids.append((part, {(i, j): patch_point(patch, i, j, n)
                             for i in range(n + 1) for j in range(n + 1)}))
    share_normals(grids)
    mesh = SmoothMesh()
    for part, grid in grids:
        if not mesh.groups or mesh.groups[-1][0] != part:
            mesh.group(part)
        for i in range(n):
            for j in range(n):
                a, b = grid[i, j], grid[i + 1, j]
                c, d = grid[i + 1, j + 1], grid[i, j + 1]
                mesh.triangle((a, c, b))
                mesh.triangle((a, d, c))
    # Open by design: the rim's inner edge and the lid's edge (four patches around), both ends of
    # handle and spout (two patches around).
    mesh.check_smooth([("rim", "body", "bottom"), ("handle",), ("spout",), ("lid",)], 16 * n)
    heights = [float(p.split()[1]) for p in mesh.positions]
    assert min(heights) == 0 and max(heights) == 3.15
    return mesh.obj(["The Utah teapot (Martin Newell, 1975), %d triangles." % len(mesh.faces()),
                     "Newell's units: 3.15 high, body 4 wide. y up, stands on y = 0, spout"
                     " along +x."])


def main():
    files = cornell()
    files["sphere.obj"] = sphere(5)
    files["teapot.obj"] = teapot(12)
    for name, text in files.items():
        (HERE / name).write_bytes(text.encode())


if __name__ == "__main__":
    main()
