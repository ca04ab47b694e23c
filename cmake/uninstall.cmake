# Removes the files that were installed last, which MANIFEST lists.
if(NOT EXISTS ${MANIFEST})
  message(FATAL_ERROR "${MANIFEST} is missing: nothing was installed from this build")
endif()
file(STRINGS ${MANIFEST} files ENCODING UTF-8)
foreach(file IN LISTS files)
  message(STATUS "Removing $ENV{DESTDIR}${file}")
  file(REMOVE "$ENV{DESTDIR}${file}")
endforeach()
