#!/bin/bash
# SPDX-FileCopyrightText: 2026 the Traverse authors
# SPDX-License-Identifier: BSD-3-Clause
# rawlog_viewer.sh PLUGIN LOG CLASS: makes a map of CLASS of LOG (in the present folder, writable) in
# stock RawLogViewer by its "Raw-map" window, and saves it as a .3Dscene beside the log.
. "$(dirname "$0")/display.sh"
RawLogViewer -l "$1" "$PWD/$2" > program.log 2>&1 &
program=$!
click() { xdotool mousemove "$1" "$2" click 1; }

within 120 xdotool search --name "Tip of the Day"
sleep 2
xdotool search --name "Tip of the Day" windowclose || true
sleep 2
click 225 60  # "Raw-map"...
within 30 xdotool search --name "Creation of"
sleep 2
click 700 200  # the ini text
sleep 0.5
xdotool key ctrl+a
sleep 0.5
xdotool type --delay 60 '[map]'
xdotool key Return
xdotool type --delay 60 "$3_count = 1"
xdotool key Return
sleep 1
click 160 192  # Map from odometry
sleep 8
click 330 243  # Save map as 3D scene...
within 30 xdotool search --name "Save as 3D scene"
sleep 2
xdotool key Return  # the name that it proposes, beside the log
within 30 sh -c 'ls *.3Dscene'
sleep 2
