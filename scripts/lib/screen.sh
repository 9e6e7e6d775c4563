# shellcheck shell=bash
# SPDX-License-Identifier: BSD-3-Clause
# Sourced by scripts/demo: a screen where there is none, and pictures of it.
# shellcheck disable=SC2034  # variables for the script that sources it

# A picture of rviz has thousands of colours as soon as a cloud is drawn, an empty one some 800.
least_colors=2000

# A name in DISPLAY is no display yet: over ssh or in a container there is often nobody behind it.
has_display() {
  [ -n "${DISPLAY:-}" ] && /usr/bin/python3 -c '
import ctypes, sys
x11 = ctypes.CDLL("libX11.so.6")
x11.XOpenDisplay.restype = ctypes.c_void_p
sys.exit(0 if x11.XOpenDisplay(None) else 1)' 2>/dev/null
}

# until_seconds LIMIT COMMAND...: runs the command every half second until it succeeds; false when the time is over.
until_seconds() {
  local end=$((SECONDS + $1))
  shift
  until "$@"; do
    [ $SECONDS -lt $end ] || return 1
    sleep 0.5
  done
}

is_gone() { ! kill -0 "$1" 2>/dev/null; }

# end_process PID SIGNAL LIMIT: asks, and after LIMIT seconds insists.
end_process() {
  kill -"$2" "$1" 2>/dev/null || return 0
  until_seconds "$3" is_gone "$1" || kill -KILL "$1" 2>/dev/null || true
  wait "$1" 2>/dev/null || true
}

# start_screen LOG: sets DISPLAY to a new screen in memory and screen_pid to its server; false when it cannot start.
start_screen() {
  local number_file
  number_file=$(mktemp)
  Xvfb -displayfd 3 -screen 0 1280x800x24 -nolisten tcp 3>"$number_file" >"$1" 2>&1 &
  screen_pid=$!
  until_seconds 20 test -s "$number_file" || { rm -f "$number_file"; return 1; }
  DISPLAY=:$(tr -d '[:space:]' <"$number_file")
  rm -f "$number_file"
  # Drawn by the processor, whatever graphics card there is.
  export DISPLAY LIBGL_ALWAYS_SOFTWARE=1 QT_X11_NO_MITSHM=1
}

# take_picture FILE: of the whole screen; false while it shows no cloud.
take_picture() {
  local colors
  timeout 20 import -window root "$1" 2>/dev/null || return 1
  colors=$(timeout 20 convert "$1" -format %k info: 2>/dev/null) || return 1
  [ "${colors:-0}" -ge $least_colors ]
}
