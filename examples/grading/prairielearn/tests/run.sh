#!/usr/bin/env bash
# Marks one submission. PrairieLearn puts it into student/, this folder into tests/, and reads results/results.json.
# The image that info.json names needs polhode on its path.
set -eu
root="${GRADE_ROOT:-/grade}"
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/class" "$root/results"
# Links stay links, and are not followed.
cp -RP "$root/student" "$work/class/student"
ulimit -v 4000000 -t 25
status=0
polhode grade "$root/tests/key.md" "$work/class" --out "$work/marked" --threads 1 --gradebook prairielearn || status=$?
# 3: a person should look. The results then cost the student no attempt.
if [ "$status" -ne 0 ] && [ "$status" -ne 3 ]; then exit "$status"; fi
cp "$work/marked/prairielearn/student/results/results.json" "$root/results/results.json"
