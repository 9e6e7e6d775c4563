# shellcheck shell=bash
# SPDX-License-Identifier: BSD-3-Clause
# Sourced by scripts/test: builds and runs under gcc's sanitizers, and the check of the One Definition Rule beside them.
# shellcheck disable=SC2034,SC2154  # variables of the script that sources it, and for it

# use_sanitizers KIND[,KIND]: a build of its own, and what its programs are told.
use_sanitizers() {
  local kinds=$1 kind flags='' libraries='' suppressions=$repo_dir/test/sanitizers
  if [ "$kinds" = odr ]; then
    use_odr_check
    return
  fi
  for kind in ${kinds//,/ }; do
    case $kind in
      thread | address) flags+=" -fsanitize=$kind" libraries+=":lib${kind:0:1}san.so" ;;
      undefined) flags+=' -fsanitize=undefined,float-cast-overflow' libraries+=':libubsan.so' ;;
      *) flags='' && break ;;
    esac
  done
  if [ -z "$flags" ] || [[ $kinds == *thread*address* || $kinds == *address*thread* ]]; then
    fail "--sanitize needs thread, address, undefined, address,undefined or odr"
  fi
  use_build_folder "sanitize-${kinds//,/-}"
  # target_clones are resolved before a sanitizer is ready. Assertions stay in: no -DNDEBUG. With AddressSanitizer Eigen
  # would align what it allocates itself, as PCL's libraries, which free it, do not.
  # Python is not instrumented and would be needed to load the module.
  cmake_options=(-DCMAKE_BUILD_TYPE=Sanitize -DWITH_PYTHON=OFF
    "-DCMAKE_CXX_FLAGS_SANITIZE=-O1 -g1 -fno-omit-frame-pointer$flags -DOBJECTNESS_PORTABLE -DEIGEN_MALLOC_ALREADY_ALIGNED=1"
    "-DCMAKE_EXE_LINKER_FLAGS_SANITIZE=$flags" "-DCMAKE_SHARED_LINKER_FLAGS_SANITIZE=$flags")

  # Every process leaves its reports in a file: tools and nodelet managers that a test starts are looked at, too.
  reports_dir=$build_dir/reports
  local report=log_path=$reports_dir/report:handle_segv=0  # some tests end a process by SIGSEGV
  export TSAN_OPTIONS=$report:suppressions=$suppressions/thread.txt:ignore_noninstrumented_modules=1:second_deadlock_stack=1
  # PCL's libraries, which are C++14, allocate clouds by malloc for their alignment's sake; C++17 has operator new and
  # delete for that, by which our side of the header frees them. In glibc the one is the other.
  export ASAN_OPTIONS=$report:detect_stack_use_after_return=1:check_initialization_order=1:alloc_dealloc_mismatch=0
  export LSAN_OPTIONS=$report:suppressions=$suppressions/address.txt:print_suppressions=0
  # Beside AddressSanitizer UBSan writes to standard error whatever the path: it must end the process to be seen.
  export UBSAN_OPTIONS=$report:suppressions=$suppressions/undefined.txt:print_stacktrace=1:halt_on_error=1
  # ROS's own nodelet manager is not instrumented, but has to load a library that is.
  local preload='' library
  for library in ${libraries//:/ }; do preload+=${preload:+:}$(g++ -print-file-name="$library"); done
  export OBJECTNESS_MANAGER_PREFIX="env LD_PRELOAD=$preload"
}

# A build for link-time optimization: only its link sees the types of all files together. Nothing of it is run, so it is
# not optimized.
use_odr_check() {
  use_build_folder sanitize-odr
  cmake_options=(-DCMAKE_BUILD_TYPE=Odr -DPRECOMPILE_HEADERS=OFF -DCMAKE_AR=/usr/bin/gcc-ar -DCMAKE_RANLIB=/usr/bin/gcc-ranlib
    "-DCMAKE_CXX_FLAGS_ODR=-O0 -flto=$(nproc) -fno-fat-lto-objects -DOBJECTNESS_PORTABLE")
}

# link_odr OBJECT...: merges the objects of all programs into one, without making code of it; so a name cannot be two types
# in two programs either.
link_odr() {
  g++ -O0 -flto -r -flinker-output=rel -z muldefs -Werror=odr -Werror=lto-type-mismatch -o "$build_dir/all.o" "$@"
}

# Fails when a type is defined in two ways, or a function or variable declared in two.
check_odr() {
  local objects probe=$build_dir/probe code=0
  # A compiler that does not see this does not see anything.
  mkdir -p "$probe"
  for fields in 'int a' 'double b, c'; do
    echo "struct Probe { $fields; }; int main() { Probe probe{}; return reinterpret_cast<char*>(&probe)[0]; }" |
      g++ -O0 -flto -fno-fat-lto-objects -x c++ -c - -o "$probe/${fields%% *}.o"
  done
  if link_odr "$probe"/*.o >"$log_dir/probe.log" 2>&1 || ! grep -q '=odr]' "$log_dir/probe.log"; then
    fail "the compiler does not find a made-up violation" "Its output: $log_dir/probe.log"
  fi
  mapfile -t objects < <(find "$build_dir" -name '*.o' -path '*.dir/*' ! -path '*/gtest*' ! -path '*/gmock*' | sort)
  quietly odr link_odr "${objects[@]}" || code=$?
  [ $code -ne 0 ] || say "One definition of every type in ${#objects[@]} object files"
  return $code
}

# Fails when any process has left a report.
check_reports() {
  local reports report
  reports=$(find "$reports_dir" -type f -size +0 | sort)
  [ -n "$reports" ] || return 0
  say "Reports of the sanitizer:"
  while read -r report; do
    say "$report: $(grep -m 1 -E 'ERROR|WARNING|runtime error|SUMMARY' "$report" || head -n 1 "$report")"
  done <<<"$reports"
  return 1
}
