#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the Traverse authors
# SPDX-License-Identifier: BSD-3-Clause
# Runs the benchmarks of one room, or of all, and prints each peer's time over ours; SKIPPED where data is missing,
# WRONG where an answer is. Usage: run.sh BIN_DIR [ROOM]
set -euo pipefail
bin=${1:?"usage: run.sh BIN_DIR [ROOM]"}
shopt -s nullglob
programs=("$bin"/bench_"${2:-}"*)
[ ${#programs[@]} -gt 0 ] || { echo "no benchmark of room '${2:-}'" >&2; exit 2; }
for program in "${programs[@]}"; do
  echo "== ${program##*/bench_}"
  "$program" --benchmark_repetitions=7 --benchmark_enable_random_interleaving=true \
    --benchmark_report_aggregates_only=true --benchmark_format=csv 2>/dev/null |
    awk -F, '/^(SKIPPED|WRONG): / { print } /_median"/ { gsub(/"|_median/, "", $1); time[$1] = $4; unit = $5; order[++n] = $1 }
      END { for (i = 1; i <= n; i++) printf "%-24s %12.1f %s   %.2f x ours\n", order[i], time[order[i]], unit, time[order[i]] / time["ours"] }'
done
