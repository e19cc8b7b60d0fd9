#!/usr/bin/env bash
# Makes the committed figures in benches/figures anew, in less than ten minutes on an idle machine of two cores: the
# diagrams and tables of `polhode bench` and `polhode stress`, the targets of speed, and what each skip of the plan is worth.
#
#   benches/figures.sh                  into benches/figures
#   benches/figures.sh --quick FOLDER   shorter and into another folder, to see that it works
set -euo pipefail
cd "$(dirname "$0")/.."
quick=()
if [ "${1:-}" = --quick ]; then
    quick=(--quick)
    shift
fi
out=${1:-benches/figures}
mkdir -p "$out"

cargo build --release
polhode=target/release/polhode
# A minute is enough for curves: the least time of many short runs.
"$polhode" bench --quick --jacobian --diagrams "$out" --costs "$out/costs.toml" --out "$out/work-precision.txt"
"$polhode" bench --ensemble "${quick[@]}" --out "$out/ensemble.txt"
"$polhode" stress --quick --diagrams "$out" --out "$out/stability.txt"

# Without the verifier, which has no part in it and takes long to build.
bench=(cargo bench --no-default-features --features batch,bench)
"${bench[@]}" --bench targets -- "${quick[@]}" >"$out/targets.txt"
"${bench[@]}" --bench laws >"$out/laws.txt"
"${bench[@]}" --bench skips -- --output-format bencher --warm-up-time 0.3 --measurement-time 1 |
    sed -n 's/^test \(.*\) \.\.\. bench: *\([0-9,]*\) ns.*/\2 ns\t\1/p' >"$out/skips.txt"
for table in ensemble targets laws skips; do
    echo
    cat "$out/$table.txt"
done
