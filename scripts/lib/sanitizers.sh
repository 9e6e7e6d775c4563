# shellcheck shell=bash
# SPDX-License-Identifier: BSD-3-Clause
# Sourced by scripts/test: builds and runs under one of gcc's sanitizers.

# use_sanitizer KIND: a build of its own, and what its programs are told.
use_sanitizer() {
  local kind=$1 flags library options
  case $kind in
    thread) flags=-fsanitize=thread library=libtsan.so ;;
    address) flags=-fsanitize=address library=libasan.so ;;
    undefined) flags=-fsanitize=undefined,float-cast-overflow library=libubsan.so ;;
    *) fail "--sanitize needs thread, address or undefined" ;;
  esac
  use_build_folder "sanitize-$kind"
  # target_clones are resolved before a sanitizer is ready. Assertions stay in: no -DNDEBUG.
  cmake_options=(-DCMAKE_BUILD_TYPE=Sanitize "-DCMAKE_CXX_FLAGS_SANITIZE=-O1 -g1 -fno-omit-frame-pointer $flags -DOBJECTNESS_PORTABLE")
  for kind_of_binary in EXE SHARED; do cmake_options+=("-DCMAKE_${kind_of_binary}_LINKER_FLAGS_SANITIZE=$flags"); done

  reports_dir=$build_dir/reports
  # Every process leaves its reports in a file: tools and nodelet managers that a test starts are looked at, too.
  options=log_path=$reports_dir/report:suppressions=$repo_dir/test/sanitizers/$kind.txt
  export TSAN_OPTIONS=$options:ignore_noninstrumented_modules=1:second_deadlock_stack=1:history_size=4
  export ASAN_OPTIONS=log_path=$reports_dir/report:detect_stack_use_after_return=1:check_initialization_order=1
  export LSAN_OPTIONS=suppressions=$repo_dir/test/sanitizers/$kind.txt:print_suppressions=0
  export UBSAN_OPTIONS=$options:print_stacktrace=1
  # ROS's own nodelet manager is not instrumented, but has to load a library that is.
  OBJECTNESS_MANAGER_PREFIX="env LD_PRELOAD=$(g++ -print-file-name=$library)"
  export OBJECTNESS_MANAGER_PREFIX
}

# Fails when any process has left a report.
check_reports() {
  local reports
  reports=$(find "$reports_dir" -type f -size +0 | sort)
  [ -n "$reports" ] || return 0
  say "Reports of the sanitizer:"
  while read -r report; do
    say "$report: $(grep -m 1 -E 'ERROR|WARNING|runtime error|SUMMARY' "$report" || head -n 1 "$report")"
  done <<<"$reports"
  return 1
}
