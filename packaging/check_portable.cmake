# Read by cpack before it packs.
if(CPACK_RAYTRACING_NATIVE)
  message(FATAL_ERROR " This build runs only on processors like that of this machine."
    " Packages come from: cmake --preset package && cmake --build --preset package"
    " && cpack --preset package")
endif()
