# Files and folders of `cmake --install`, by component: cli, viewer (with the program of PCL's peers, which edgescan-lab starts), python. The programs write
# their man pages and completions themselves.
set(EDGESCAN_HOMEPAGE "https://example.org/edgescan" CACHE STRING "where the project has its pages, for software centres")
set(EDGESCAN_RELEASE_DATE "2026-11-22" CACHE STRING "of this version, for software centres")

# edgescan_pages(PROGRAM COMPONENT)
function(edgescan_pages program component)
  set(pages ${CMAKE_BINARY_DIR}/pages/${program})
  add_custom_command(TARGET ${program} POST_BUILD COMMAND ${CMAKE_COMMAND} -E rm -rf ${pages}
    COMMAND ${program} --pages ${pages} VERBATIM)
  install(DIRECTORY ${pages}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR} COMPONENT ${component})
  install(FILES ${pages}/bash/${program} DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT ${component})
  install(FILES ${pages}/zsh/_${program} DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT ${component})
  install(FILES ${pages}/fish/${program}.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT ${component})
endfunction()

install(TARGETS edgescan-cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT cli)
edgescan_pages(edgescan-cli cli)
install(TARGETS edgescan-lab RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT cli)
edgescan_pages(edgescan-lab cli)
if(TARGET edgescan-peers)
  install(TARGETS edgescan-peers RUNTIME DESTINATION lib/edgescan COMPONENT viewer)
endif()
if(EDGESCAN_VIEWER)
  set(resources ${CMAKE_SOURCE_DIR}/resources)
  install(TARGETS edgescan RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT viewer)
  edgescan_pages(edgescan viewer)
  install(DIRECTORY ${CMAKE_BINARY_DIR}/share/edgescan/demo DESTINATION ${CMAKE_INSTALL_DATADIR}/edgescan COMPONENT viewer)
  install(FILES ${resources}/desktop/edgescan.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT viewer)
  install(FILES ${resources}/desktop/edgescan-mime.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages RENAME edgescan.xml COMPONENT viewer)
  install(FILES ${resources}/desktop/edgescan.thumbnailer DESTINATION ${CMAKE_INSTALL_DATADIR}/thumbnailers COMPONENT viewer)
  configure_file(${resources}/desktop/org.edgescan.EdgeScan.metainfo.xml.in ${CMAKE_BINARY_DIR}/org.edgescan.EdgeScan.metainfo.xml @ONLY)
  install(FILES ${CMAKE_BINARY_DIR}/org.edgescan.EdgeScan.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo COMPONENT viewer)
  foreach(size 16 24 32 48 64 128 256 512)
    install(FILES ${resources}/icons/edgescan-${size}.png RENAME edgescan.png
      DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/${size}x${size}/apps COMPONENT viewer)
  endforeach()
  install(FILES ${resources}/icons/edgescan.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps COMPONENT viewer)
endif()

# The manual as HTML pages, where the generator (python3-markdown) is installed: the target edgescan_manual.
find_program(EDGESCAN_SYSTEM_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
if(EDGESCAN_SYSTEM_PYTHON)
  execute_process(COMMAND ${EDGESCAN_SYSTEM_PYTHON} -c "import markdown" RESULT_VARIABLE without_markdown OUTPUT_QUIET ERROR_QUIET)
endif()
if(EDGESCAN_SYSTEM_PYTHON AND without_markdown EQUAL 0)
  file(GLOB_RECURSE EDGESCAN_PAGES CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/docs/*.md ${CMAKE_SOURCE_DIR}/docs/*.png)
  add_custom_command(OUTPUT ${CMAKE_BINARY_DIR}/manual/index.html
    COMMAND ${EDGESCAN_SYSTEM_PYTHON} -B ${CMAKE_SOURCE_DIR}/docs/make-manual ${CMAKE_BINARY_DIR}/manual
    DEPENDS ${EDGESCAN_PAGES} ${CMAKE_SOURCE_DIR}/docs/make-manual
    COMMENT "Making the manual" VERBATIM)
  add_custom_target(edgescan_manual ALL DEPENDS ${CMAKE_BINARY_DIR}/manual/index.html)
  install(DIRECTORY ${CMAKE_BINARY_DIR}/manual/ DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/edgescan/html COMPONENT viewer OPTIONAL)
else()
  message(STATUS "No manual as HTML: install python3-markdown for it")
endif()
