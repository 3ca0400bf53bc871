# Read by cpack before it packs.
if(CPACK_RAYTRACING_NATIVE)
  message(FATAL_ERROR " This build runs only on processors like that of this machine."
    " ./setup.sh package makes a package for all.")
endif()
foreach(tool dpkg-shlibdeps file)
  find_program(${tool}_found ${tool})
  if(NOT ${tool}_found)
    message(FATAL_ERROR " Without ${tool} the package would lack its dependencies."
      " On Debian: apt-get install dpkg-dev file")
  endif()
endforeach()
