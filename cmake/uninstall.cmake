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
  file(REMOVE "$ENV{DESTDIR}${file}") # says nothing where it may not
  if(EXISTS "$ENV{DESTDIR}${file}" OR IS_SYMLINK "$ENV{DESTDIR}${file}")
    message(FATAL_ERROR "$ENV{DESTDIR}${file} could not be removed: may you write there, or is sudo needed?")
  endif()
endforeach()
