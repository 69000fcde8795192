# `cpack -G DEB` makes a Debian package of what is installed.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME handlens)
set(CPACK_PACKAGE_VENDOR "The Handlens developers")
set(CPACK_PACKAGE_CONTACT "The Handlens developers <handlens@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(needs "It runs on any processor of the architecture.")
if(NOT HANDLENS_CPU_LEVEL STREQUAL "baseline")
  set(needs "This package is built for ${HANDLENS_CPU_LEVEL} processors and says so on others.")
endif()
set(CPACK_PACKAGE_DESCRIPTION "Joints of hands are clicked in up to 16 views and become 3D joints with an uncertainty.
Hand poses are fitted to silhouettes, methods are compared, and ground truth is exported. handlens is the window,
handlens-batch the same on the command line. ${needs}")
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
# Libraries are found by dpkg-shlibdeps; these are programs and data that are used at run time.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
if(HANDLENS_BUILD_DESKTOP)
  set(CPACK_DEBIAN_PACKAGE_DEPENDS "breeze-icon-theme, libqt5svg5")
  set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "xvfb, gnuplot-nox, qttranslations5-l10n")
else()
  set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "gnuplot-nox")
endif()
include(CPack)
