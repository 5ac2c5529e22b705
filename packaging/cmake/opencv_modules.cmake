# SPDX-License-Identifier: GPL-3.0-or-later
# The OpenCV modules that Odograph uses, one imported target each. OpenCV's own package file comes only with Debian's
# libopencv-dev, which installs every module; highgui and videoio among them bring Qt 5 and some 245 shared libraries.
find_path(OPENCV_INCLUDE_DIR opencv2/core.hpp PATH_SUFFIXES opencv4 REQUIRED)
foreach(module core imgproc features2d calib3d aruco)
  find_library(OPENCV_${module}_LIBRARY opencv_${module} REQUIRED)
  add_library(opencv_${module} SHARED IMPORTED)
  set_target_properties(opencv_${module} PROPERTIES
    IMPORTED_LOCATION ${OPENCV_${module}_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${OPENCV_INCLUDE_DIR})
endforeach()
