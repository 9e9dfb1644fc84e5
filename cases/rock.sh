# shellcheck shell=bash
# shellcheck disable=SC2154 # again, frana, here, runs, out: of cases/verification/common.sh
# What the cases of porous samples share: the run in which a flow breaks the sample. Sourced by bash.

# broken: runs break.yaml of this case, unless that is done already, and keeps its series, plots and numbers: before
# fracture, at its last settled sample, and at the end.
broken() {
  local run=$runs/break name
  if [ ! "$again" ]; then
    if ! is_done "$run"; then
      rm -rf "${run:?}"
      "$frana" run "$here/break.yaml" --out "$run" >"$runs/break.log" 2>&1 || { cat "$runs/break.log" >&2; exit 1; }
    fi
    [ "$run/post/report.html" -nt "$run/run.json" ] || "$frana" post "$run" >"$runs/post.log" 2>&1
    cp "$run/series.csv" "$out/break_series.csv"
    for name in permeability porosity fragments pdf_von_mises pdf_stress; do
      cp "$run/post/plots/$name.png" "$out/break_$name.png"
    done
    cp "$run/post/pictures/flow_lines.png" "$out/break.png"
  fi
  for name in permeability porosity porosity_effective velocity_x; do
    shown "broken: $name before fracture" "$(unit_of $name)" "$(sample before $name)" "" ""
    shown "broken: $name at the end" "$(unit_of $name)" "$(sample end $name)" "" ""
  done
  shown "broken: share of bonds broken" 1 \
    "$(calc "$(sample end bonds_broken) / ($(sample end bonds_broken) + $(sample end bonds_intact))")" "" ""
  shown "broken: fragments at the end" 1 "$(sample end fragments)" "" ""
  shown "broken: particles washed out of the domain" 1 "$(sample end particles_outside)" "" ""
}
# sample before|end COLUMN: of the series, at the last sample without a broken bond or the last one of all
sample() {
  awk -F, -v when="$1" -v name="$2" '
    NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
    NR > 2 && (when == "end" || $at["bonds_broken"] == 0) { v = $at[name] } END { print v }' "$out/break_series.csv"
}
unit_of() {
  awk -F, -v name="$1" '
    NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) c = i }
    NR == 2 { sub(/^#/, "", $c); print $c; exit }' "$out/break_series.csv"
}
