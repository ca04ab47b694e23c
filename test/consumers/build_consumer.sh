#!/usr/bin/env bash
# build_consumer.sh find_package|habits|add_subdirectory|pkg_config SOURCE PREFIX LIBDIR: builds
# the program of README.md against this project, installed to PREFIX, and runs it on a plane. With
# add_subdirectory, libraries are static, and programs are built against them as installed as well,
# to absolute paths.
set -euo pipefail
way=$1 source=$2 prefix=$3 libdir=$4
work=$(mktemp -d)
trap 'rm -rf "$work" "$work.headers"' EXIT

# The first code block of README.md in a language.
readme_block() {
  awk -v fence="\`\`\`$1" '
    $0 == fence && !done { inside = 1; next }
    /^```/ && inside { inside = 0; done = 1 }
    inside' "$source/README.md"
}
readme_block cpp >"$work/planes.cpp"

case $way in
  find_package | habits)
    if [ "$way" = habits ]; then
      cp "$source"/test/consumers/habits/* "$work"
    else
      readme_block cmake >"$work/CMakeLists.txt"
    fi
    cmake -S "$work" -B "$work/build" -DCMAKE_PREFIX_PATH="$prefix" >"$work/log" 2>&1 ||
      { cat "$work/log"; exit 1; }
    if grep "CMP0074 is not set" "$work/log"; then exit 1; fi
    cmake --build "$work/build"
    ;;
  add_subdirectory)
    cp "$source/test/consumers/add_subdirectory/CMakeLists.txt" "$work"
    cmake -S "$work" -B "$work/build" -DCMAKE_BUILD_TYPE=Release \
      -DPCL_RGBD_PLANES_SOURCE="$source" -DPCL_RGBD_PLANES_ONLY_CORE_POINT_TYPES=ON \
      -DBUILD_SHARED_LIBS=OFF -DCMAKE_INSTALL_PREFIX="$work/static ones" \
      -DCMAKE_INSTALL_LIBDIR="$work/static ones/$libdir" -DCMAKE_INSTALL_INCLUDEDIR="$work.headers" \
      >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
    cmake --build "$work/build" --parallel 2
    cmake --install "$work/build" >"$work/log"
    [ -e "$work/static ones/share/doc/pcl_rgbd_planes/LICENSE" ]
    for way in find_package pkg_config; do
      bash "$0" "$way" "$source" "$work/static ones" "$libdir"
    done
    ;;
  pkg_config)
    mkdir "$work/build"
    export PKG_CONFIG_PATH=$prefix/$libdir/pkgconfig
    # Spaces in paths are escaped for the shell.
    eval "c++ ${CXXFLAGS:-} '$work/planes.cpp' -o '$work/build/planes' \
      $(pkg-config --cflags --libs pcl_rgbd_planes pcl_io)"
    export LD_LIBRARY_PATH=$prefix/$libdir
    ;;
esac

# A wall 2 m away, seen by 64 x 48 pixels.
{
  printf '%s\n' 'VERSION .7' 'FIELDS x y z' 'SIZE 4 4 4' 'TYPE F F F' 'COUNT 1 1 1' \
    'WIDTH 64' 'HEIGHT 48' 'VIEWPOINT 0 0 0 1 0 0 0' 'POINTS 3072' 'DATA ascii'
  awk 'BEGIN { for (v = 0; v < 48; ++v) for (u = 0; u < 64; ++u)
                 print (u - 31.5) / 52.5 * 2, (v - 23.5) / 52.5 * 2, 2 }'
} >"$work/wall.pcd"
"$work/build/planes" || [ $? -eq 1 ] # it does not crash without an argument
"$work/build/planes" "$work/wall.pcd" | tee "$work/planes.txt"
awk 'function near(a, b) { return a - b < 1e-5 && b - a < 1e-5 }
     near($1, 0) && near($4, 0) && near($7, -1) && near($10, 2) && $13 == 3072 { ok = 1 }
     END { exit !ok }' "$work/planes.txt"
