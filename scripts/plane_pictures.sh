#!/usr/bin/env bash
# plane_pictures.sh DATA PICTURE: draws the planes of a frame of each data set into PICTURE, a PNG:
# before, those of PCL's OrganizedMultiPlaneSegmentation, and after, ours. DATA is the folder with
# the recordings, of which only these planes are drawn; simulated frames are shown as well.
set -euo pipefail
data=${1:?"say in which folder the recordings are"}
picture=${2:?"say which PNG to write"}
for tool in gnuplot pcl_evaluate_planes pcl_simulate_rgbd; do
  command -v "$tool" >/dev/null ||
    { echo "$tool is missing: run scripts/install_dependencies.sh, build, and add build/bin to PATH" >&2
      exit 1; }
done
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
sheet=$folder/sheet.gnuplot
cat >"$sheet" <<END
set terminal pngcairo noenhanced size 960,1176 font 'sans,9'
set output '$folder/sheet.png'
set multiplot layout 6,4
unset border; unset tics; unset key
set size ratio -1; set autoscale noextend; set margins 0,0,0,1
END

# tile TITLE PNG: the next picture of the sheet.
tile () {
  echo "set title '$1' offset 0,-0.9; plot '$2' binary filetype=png with rgbimage" >>"$sheet"
}

# planes NAME INPUT...: the planes of the first frame, before and after.
planes () {
  local name=$1
  shift
  pcl_evaluate_planes "$@" --frames 1 --resolution qvga --pictures "$folder/$name" >/dev/null
  tile "$name, before" "$(echo "$folder/$name"/*_pcl_omps_qvga.png)"
  tile "$name, after" "$(echo "$folder/$name"/*_normal_space_qvga.png)"
}

# simulated SCENE SEED: what the camera sees, true planes, and those found.
simulated () {
  pcl_simulate_rgbd "$1" --seed "$2" --resolution qvga --output "$folder" >/dev/null
  tile "$1" "$folder/$1_$2_kinect_qvga_colour.png"
  tile "$1, truth" "$folder/$1_$2_kinect_qvga_planes.png"
  planes "$1" "sim:$1:$2"
}

simulated room 3
simulated table_cluttered 1
planes mosd_learn "$data/mosd_learn/learn20.pcd"
planes office1 "$data/kinect/office1.pcd"
planes TUM "$data/tum_fr3_structure_notexture_far"
planes icsl_corridor "$data/icsl_corridor/depth" \
  --intrinsics 537.60,539.03,316.15,245.52 --depth-scale 1000
planes icl_office_kt0 "$data/icl_office_kt0/depth" \
  --intrinsics 481.2,480.0,319.5,239.5 --depth-scale 5000
planes synpeb "$data/synpeb"
planes five_people "$data/kinect/five_people.pcd"
planes robot_floor "$data/robot_floor/depth" \
  --intrinsics 383.8,383.8,321.7,236.8 --depth-scale 1000 --depth-noise active_stereo

gnuplot "$sheet"
mv "$folder/sheet.png" "$picture"
