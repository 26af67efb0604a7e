#!/bin/bash
# SPDX-FileCopyrightText: 2026 the Traverse authors
# SPDX-License-Identifier: BSD-3-Clause
# scene_viewer.sh PLUGIN SCENE: shows SCENE in stock SceneViewer3D; the screen stays in Xvfb_screen0.
. "$(dirname "$0")/display.sh"
SceneViewer3D -l "$1" "$2" > program.log 2>&1 &
program=$!
within 60 grep -q traverse_maps "/proc/$program/maps"
within 60 xdotool search --name "SceneViewer"
sleep 12
kill -0 "$program"
cp Xvfb_screen0 screen.xwd
