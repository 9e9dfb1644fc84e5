#!/usr/bin/env bash
# Opening of a Griffith crack and of a penny-shaped crack under pressure, and the pressure at which the Griffith crack
# runs.
# usage: cases/verification/penny_crack/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
if [ "$quick" ]; then name=study; else name=study_fine; fi
study $name
opening=$(cell $name value "m = 3" 6 opening)
if [ "$quick" ]; then # twice the tolerance at a = 12 spacings
  near "plate: a = 6 spacings: opening over p a/E" 1 "$opening" 3.75 "4 (1 - nu^2)" 0.2
else
  shown "plate: a = 6 spacings: opening over p a/E" 1 "$opening" 3.75 "4 (1 - nu^2)"
fi
if [ "$quick" ]; then name=study_initiation sizes=6; else name=study_initiation_fine sizes="6 12"; fi
study $name
for a in $sizes; do
  judge=(shown)
  [ "$a" != 12 ] || judge=(near 0.12)
  "${judge[0]}" "plate: a = $a spacings: pressure at which the first bond breaks over Griffith's" 1 \
    "$(cell $name value "m = 3" "$a" "first bond")" 1 "sqrt(E G0/(pi (1 - nu^2) a))" "${judge[@]:1}"
  near "plate: a = $a spacings: pressure at which the crack has run on by three spacings over the elastic one" 1 \
    "$(cell $name value "m = 3" "$a" "it runs")" 1 "Griffith with the pressure on the first lips" 0.12
done
# penny A B: the opening over p a/E
penny() {
  rm -rf "$runs/penny_$1_$2"
  awk -v a="$1" -v b="$2" -f "$here/penny.awk" >"$runs/penny_$1_$2.yaml"
  "$frana" run "$runs/penny_$1_$2.yaml" --out "$runs/penny_$1_$2" >"$runs/penny.log" 2>&1 ||
    { cat "$runs/penny.log" >&2; exit 1; }
  awk -F, -v a="$1" 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i } NR > 2 { u[$3] = $at["displacement_z"] }
    END { printf "%.10g\n", (u[0] - u[1]) / (1e-6 * a) }' "$runs/penny_$1_$2/probes.csv"
}
shown "penny: a = 6 spacings in a cube of 6 a: opening over p a/E" 1 "$(kept "penny 6 18" penny 6 18)" 2.3873 \
  "8 (1 - nu^2)/pi"
if [ ! "$quick" ]; then
  near "plate: a = 12 spacings: opening over p a/E" 1 "$(cell study_fine value "m = 3" 12 opening)" 3.75 \
    "4 (1 - nu^2)" 0.1
  row "plate: m = 3: order of the opening to a = 12 spacings" 1 "$(cell study_fine order "m = 3" 12 opening)" 1 \
    "delta-convergence" 0.8 1.3
  study study_horizon
  for m in 2 4; do
    shown "plate: m = $m: a = 6 spacings: opening over p a/E" 1 "$(cell study_horizon value "m = $m" 6 opening)" 3.75 \
      "4 (1 - nu^2)"
  done
  study study_wide
  shown "plate: a = 6 spacings: opening with b = 5 a over that with b = 10 a" 1 \
    "$(calc "$(cell study_wide value "m = 3" 5 opening) / $(cell study_wide value "m = 3" 10 opening)")" 1 \
    "what the plate's sides do"
  shown "penny: a = 6 spacings in a cube of 10 a: opening over p a/E" 1 "$(kept "penny 6 30" penny 6 30)" 2.3873 \
    "8 (1 - nu^2)/pi"
  near "penny: a = 12 spacings in a cube of 6 a: opening over p a/E" 1 "$(kept "penny 12 36" penny 12 36)" 2.3873 \
    "8 (1 - nu^2)/pi" 0.1
fi
finish
