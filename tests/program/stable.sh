#!/usr/bin/env bash
# The coupled step stays bounded while a block breaks up, down to single particles, and the box's momentum balance
# closes in every sample. With the probe's added mass treated explicitly, or with probes on particles without bonds,
# these runs diverge within 100 steps.
. "$(dirname "$0")/common.sh" "$@"
scene | sed -e '/name: fracture/s/steps: [0-9]*/steps: 240/' -e 's/fields_every: .*/fields_every: 0/' >scene.yaml
for energy in 1.0e-3 1.0e-4 1.0e-5; do
  code 0 ranks 1 run scene.yaml --out g$energy --set "solid.materials[0].fracture_energy=$energy"
  awk -F, -v g=$energy '
    NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
    NR > 2 { if ($at["momentum_residual"] > 1e-6) { print "momentum_residual", $at["momentum_residual"]; bad = 1 }
      if ($1 > 60) { dp = $at["dp"]; if (dp < 0) dp = -dp; if (dp > 6000) { print "dp", dp; bad = 1 } } # 1100 Pa while the block is whole
      if ($at["e_kinetic_solid"] > 1e-3) { print "e_kinetic_solid", $at["e_kinetic_solid"]; bad = 1 } # 1e-4 J if the whole block moves at U_b
      fragments = $at["fragments"] }
    END { if (g < 5e-4 && fragments < 100) { print fragments " fragments: it has not come apart"; bad = 1 }; exit bad }' \
    g$energy/series.csv || fail "G0 = $energy"
done
echo ok
