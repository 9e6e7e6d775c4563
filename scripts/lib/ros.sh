# shellcheck shell=bash
# SPDX-License-Identifier: BSD-3-Clause
# Sourced by common.sh: the ROS 1 that everything is built with.

# The folder that ROS is installed into beside a system's own packages: one folder for each distribution of ROS 1 (noetic,
# one) and of ROS 2 (humble, jazzy).
opt_ros=${OBJECTNESS_OPT_ROS:-/opt/ros}

# Only ROS 1 comes with catkin.
is_ros1() { [ -e "$1/setup.bash" ] && [ -e "$1/share/catkin/cmake/catkinConfig.cmake" ]; }

# Sets ros_name to the distribution in $opt_ros that is taken, empty for Debian's own packages, and ros_choice to the
# distributions that there were to choose from. The sourced one is taken; else the last by name, which is the newest.
choose_ros() {
  local prefix sourced root
  ros_name='' ros_choice=()
  for prefix in "$opt_ros"/*; do
    ! is_ros1 "$prefix" || ros_choice+=("${prefix##*/}")
  done
  # ROS_DISTRO is Debian in a workspace of Debian's own packages.
  if [ ${#ros_choice[@]} -eq 0 ] || [[ ${ROS_DISTRO:-} == [Dd]ebian ]]; then return; fi
  ros_name=${ros_choice[-1]}
  root=${ROS_ROOT:-}
  root=${root#"$opt_ros"/}
  # Only ROS 1 sets ROS_ROOT: it counts where a ROS 2 was sourced after it.
  for sourced in "${ROS_DISTRO:-}" "${root%%/*}"; do
    if [ -n "$sourced" ] && is_ros1 "$opt_ros/$sourced"; then ros_name=$sourced; fi
  done
}

# remove_paths VARIABLE FOLDER...: takes what lies in the folders out of a list of paths.
remove_paths() {
  local variable=$1 entry folder kept='' entries
  shift
  IFS=: read -r -a entries <<<"${!variable:-}"
  for entry in "${entries[@]}"; do
    for folder; do
      [[ $entry/ != "$folder"/* ]] || continue 2
    done
    kept+=${kept:+:}$entry
  done
  if [ -n "$kept" ]; then export "$variable=$kept"; else unset "$variable"; fi
}

# Leaves every ROS and workspace that was sourced. The paths of another one would mix other versions of the same packages
# in, and those of ROS 2 other packages and libraries of the same names (vision_msgs, libclass_loader).
leave_sourced_ros() {
  local prefix prefixes folders=("$opt_ros") variable
  IFS=: read -r -a prefixes <<<"${CMAKE_PREFIX_PATH:-}:${AMENT_PREFIX_PATH:-}:${COLCON_PREFIX_PATH:-}"
  for prefix in "${prefixes[@]}"; do
    # A prefix that is no workspace (/usr/local) may be in CMAKE_PREFIX_PATH, too.
    if [ -n "$prefix" ] && [ -e "$prefix/setup.bash" ]; then folders+=("${prefix%/}"); fi
  done
  for variable in PATH LD_LIBRARY_PATH PKG_CONFIG_PATH; do
    remove_paths $variable "${folders[@]}"
  done
  unset PYTHONHOME PYTHONPATH CMAKE_PREFIX_PATH AMENT_PREFIX_PATH COLCON_PREFIX_PATH
  unset ROS_PACKAGE_PATH ROS_ROOT ROS_ETC_DIR ROS_DISTRO ROS_VERSION ROS_PYTHON_VERSION
}

# Enters the chosen ROS; Debian's needs nothing.
enter_ros() {
  [ -n "$ros_name" ] || return 0
  if [ ${#ros_choice[@]} -gt 1 ]; then
    say "ROS 1 of $opt_ros/$ros_name; there are: ${ros_choice[*]}. The setup.bash that is sourced decides."
  fi
  source_setup "$opt_ros/$ros_name/setup.bash"
}

# built_with_other_ros CACHE: whether a CMakeCache.txt is of another ROS than the chosen one. What CMake has found once it
# does not look for again.
built_with_other_ros() {
  local catkin
  catkin=$(sed -n 's|^catkin_DIR:PATH=||p' "$1")
  if [ -z "$catkin" ] || [[ $catkin == *-NOTFOUND ]]; then return 1; fi
  if [ -n "$ros_name" ]; then [[ $catkin != "$opt_ros/$ros_name"/* ]]; else [[ $catkin == "$opt_ros"/* ]]; fi
}
