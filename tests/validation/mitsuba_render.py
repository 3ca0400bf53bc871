"""Our scenes in Mitsuba 3: the same camera, shapes, materials, light and box filter."""

from dataclasses import dataclass

import ggx_correlated  # noqa: F401  (chooses the variant and registers the plugin)

import mitsuba as mi
import numpy as np



@dataclass
class Settings:
    """What changes Mitsuba's noise and time; `conductor` names the plugin of GGX conductors."""

    sampler: str = "multijitter"
    roulette_depth: int = 8  # bounces before Russian roulette
    conductor: str = "ggxcorrelated"


def build(scene, size, max_depth, settings=Settings()):
    """Mitsuba's scene. `max_depth` is ours, the number of reflections, or None for any number."""
    tree = {
        "type": "scene",
        "integrator": {
            "type": "path",
            "max_depth": -1 if max_depth is None else max_depth + 1,  # it counts segments
            "rr_depth": settings.roulette_depth,
        },
        "sensor": _sensor(scene.camera, size, settings.sampler),
    }
    for i, mesh in enumerate(scene.meshes):
        tree[f"mesh{i}"] = _mesh(f"mesh{i}", mesh, settings.conductor)
    for i, sphere in enumerate(scene.spheres):
        tree[f"sphere{i}"] = {"type": "sphere", "center": sphere.center, "radius": sphere.radius,
                              "bsdf": _bsdf(sphere.material, settings.conductor)}
    return mi.load_dict(tree)


def render(scene, size, max_depth, spp, passes, seed, settings=Settings()):
    """Mean and variance of the mean, (size, size, 3) each, of `passes` times `spp` samples per
    pixel. Samples are stratified within a pass; the variance is that between the passes, which
    are independent."""
    built = build(scene, size, max_depth, settings)
    total, squares = np.zeros((2, size, size, 3))
    for i in range(passes):
        image = np.array(mi.render(built, spp=spp, seed=seed + i), dtype=np.float64)
        if not np.isfinite(image).all():
            raise ArithmeticError("Mitsuba's picture is not finite")
        total += image
        squares += image**2
    mean = total / passes
    return mean, np.maximum(squares / passes - mean**2, 0) / (passes - 1)


def _sensor(camera, size, sampler):
    to_world = mi.ScalarTransform4f().look_at(
        origin=camera["origin"], target=camera["target"], up=camera["up"])
    return {
        "type": "perspective",
        "fov": camera["fov"],
        "fov_axis": "y",
        "near_clip": 1.0,
        "far_clip": 1e5,
        "to_world": to_world,
        "sampler": {"type": sampler},
        "film": {"type": "hdrfilm", "width": size, "height": size, "pixel_format": "rgb",
                 "component_format": "float32", "rfilter": {"type": "box"}},
    }


def _bsdf(material, conductor):
    if material.alpha is None:
        return {"type": "twosided",
                "bsdf": {"type": "diffuse",
                         "reflectance": {"type": "rgb", "value": material.reflectance}}}
    if conductor == "roughconductor":
        return {"type": "roughconductor", "distribution": "ggx", "material": "none",
                "alpha": material.alpha,
                "specular_reflectance": {"type": "rgb", "value": material.reflectance}}
    return {"type": conductor, "alpha": material.alpha,
            "reflectance": mi.ScalarColor3f(material.reflectance)}


def _mesh(name, mesh, conductor):
    """A flat polygon of two triangles is one light of ours and two of Mitsuba's: the same light."""
    props = mi.Properties()
    props["bsdf"] = mi.load_dict(_bsdf(mesh.material, conductor))
    if mesh.material.radiance is not None and any(mesh.material.radiance):
        props["emitter"] = mi.load_dict(
            {"type": "area", "radiance": {"type": "rgb", "value": mesh.material.radiance}})
    props["face_normals"] = mesh.normals is None
    result = mi.Mesh(name, len(mesh.positions), len(mesh.triangles), props=props,
                     has_vertex_normals=mesh.normals is not None)
    params = mi.traverse(result)
    params["vertex_positions"] = mesh.positions.ravel().astype(np.float32)
    params["faces"] = mesh.triangles.ravel().astype(np.uint32)
    if mesh.normals is not None:
        params["vertex_normals"] = mesh.normals.ravel().astype(np.float32)
    params.update()
    return result
