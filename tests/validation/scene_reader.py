"""Reads our scene files (TOML, OBJ, MTL) into plain data, without any code of the program.

Only what the validated scenes hold is understood. Anything else is an error: a key that is left
out silently would validate another scene.
"""

import pathlib
import tomllib
from dataclasses import dataclass, field

import numpy as np


@dataclass
class Material:
    """`alpha` is None for a diffuse surface, else that of a GGX conductor without Fresnel term."""

    reflectance: list
    alpha: float | None = None
    radiance: list | None = None  # on the side from which the corners run counter-clockwise


@dataclass
class Mesh:
    positions: np.ndarray  # (n, 3)
    normals: np.ndarray | None  # (n, 3), None for flat faces
    triangles: np.ndarray  # (m, 3)
    material: Material


@dataclass
class Sphere:
    center: list
    radius: float
    material: Material


@dataclass
class Scene:
    camera: dict  # origin, target, up, fov (vertical, degrees)
    meshes: list = field(default_factory=list)
    spheres: list = field(default_factory=list)


def read_scene(path):
    path = pathlib.Path(path)
    toml = tomllib.loads(path.read_text())
    _expect_keys(toml, {"film", "camera", "render", "materials", "models", "spheres"})
    _expect_keys(toml["camera"], {"origin", "target", "up", "fov"})
    materials = {name: _material(t) for name, t in toml.get("materials", {}).items()}
    scene = Scene(toml["camera"])
    for model in toml.get("models", []):
        scene.meshes += _model(path.parent, model, materials)
    for sphere in toml.get("spheres", []):
        _expect_keys(sphere, {"center", "radius", "material"})
        scene.spheres.append(
            Sphere(sphere["center"], sphere["radius"], materials[sphere["material"]]))
    return scene


def _expect_keys(table, known):
    unknown = set(table) - known
    if unknown:
        raise ValueError(f"not understood: {', '.join(sorted(unknown))}")


def _material(table):
    if table["type"] == "diffuse":
        _expect_keys(table, {"type", "reflectance"})
        return Material(table["reflectance"])
    _expect_keys(table, {"type", "reflectance", "roughness", "fresnel"})
    if table["type"] != "ggx" or table.get("fresnel", "none") != "none":
        raise ValueError(f"material not understood: {table}")
    return Material(table["reflectance"], alpha=table["roughness"] ** 2)


def _model(folder, model, materials):
    """The meshes of one [[models]] table, one for each material, in the world's coordinates."""
    _expect_keys(model, {"obj", "scale", "rotate", "translate", "material"})
    positions, normals, faces = _read_obj(folder / model["obj"])
    rotation = _rotation(model.get("rotate", [0, 0, 0]))
    scale = np.broadcast_to(model.get("scale", 1.0), 3)
    positions = positions * scale @ rotation.T + model.get("translate", [0, 0, 0])
    if len(normals):
        normals = normals / scale @ rotation.T
        normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    meshes = []
    for material, polygons in faces.values():
        if "material" in model:
            material = materials[model["material"]]
        meshes.append(_mesh(positions, normals, polygons, material))
    return meshes


def _mesh(positions, normals, polygons, material):
    """Convex polygons as fans. A vertex is a pair of a position and a normal."""
    vertices, triangles = {}, []
    for polygon in polygons:
        corners = [vertices.setdefault(corner, len(vertices)) for corner in polygon]
        triangles += [[corners[0], b, c] for b, c in zip(corners[1:], corners[2:])]
    p, n = np.array(list(vertices)).T
    if (n < 0).any() and (n >= 0).any():
        raise ValueError("some corners have normals and others none")
    return Mesh(positions[p], normals[n] if n[0] >= 0 else None, np.array(triangles), material)


def _rotation(degrees):
    """About x, then y, then z."""
    (cx, cy, cz), (sx, sy, sz) = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    x = np.array([[1, 0, 0], [0, cx, -sx], [0, sx, cx]])
    y = np.array([[cy, 0, sy], [0, 1, 0], [-sy, 0, cy]])
    z = np.array([[cz, -sz, 0], [sz, cz, 0], [0, 0, 1]])
    return z @ y @ x


def _read_obj(path):
    """Positions, normals, and {material name: (material, polygons)}; a polygon is a list of
    (position index, normal index or -1)."""
    positions, normals, faces, materials, name = [], [], {}, {"": None}, ""
    for line in path.read_text().splitlines():
        key, *words = line.split("#")[0].split() or ["#"]
        if key == "v":
            positions.append([float(w) for w in words])
        elif key == "vn":
            normals.append([float(w) for w in words])
        elif key == "mtllib":
            materials |= _read_mtl(path.parent / words[0])
        elif key == "usemtl":
            name = words[0]
        elif key == "f":
            corners = [(w.split("/") + ["", ""])[:3] for w in words]
            polygon = [(int(p) - 1, int(n) - 1 if n else -1) for p, _, n in corners]
            faces.setdefault(name, (materials[name], []))[1].append(polygon)
        elif key not in ("#", "g", "o", "s"):
            raise ValueError(f"{path.name}: not understood: {line}")
    return np.array(positions), np.array(normals), faces


def _read_mtl(path):
    materials = {}
    for line in path.read_text().splitlines():
        key, *words = line.split("#")[0].split() or ["#"]
        if key == "newmtl":
            material = materials[words[0]] = Material([0, 0, 0])
        elif key == "Kd":
            material.reflectance = [float(w) for w in words]
        elif key == "Ke":
            material.radiance = [float(w) for w in words]
        elif key != "#":
            raise ValueError(f"{path.name}: not understood: {line}")
    return materials
