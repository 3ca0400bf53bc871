"""GGX conductor with height-correlated masking, as a BSDF plugin of Mitsuba 3.

Mitsuba's own `roughconductor` uses separable masking, G1(wi) G1(wo). The program uses the
height-correlated form of Smith's masking and shadowing (Heitz 2014, eq. 99),

    f cos(wo) = R D(m) / (1 + Lambda(wi) + Lambda(wo)) / (4 cos(wi)),

without a Fresnel term. At roughness 0.8 the difference is seen easily, at 0.4 hardly. Sampling and
density are those of visible normals. Both sides reflect.

`python3 ggx_correlated.py` checks the plugin against quadrature in numpy.
"""

import mitsuba_setup  # noqa: F401  (chooses the variant)

import drjit as dr
import mitsuba as mi
import numpy as np


class GgxCorrelated(mi.BSDF):
    """Properties: `alpha` and `reflectance`, an array of three numbers."""

    def __init__(self, props):
        mi.BSDF.__init__(self, props)
        self.alpha = float(props["alpha"])
        self.reflectance = mi.Color3f(props["reflectance"])
        flags = mi.BSDFFlags.GlossyReflection | mi.BSDFFlags.FrontSide | mi.BSDFFlags.BackSide
        self.m_components = [flags]
        self.m_flags = flags

    def _lambda(self, w):
        cos2 = w.z * w.z
        tan2 = dr.maximum(0, 1 - cos2) / cos2
        return 0.5 * (dr.sqrt(1 + self.alpha**2 * tan2) - 1)

    def _f_cos_and_pdf(self, wi, wo):
        """Without the reflectance; both directions above the surface, else 0."""
        m = dr.normalize(wi + wo)
        a2 = self.alpha**2
        root = m.x * m.x + m.y * m.y + a2 * m.z * m.z
        d = a2 / (dr.pi * root * root)
        above = (wi.z > 0) & (wo.z > 0)
        f_cos = d / (1 + self._lambda(wi) + self._lambda(wo)) / (4 * wi.z)
        pdf = d / (1 + self._lambda(wi)) / (4 * wi.z)
        return dr.select(above, f_cos, 0), dr.select(above, pdf, 0)

    @staticmethod
    def _upward(si, w):
        """w, mirrored where the viewer is below the surface."""
        return mi.Vector3f(w.x, w.y, dr.mulsign(w.z, si.wi.z))

    def sample(self, ctx, si, sample1, sample2, active=True):
        wi = self._upward(si, si.wi)
        normals = mi.MicrofacetDistribution(mi.MicrofacetType.GGX, self.alpha, True)
        m, _ = normals.sample(wi, sample2)
        wo = 2 * dr.dot(wi, m) * m - wi
        f_cos, pdf = self._f_cos_and_pdf(wi, wo)
        good = active & (pdf > 0)
        sample = mi.BSDFSample3f()
        sample.wo = self._upward(si, wo)
        sample.pdf = dr.select(good, pdf, 0)
        sample.eta = 1.0
        sample.sampled_type = mi.UInt32(+mi.BSDFFlags.GlossyReflection)
        sample.sampled_component = mi.UInt32(0)
        return sample, dr.select(good, self.reflectance * (f_cos / pdf), mi.Color3f(0))

    def eval_pdf(self, ctx, si, wo, active=True):
        f_cos, pdf = self._f_cos_and_pdf(self._upward(si, si.wi), self._upward(si, wo))
        return dr.select(active, self.reflectance * f_cos, mi.Color3f(0)), dr.select(active, pdf, 0)

    def eval(self, ctx, si, wo, active=True):
        return self.eval_pdf(ctx, si, wo, active)[0]

    def pdf(self, ctx, si, wo, active=True):
        return self.eval_pdf(ctx, si, wo, active)[1]

    def traverse(self, callback):
        pass

    def parameters_changed(self, keys):
        pass

    def to_string(self):
        return f"GgxCorrelated[alpha={self.alpha}]"


mi.register_bsdf("ggxcorrelated", GgxCorrelated)


def _albedo_by_quadrature(alpha, cos_i, n=2000):
    """Directional albedo, written a second time: Heitz's D and G2 in double precision."""
    z, phi = np.meshgrid((np.arange(n) + 0.5) / n, (np.arange(n) + 0.5) / n * 2 * np.pi)
    sin = np.sqrt(1 - z * z)
    m = np.stack([sin * np.cos(phi) + np.sqrt(1 - cos_i**2), sin * np.sin(phi), z + cos_i])
    cos2 = m[2] ** 2 / (m**2).sum(0)
    d = 1 / (np.pi * alpha**2 * cos2**2 * (1 + (1 / cos2 - 1) / alpha**2) ** 2)
    root_i, root_o = (np.sqrt(alpha**2 + (1 - alpha**2) * c * c) for c in (cos_i, z))
    g2 = 2 * z * cos_i / (z * root_i + cos_i * root_o)
    return (d * g2 / (4 * cos_i)).mean() * 2 * np.pi


def check(n=2048):
    """Raises where albedos of sampling, evaluation and quadrature differ by more than 1e-3."""
    i = dr.arange(mi.UInt32, n * n)
    u = mi.Point2f((mi.Float(i % n) + 0.5) / n, (mi.Float(i // n) + 0.5) / n)
    for alpha in (0.09, 0.16, 0.64):
        bsdf = mi.load_dict({"type": "ggxcorrelated", "alpha": alpha,
                             "reflectance": mi.ScalarColor3f(1, 1, 1)})
        for cos_i in (0.15, 0.9, -0.5):
            si = dr.zeros(mi.SurfaceInteraction3f, n * n)
            si.wi = mi.Vector3f(float(np.sqrt(1 - cos_i**2)), 0, cos_i)
            _, weight = bsdf.sample(mi.BSDFContext(), si, 0.5, u)
            wo = mi.warp.square_to_uniform_hemisphere(u)
            wo.z = dr.mulsign(wo.z, cos_i)
            f_cos, pdf = bsdf.eval_pdf(mi.BSDFContext(), si, wo)
            sampled = np.mean(np.array(weight.x))
            evaluated = np.mean(np.array(f_cos.x)) * 2 * np.pi
            expected = _albedo_by_quadrature(alpha, abs(cos_i))
            print(f"alpha {alpha:4} cos {cos_i:5}: sampled {sampled:.5f} evaluated {evaluated:.5f} "
                  f"expected {expected:.5f} density {np.mean(np.array(pdf)) * 2 * np.pi:.5f}")
            if max(abs(sampled - expected), abs(evaluated - expected)) > 1e-3:
                raise ArithmeticError("the plugin is not the model")


if __name__ == "__main__":
    check()
