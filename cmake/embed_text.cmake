# Texts that are edited as files of their own and compiled into the program.
#
# read_text(VARIABLE PATH) reads a file of the source tree; a change of it runs CMake again.
# embed_text(HEADER CONSTANT TEXT) writes the header embedded/HEADER of the build tree, which
# defines raytracing::CONSTANT, a std::string_view. The text must not contain `)text"`.
function(read_text variable path)
  file(READ ${PROJECT_SOURCE_DIR}/${path} text)
  set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY
    CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${path})
  set(${variable} "${text}" PARENT_SCOPE)
endfunction()

function(embed_text header constant text)
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/embedded/${header} @ONLY CONTENT
[[// Written by CMake.
#pragma once

#include <string_view>

namespace raytracing {

inline constexpr std::string_view @constant@ = R"text(@text@)text";

}  // namespace raytracing
]])
endfunction()
