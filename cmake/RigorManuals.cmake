# Man pages and the completion of bash, zsh and fish, made by the program itself as soon as it is built, and installed
# where the shells and man look for them.
include(GNUInstallDirs)
if(NOT CMAKE_CROSSCOMPILING)
  set(manuals ${PROJECT_BINARY_DIR}/manuals)
  add_custom_command(TARGET rigor POST_BUILD
    COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:rigor> -DFOLDER=${manuals}
      -P ${PROJECT_SOURCE_DIR}/cmake/WriteManuals.cmake)
  install(DIRECTORY ${manuals}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR})
  install(FILES ${manuals}/completions/bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME rigor)
  install(FILES ${manuals}/completions/zsh DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions RENAME _rigor)
  install(FILES ${manuals}/completions/fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d
    RENAME rigor.fish)
endif()
