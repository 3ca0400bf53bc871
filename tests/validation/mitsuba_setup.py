"""Imports Mitsuba 3: in its vectorised variant, or in that which RAYTRACING_MITSUBA_VARIANT names.
`import mitsuba` elsewhere comes after this."""

import glob
import os


def _find_llvm():
    """Dr.Jit asks for libLLVM.so, which Debian names by version."""
    names = glob.glob("/usr/lib/*/libLLVM*.so*") + glob.glob("/usr/lib/llvm-*/lib/libLLVM*.so*")
    return max(names, default=None)


if "DRJIT_LIBLLVM_PATH" not in os.environ and _find_llvm():
    os.environ["DRJIT_LIBLLVM_PATH"] = _find_llvm()

import mitsuba as mi  # noqa: E402  (Dr.Jit reads the environment when it is imported)

mi.set_variant(os.environ.get("RAYTRACING_MITSUBA_VARIANT", "llvm_ad_rgb"))
