# opencv_core and opencv_imgproc from their static libraries. Debian's shared opencv_core needs libGLX, and through it X11 and Mesa, for an
# OpenGL bridge that EdgeScan never calls.
foreach(library core imgproc)
  find_library(EDGESCAN_OPENCV_${library} libopencv_${library}.a REQUIRED)
  set_target_properties(opencv_${library} PROPERTIES IMPORTED_LOCATION ${EDGESCAN_OPENCV_${library}})
  foreach(configuration NONE RELEASE)
    set_target_properties(opencv_${library} PROPERTIES IMPORTED_LOCATION_${configuration} ${EDGESCAN_OPENCV_${library}})
  endforeach()
endforeach()
# The bridge asks this function for OpenGL; it returns null, as on a machine without OpenGL.
file(CONFIGURE OUTPUT no_opengl.c CONTENT "void (*glXGetProcAddressARB(const unsigned char *name))(void) { (void)name; return 0; }\n")
add_library(edgescan_no_opengl STATIC ${CMAKE_CURRENT_BINARY_DIR}/no_opengl.c)
set_target_properties(edgescan_no_opengl PROPERTIES POSITION_INDEPENDENT_CODE ON C_VISIBILITY_PRESET hidden)
# The viewer links the real library: VTK calls it, and it must follow all its users on the linker's command line.
set(EDGESCAN_OPENCV_BRIDGE edgescan_no_opengl)
if(EDGESCAN_VIEWER)
  find_library(EDGESCAN_GLX GLX REQUIRED)
  set(EDGESCAN_OPENCV_BRIDGE "$<IF:$<BOOL:$<TARGET_PROPERTY:EDGESCAN_WINDOW>>,${EDGESCAN_GLX},edgescan_no_opengl>")
endif()
find_package(TBB REQUIRED)
find_library(EDGESCAN_LAPACK lapack REQUIRED)
find_library(EDGESCAN_BLAS blas REQUIRED)
set_target_properties(opencv_core PROPERTIES
  INTERFACE_LINK_LIBRARIES "${EDGESCAN_OPENCV_BRIDGE};TBB::tbb;${EDGESCAN_LAPACK};${EDGESCAN_BLAS};z;${CMAKE_DL_LIBS};pthread")
set_target_properties(opencv_imgproc PROPERTIES INTERFACE_LINK_LIBRARIES opencv_core)
