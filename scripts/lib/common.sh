# shellcheck shell=bash
# SPDX-License-Identifier: BSD-3-Clause
# Sourced by the scripts beside this folder: where things are, clear failures, quiet long steps.

repo_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
scripts_dir=$repo_dir/scripts
build_dir=$repo_dir/build
log_dir=$build_dir/logs
cmake_options=()  # of one kind of build

# The system's own tools first: catkin's Python modules are there and not in a virtualenv's or conda's python.
export PATH=/usr/bin:/bin:/usr/sbin:/sbin:$PATH
. "$scripts_dir/lib/ros.sh"
choose_ros
leave_sourced_ros

say() { printf '%s\n' "$*"; }

fail() {
  printf '%s: %s\n' "$(basename "$0")" "$1" >&2
  shift
  [ $# -eq 0 ] || printf '  %s\n' "$@" >&2
  exit 1
}

# The comment at the head of the script that was called is its help.
show_help() { sed -n '3,/^$/{/^#/s/^# \{0,1\}//p}' "$0"; }

# parse_jobs_option ARGUMENT...: sets jobs, for scripts that have no other option.
parse_jobs_option() {
  jobs=''
  while [ $# -gt 0 ]; do
    case $1 in
      --jobs) jobs=${2:-}; check_jobs; shift ;;
      -h | --help) show_help; exit ;;
      *) fail "unknown option $1; see --help" ;;
    esac
    shift
  done
}

check_jobs() { [[ $jobs =~ ^[1-9][0-9]*$ ]] || fail "--jobs needs a number above 0"; }

# source_setup FILE: ROS's set-up files read variables that are not set.
source_setup() {
  set +eu
  # shellcheck disable=SC1090
  . "$1"
  set -eu
}

# quietly NAME COMMAND...: output into build/logs/NAME.log, its end shown when the command fails.
quietly() {
  local log=$log_dir/$1.log code=0
  shift
  mkdir -p "$log_dir"
  "$@" >"$log" 2>&1 </dev/null || code=$?
  [ $code -eq 0 ] && return
  tail -n 40 "$log" >&2
  printf '%s: failed (exit status %d); all of the output: %s\n' "$(basename "$0")" $code "$log" >&2
  return $code
}

# A compile of PCL or ROS headers takes up to 1 GB.
job_count() {
  local jobs available_kb cgroup_bytes
  jobs=$(nproc)
  available_kb=$(awk '/^MemAvailable:/ {print $2}' /proc/meminfo 2>/dev/null || true)
  cgroup_bytes=$(cat /sys/fs/cgroup/memory.max 2>/dev/null || true)
  case $cgroup_bytes in
    '' | *[!0-9]*) ;;
    *) [ -n "$available_kb" ] && [ $((cgroup_bytes / 1024)) -lt "$available_kb" ] && available_kb=$((cgroup_bytes / 1024)) ;;
  esac
  [ -z "$available_kb" ] || [ $((available_kb / 1048576)) -ge "$jobs" ] || jobs=$((available_kb / 1048576))
  [ "$jobs" -ge 1 ] || jobs=1
  say "$jobs"
}

# build_all TESTING JOBS TARGET...: TESTING is ON, or empty to leave an existing build directory as it is.
build_all() {
  local testing=$1 jobs=$2 cache=$build_dir/CMakeCache.txt
  shift 2
  "$scripts_dir/install_dependencies" ${testing:+--checks}
  enter_ros
  if [ -e "$cache" ]; then
    if ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$repo_dir" "$cache"; then
      say "The build directory was made for another place of this checkout: building anew."
      rm -rf "$build_dir"
    elif built_with_other_ros "$cache"; then
      say "The build directory was made with another ROS: building anew."
      rm -rf "$build_dir"
    fi
  fi
  if [ -z "$testing" ]; then
    testing=$(sed -n 's/^CATKIN_ENABLE_TESTING:BOOL=//p' "$cache" 2>/dev/null || true)
  fi
  say "Building with ${jobs:=$(job_count)} job(s) in $build_dir ..."
  # Both names: catkin asks for the one, packages that it finds for the other.
  quietly configure cmake -S "$repo_dir" -B "$build_dir" -DPYTHON_EXECUTABLE=/usr/bin/python3 \
    -DPython3_EXECUTABLE=/usr/bin/python3 -DCATKIN_ENABLE_TESTING="${testing:-OFF}" "${cmake_options[@]}"
  quietly build cmake --build "$build_dir" -j "$jobs" --target "$@"
}

# use_build_folder NAME: everything into build/NAME, beside the usual build.
use_build_folder() {
  build_dir=$repo_dir/build/$1
  log_dir=$build_dir/logs
}

# Environment of the devel space, with everything ROS writes kept in the build directory.
enter_devel_space() {
  source_setup "$build_dir/devel/setup.bash"
  export ROS_HOSTNAME=localhost ROS_HOME=$build_dir/ros_home
  unset ROS_IP
  mkdir -p "$ROS_HOME"
}
