# Removes the files that were installed last, which a manifest in BUILD lists: of all, or of one
# component.
file(GLOB manifests "${BUILD}/install_manifest*.txt")
set(last "")
foreach(manifest IN LISTS manifests)
  if("${manifest}" IS_NEWER_THAN "${last}") # or there is none yet
    set(last "${manifest}")
  endif()
endforeach()
if(NOT last)
  message(FATAL_ERROR "There is no install_manifest.txt in ${BUILD}: nothing was installed from this build")
endif()
file(STRINGS "${last}" files ENCODING UTF-8)
foreach(file IN LISTS files)
  message(STATUS "Removing $ENV{DESTDIR}${file}")
  file(REMOVE "$ENV{DESTDIR}${file}")
endforeach()
