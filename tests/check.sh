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

# Parsing MRPT's headers costs 2 to 15 s a file: the whole set on files that the last commits changed
# (TRAVERSE_TIDY_SINCE names another start; 4b825dc is the empty tree), naming, size and complexity on the rest.
tidy() { xargs -r -P "$(nproc)" -n 2 clang-tidy -p "$build" --quiet "$@" 2>/dev/null; }
since=${TRAVERSE_TIDY_SINCE:-$(git rev-list --first-parent -n 4 HEAD | tail -n 1)}
not_built=(':!tests/arrows/probe.cpp' ':!tests/install/outside')
changed=$(git diff --name-only --diff-filter=d "$since" -- '*.cpp' "${not_built[@]}")
echo "tidy: everything in files changed since $since"
tidy <<<"$changed" || complain "tidy: see above"
echo "tidy: naming, size and complexity of all other files"
git ls-files '*.cpp' "${not_built[@]}" | grep -vxF "$changed" |
  tidy --checks='-*,readability-identifier-naming,readability-function-size,readability-function-cognitive-complexity' ||
  complain "tidy: see above"
exit $bad
