# SPDX-License-Identifier: GPL-3.0-or-later
# The installed files beside the programs: service, adapter rules, man pages, menu entry, metadata for software centres,
# icon.
include(GNUInstallDirs)

configure_file("${CMAKE_SOURCE_DIR}/packaging/systemd/boresightd.service.in" boresightd.service @ONLY)
install(FILES "${CMAKE_BINARY_DIR}/boresightd.service" DESTINATION lib/systemd/system)
# The number is below 73, because 73-seat-late.rules uses the tag uaccess.
install(FILES packaging/udev/70-boresight-fdcanusb.rules DESTINATION lib/udev/rules.d)
install(FILES packaging/man/boresightctl.1 packaging/man/boresightd.1 DESTINATION "${CMAKE_INSTALL_MANDIR}/man1")
if(BORESIGHT_UI)
  install(FILES packaging/man/boresight.1 DESTINATION "${CMAKE_INSTALL_MANDIR}/man1")
  install(FILES packaging/boresight.desktop DESTINATION "${CMAKE_INSTALL_DATADIR}/applications")
  install(FILES packaging/boresight.metainfo.xml DESTINATION "${CMAKE_INSTALL_DATADIR}/metainfo")
  install(FILES resources/icons/boresight.svg DESTINATION "${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps")
endif()
