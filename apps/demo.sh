#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the Traverse authors
# SPDX-License-Identifier: BSD-3-Clause
# Maps from the three real logs of Debian's mrpt-common, into demo-output/. Usage: demo.sh BIN_DIR
set -euo pipefail
bin=${1:?"usage: demo.sh BIN_DIR"}
for log in vlp16 rgbd laser2d; do
  printf '\n== Mapping %s (ini/%s.ini)\n' "$log" "$log" >&2
  "$bin/traverse-map" "ini/$log.ini" --output "demo-output/$log" --force >/dev/null
done
printf '\nPictures and reports:\n'
ls -1 "$PWD"/demo-output/*/report.html "$PWD"/demo-output/*/*.png
printf '\nOpen a report in a browser, or a .3Dscene in SceneViewer3D.\n'
