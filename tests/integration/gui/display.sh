# SPDX-FileCopyrightText: 2026 the Traverse authors
# SPDX-License-Identifier: BSD-3-Clause
# Sourced: starts an X server of its own whose picture is ./Xvfb_screen0 (XWD), stops all at the end.
set -eu
export HOME=$PWD  # the programs keep settings: each run starts as the first one
Xvfb -displayfd 9 -screen 0 1280x900x24 -fbdir . 9> display.txt > xvfb.log 2>&1 &
server=$!
program=
finish() {
  if [ -n "$program" ]; then kill "$program" 2> /dev/null || true; fi
  kill "$server" 2> /dev/null || true
  wait 2> /dev/null || true
}
trap finish EXIT

# within SECONDS COMMAND...: repeats the command until it succeeds.
within() {
  local left=$(($1 * 2))
  shift
  until "$@" > /dev/null 2>&1; do
    left=$((left - 1))
    if [ "$left" -le 0 ]; then echo "gave up waiting for: $*" >&2; return 1; fi
    sleep 0.5
  done
}
within 20 test -s display.txt
export DISPLAY=":$(cat display.txt)"
