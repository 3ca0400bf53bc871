# What `cmake --install` copies and `cpack` packs: the program and its
# module for images, the scenes, the models, the documents.
include(GNUInstallDirs)
set(data_folder ${CMAKE_INSTALL_DATADIR}/raytracing)
set(doc_folder ${CMAKE_INSTALL_DATADIR}/doc/raytracing)

install(TARGETS Raytracing)
install(TARGETS raytracing_openimageio LIBRARY DESTINATION lib/raytracing)
install(DIRECTORY scenes DESTINATION ${data_folder} FILES_MATCHING PATTERN "*.toml")
install(DIRECTORY models DESTINATION ${data_folder}
  FILES_MATCHING PATTERN "*.obj" PATTERN "*.mtl")
install(FILES README.md CHANGELOG.md CITATION.cff DESTINATION ${doc_folder})
install(FILES scenes/README.md DESTINATION ${doc_folder} RENAME scenes.md)
install(FILES packaging/copyright DESTINATION ${doc_folder})

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME raytracing)
set(CPACK_PACKAGE_CONTACT "Raytracing maintainers <maintainers@raytracing.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Path tracer that compares how area lights are sampled")
set(CPACK_PACKAGE_DESCRIPTION
"Raytracing renders OBJ scenes on the CPU. It samples area lights by points, by
solid angle or by chords whose visible parts it computes exactly, measures what
each of these methods costs, and shows which of them to trust in which scene.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)  # dependencies as dpkg-shlibdeps finds them
# Those draw the charts of `chart` and `stress`, and the numbers in pictures of errors.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "gnuplot-nox, fonts-dejavu-core")
set(CPACK_PROJECT_CONFIG_FILE ${PROJECT_SOURCE_DIR}/packaging/check.cmake)
set(CPACK_RAYTRACING_NATIVE ${RAYTRACING_NATIVE})
include(CPack)
