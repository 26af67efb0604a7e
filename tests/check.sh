#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the Traverse authors
# SPDX-License-Identifier: BSD-3-Clause
# Format, sizes, licences, generated docs, tidy: what CI checks beside the tests. Usage: check.sh BUILD_DIR
set -euo pipefail
build=${1:?"usage: check.sh BUILD_DIR"}
mapfile -t sources < <(git ls-files '*.cpp' '*.h')
bad=0
complain() { printf '%s\n' "$*" >&2; bad=1; }

echo "format: ${#sources[@]} files"
clang-format --dry-run --Werror "${sources[@]}" || complain "format: run clang-format -i on the files above"

for file in "${sources[@]}"; do
  lines=$(wc -l <"$file")
  [ "$lines" -le 300 ] || complain "$file: $lines lines; the limit is 300 (doc/conventions.md)"
  head -n 2 "$file" | grep -q SPDX-License-Identifier || complain "$file: no SPDX lines at the top"
done

echo "generated docs"
"$build/bin/traverse-map" --print-defaults | cmp - ini/reference.ini ||
  complain "ini/reference.ini is stale: build/release/bin/traverse-map --print-defaults > ini/reference.ini"
"$build/bin/traverse-map" --print-options | cmp - doc/options.md ||
  complain "doc/options.md is stale: build/release/bin/traverse-map --print-options > doc/options.md"

mapfile -t units < <(git ls-files '*.cpp')
echo "tidy: ${#units[@]} files"
printf '%s\n' "${units[@]}" | xargs -P "$(nproc)" -n 2 clang-tidy -p "$build" --quiet 2> >(grep -v 'warnings generated' >&2) ||
  complain "tidy: see above"
exit $bad
