# need(PACKAGE DEBIAN_PACKAGE [VERSION...]) finds a package, in the first of the versions that is
# there, without the messages of the package's own CMake file. What is not there is collected in the
# global property missing_packages, so that one message can name all of it.
function(need package debian_package)
  set(CMAKE_MESSAGE_LOG_LEVEL WARNING)
  if(NOT ARGN)
    find_package(${package} QUIET)
  endif()
  foreach(version IN LISTS ARGN)
    if(NOT ${package}_FOUND)
      find_package(${package} ${version} QUIET)
    endif()
  endforeach()
  if(NOT ${package}_FOUND)
    set_property(GLOBAL APPEND PROPERTY missing_packages ${debian_package})
  endif()
endfunction()

# need_library(LIBRARY HEADER DEBIAN_PACKAGE) finds a library that has no CMake file and defines a
# target of its name.
function(need_library library header debian_package)
  find_path(${library}_INCLUDE ${header})
  find_library(${library}_LIBRARY ${library})
  mark_as_advanced(${library}_INCLUDE ${library}_LIBRARY)
  if(NOT ${library}_INCLUDE OR NOT ${library}_LIBRARY)
    set_property(GLOBAL APPEND PROPERTY missing_packages ${debian_package})
    return()
  endif()
  add_library(${library} INTERFACE)
  target_include_directories(${library} SYSTEM INTERFACE ${${library}_INCLUDE})
  target_link_libraries(${library} INTERFACE ${${library}_LIBRARY})
endfunction()

# Defines the target `openimageio`. Debian's CMake file for OpenImageIO asks for headers of OpenCV
# that are not needed to use it, so the header and the libraries are looked for directly.
function(need_openimageio)
  find_path(OPENIMAGEIO_INCLUDE OpenImageIO/imageio.h)
  find_library(OPENIMAGEIO_LIBRARY OpenImageIO)
  find_library(OPENIMAGEIO_UTIL_LIBRARY OpenImageIO_Util)
  mark_as_advanced(OPENIMAGEIO_INCLUDE OPENIMAGEIO_LIBRARY OPENIMAGEIO_UTIL_LIBRARY)
  if(NOT OPENIMAGEIO_INCLUDE OR NOT OPENIMAGEIO_LIBRARY OR NOT OPENIMAGEIO_UTIL_LIBRARY)
    set_property(GLOBAL APPEND PROPERTY missing_packages libopenimageio-dev)
    return()
  endif()
  add_library(openimageio INTERFACE)
  target_include_directories(openimageio SYSTEM INTERFACE ${OPENIMAGEIO_INCLUDE})
  target_link_libraries(openimageio INTERFACE ${OPENIMAGEIO_LIBRARY} ${OPENIMAGEIO_UTIL_LIBRARY})
endfunction()
