#!/usr/bin/env bash
# frana permeability in creeping flow: exact and published values within its own error, any number of ranks, sides of
# every kind, samples that are cut, blocked or no medium.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
two_spheres 0 >spheres.yaml
zero() { [ "$(value "$1" "$2")" = 0 ] || fail "$2 of $1 is $(value "$1" "$2")"; }

# one simple cubic sphere: k = 2 a^2/(9 c K), K = 15.3995 at c = 0.343 (Zick and Homsy 1982), within the given error
one='solid.bodies=[{name: a, shape: sphere, centre: [0.51, 0.47, 0.5], radius: 0.43424534363}]'
code 0 ranks 1 permeability spheres.yaml --out sphere --set "$one"
for q in k_xx k_yy k_zz; do
  awk -v k="$(value sphere $q)" -v e="$(value sphere ${q}_error)" \
    'BEGIN { d = k - 0.00793338; exit !((d < 0 ? -d : d) <= e && e > 0 && e < 0.2 * k) }' || fail "$q of the sphere"
done
[ ! -e sphere/x ] || fail "runs in time were made"
grep -q 'Of the shapes, on the finer grid' sphere/permeability.txt || fail "the geometry is not said"

# the tensor is the same on any number of ranks, within the tolerance of the iteration, and near that of time steps
for n in 1 2 $(by_day "" 3); do
  code 0 ranks $n permeability spheres.yaml --out "ranks$n" --quick
  for q in k_xx k_yy k_zz; do close "$(value ranks$n $q)" "$(value ranks1 $q)" 1e-4; done
done
close "$(value ranks1 k_xy)" "$(value ranks1 k_yx)" 1e-12
[ "$(value ranks1 k_xx_error)" = nan ] || fail "an error of the grid from one grid"
if thorough; then
  code 0 ranks 2 permeability spheres.yaml --out stepped --stepped --set 'domain.cells=[24, 24, 24]'
  code 0 ranks 1 permeability spheres.yaml --out finer --quick --set 'domain.cells=[24, 24, 24]'
  for q in k_xx k_yy k_zz; do close "$(value finer $q)" "$(value stepped $q)" 0.05; done
fi

# an image of a slit of 6 voxels between walls of 2 and 4, and of a duct of 4 x 6: h^2/12 (1 + 2/n^2) on each grid
image() { # image FILE AWK-CONDITION: 8 x 12 x 10 voxels, 1 where it holds
  LC_ALL=C awk "BEGIN {
    for (k = 0; k < 10; k++) for (j = 0; j < 12; j++) for (i = 0; i < 8; i++) printf \"%d\", ($2) }" |
    tr 01 '\000\001' >"$1"
}
image slit.raw 'j < 2 || j >= 8'
sed -e 's/size: \[1, 1, 1\], cells: .*/size: [0.8, 1.2, 1.0], cells: [8, 12, 10]}/' -e '/name: b/d' \
  -e 's/{name: a.*/{name: a, shape: image, file: slit.raw, type: uint8, solid: [1], low: [0, 0, 0]}/' \
  -e 's/shape: image/&, size: [8, 12, 10], voxel: 0.1/' \
  -e 's/surface: shape, //; s/high: \[1, 1, 1\]/high: [0.8, 1.2, 1.0]/' spheres.yaml >slit.yaml
code 0 ranks 2 permeability slit.yaml --out slit
for q in x z; do
  close "$(value slit k_$q${q}_level_1)" "$(awk 'BEGIN { printf "%.15g", 0.36 / 12 * (1 + 2 / 36) / 2 }')" 1e-5
  close "$(value slit k_$q${q}_level_2)" "$(awk 'BEGIN { printf "%.15g", 0.36 / 12 * (1 + 2 / 144) / 2 }')" 1e-5
  awk -v k="$(value slit k_$q$q)" -v e="$(value slit k_$q${q}_error)" \
    'BEGIN { d = k - 0.015; exit !((d < 0 ? -d : d) <= e && e < 0.1 * k) }' || fail "k_$q$q of the slit"
done
for q in k_yy k_xy k_yx k_yz k_zy k_yy_error; do zero slit $q; done
[ "$(value slit leads_y)" = 0 ] || fail "the blocked axis"
grep -q 'k_yy = 0: blocked, no pores lead through along y' slit/permeability.txt || fail "the blocked axis is not said"
if grep -q WARNING slit/permeability.txt; then fail "a slit is no cut sample"; fi
grep -q '^Tortuosities: x 1, y blocked, z 1$' slit/permeability.txt || fail "tortuosities: $(cat slit/permeability.txt)"
if grep -qi 'nan' slit/permeability.txt; then fail "nan on the page"; fi
image thin.raw 'j < 5 || j > 5'
code 0 ranks 1 permeability slit.yaml --out thin --set solid.bodies.a.file=thin.raw
close "$(value thin k_xx_level_1)" "$(value thin k_xx_level_3 | awk '{ printf "%.15g", $1 * 3 / (1 + 2 / 9) }')" 1e-5
awk -v k="$(value thin k_xx)" -v e="$(value thin k_xx_error)" \
  'BEGIN { d = k - 0.01 / 144; exit !((d < 0 ? -d : d) <= 1e-4 * k && e > 0 && e < 0.1 * k) }' || fail "one voxel"
grep -q 'extrapolated from three grids' thin/permeability.txt || fail "the third grid is not said"
image stairs.raw '(i - j + 24) % 8 > 1' # a channel along [110], and nothing across it, on three grids
code 0 ranks 1 permeability slit.yaml --out stairs --set solid.bodies.a.file=stairs.raw \
  --set 'solid.bodies.a.crop={low: [0, 0, 0], high: [8, 8, 10]}' \
  --set 'domain={size: [0.8, 0.8, 1.0], cells: [8, 8, 10]}' \
  --set 'coupling.medium={low: [0, 0, 0], high: [0.8, 0.8, 1.0]}'
grep -q 'extrapolated from three grids' stairs/permeability.txt || fail "the stairs' third grid"
for q in k_xy k_yx k_yy; do close "$(value stairs $q)" "$(value stairs k_xx)" 1e-4; done
awk -v k="$(value stairs k_xx)" -v p="$(value stairs principal_3)" 'BEGIN { exit !(p > -1e-4 * k) }' ||
  fail "a principal value of $(value stairs principal_3)"
# voxels whose edges differ, 0.2 x 0.1 x 0.3: the same slit, and one whose long edges are across
sed -e 's/size: \[0.8, 1.2, 1.0\]/size: [1.6, 1.2, 3.0]/; s/voxel: 0.1/voxel: [0.2, 0.1, 0.3]/' \
  -e 's/high: \[0.8, 1.2, 1.0\]/high: [1.6, 1.2, 3.0]/; s/^solid:/&\n  spacing: 0.1/' slit.yaml >long.yaml
for n in 1 2; do
  code 0 ranks $n permeability long.yaml --out long$n
  for q in x z; do close "$(value long$n k_$q$q)" "$(value slit k_$q$q)" 1e-4; done
  zero long$n k_yy
done
image across.raw 'k < 4'
code 0 ranks "$(by_day 1 2)" permeability long.yaml --out across --set solid.bodies.a.file=across.raw
for q in x y; do
  close "$(value across k_$q${q}_level_1)" 0.171 1e-4 # 1.8^2/12 (1 + 2/36) 0.6
done
code 0 ranks 1 check long.yaml
grep -q 'of 0.2 x 0.1 x 0.3 m; in the file' out || fail "$(cat out)"
grep -q '2, 1 and 3 along the edges of a voxel' out || fail "$(cat out)"
grep -q 'frana run refuses the scene, frana permeability solves the creeping flow' out || fail "$(cat out)"
grep -q 'at once    frana permeability solves about 480 pore cells' out || fail "$(cat out)"
code 2 ranks 1 run long.yaml --out long_run
grep -q 'needs cells of the same size in all directions; frana permeability solves' err || fail "$(cat err)"
code 2 ranks 1 permeability long.yaml --out no --set 'solid.spacing=0.2'
grep -q 'must each be solid.spacing (0.2 m) times 1, 2, 3 ... 64; solid.spacing: 0.1 fits' err || fail "$(cat err)"
code 2 ranks 1 permeability long.yaml --out no --set 'solid.bodies.a.voxel=[0.2, 0.1, 0.314159265]'
grep -q 'no spacing fits 0.2, 0.1 and 0.314159 m: resample the image to voxels that are cubes' err || fail "$(cat err)"
printf '%s\n' 'NDims = 3' 'DimSize = 8 12 10' 'ElementType = MET_UCHAR' 'ElementSpacing = 2 1 3' \
  'ElementDataFile = slit.raw' >s.mhd
code 0 ranks 1 permeability long.yaml --out header --quick --set solid.bodies.a.file=s.mhd
code 2 ranks 1 permeability slit.yaml --out no --set solid.bodies.a.file=s.mhd
grep -q 'one length, and the file has voxels of 2 x 1 x 3: give the three, as in voxel: \[x, y, z\]' err ||
  fail "$(cat err)"
image closed.raw 'k == 0 || j == 0 || i == 0'
code 0 ranks 1 permeability slit.yaml --out closed --set solid.bodies.a.file=closed.raw
for q in k_xx k_yy k_zz principal_1; do zero closed $q; done

# as the stairs of a smooth solid: the same along a slit, and more past the edges of columns
for q in x z; do close "$(value slit k_$q${q}_smooth)" "$(value slit k_$q${q}_level_1)" 1e-5; done
image columns.raw '(i == 2 || i == 3) && (j == 4 || j == 5)'
code 0 ranks 1 permeability slit.yaml --out columns --set solid.bodies.a.file=columns.raw
close "$(value columns k_zz_smooth)" "$(value columns k_zz_level_1)" 1e-3 # no flow across edges
awk -v s="$(value columns k_yy_smooth)" -v k="$(value columns k_yy_level_1)" \
  'BEGIN { exit !(s > 1.1 * k && s < 2 * k) }' ||
  fail "k_yy past columns: $(value columns k_yy_level_1), smooth $(value columns k_yy_smooth)"
grep -q 'Of a smooth solid whose stairs the voxels are' columns/permeability.txt || fail "the smooth solid is not said"

# a sample that was cut: pores shut at the sides are said, and are open in its mirror image and between pressures
image cut.raw '!(i > 0 && (j + i == 6 || j + i == 7 || (j == 7 && i < 4)) || j == 10 && k < 3)'
cut=(--set solid.bodies.a.file=cut.raw --quick)
code 0 ranks 1 permeability slit.yaml --out cut "${cut[@]}"
if grep -q smooth cut/permeability.csv; then fail "--quick solves twice"; fi
grep -q 'WARNING: this sample is cut' cut/permeability.txt || fail "a cut sample is not said"
awk -v m="$(value cut meets_x)" 'BEGIN { exit !(m < 0.5) }' || fail "pores that meet: $(value cut meets_x)"
code 0 ranks 1 permeability slit.yaml --out mirrored "${cut[@]}" --set solid.bodies.a.mirror=xyz \
  --set 'domain={size: [1.6, 2.4, 2.0], cells: [16, 24, 20]}' \
  --set 'coupling.medium={low: [0, 0, 0], high: [1.6, 2.4, 2.0]}'
if grep -q WARNING mirrored/permeability.txt; then fail "a mirrored sample is no cut one"; fi

# sides of given pressure with walls across: parts off the diagonal are not measured; a slit as between periodic sides
sed -e '/driving/d' -e 's/z_low: .*/z_low: {type: pressure, pressure: 1.0e-6}/' \
  -e 's/z_high: .*/z_high: {type: pressure}/' -e 's/x_\(low\|high\): .*/x_\1: {type: wall}/' slit.yaml >walls.yaml
code 0 ranks "$(by_day 1 2)" permeability walls.yaml --out walls --set solid.bodies.a.file=cut.raw
[ "$(value walls k_xz)" = nan ] || fail "k_xz = $(value walls k_xz) across walls"
sed -e 's/{type: wall}/{type: slip}/' walls.yaml >slip.yaml
code 0 ranks "$(by_day 1 2)" permeability slip.yaml --out slip
close "$(value slip k_zz)" "$(value slit k_zz)" 1e-4
close "$(value slip k_xx)" "$(value slit k_xx)" 1e-4
zero slip k_yy

# layers of open fluid before and behind the spheres along z: along z the whole driving drops over the sample
layers=(--set 'domain={size: [1, 1, 1.5], cells: [24, 24, 36]}'
  --set 'coupling.medium={low: [0, 0, 0.25], high: [1, 1, 1.25]}'
  --set 'solid.bodies.a.centre=[0.33, 0.41, 0.7]' --set 'solid.bodies.b.centre=[0.72, 0.77, 0.85]')
code 0 ranks "$(by_day 1 2)" permeability spheres.yaml --out layers --quick "${layers[@]}"
grep -q 'the two halves of the tensor differ by up to' layers/permeability.txt || fail "the asymmetry is not said"
if grep -q 'two halves' ranks1/permeability.txt; then fail "a periodic sample's tensor is symmetric"; fi
if thorough; then
  code 0 ranks 2 run spheres.yaml --out layers_stepped "${layers[@]}" --set 'stages.flow.until={change: 1.0e-4}' \
    --set 'fluid.driving={type: pressure_gradient, direction: z, value: 1.0e-6}'
  close "$(value layers k_zz)" "$(awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "permeability") c = i }
    END { print $c }' layers_stepped/series.csv)" 0.05
fi

# what is no medium is refused, and what is stopped keeps nothing
refused() {
  local sentence=$1; shift
  code 2 ranks 1 "$@" --out refused
  grep -qF "$sentence" err || { cat err >&2; fail "not said: $sentence"; }
  [ ! -e refused ] || fail "a folder was made: $sentence"
}
# fields and pictures where they are asked for
[ ! -e slit/fields ] && [ ! -e slit/pictures ] || fail "fields that nobody asked for"
code 0 ranks 2 permeability slit.yaml --out pictured --quick --fields
[ -s pictured/fields/flow_x.hdf ] && [ -s pictured/fields/flow_z.hdf ] && [ ! -e pictured/fields/flow_y.hdf ] ||
  fail "fields: $(ls pictured/fields)"
[ -s pictured/pictures/flow_x_pressure.gp ] && [ -s pictured/pictures/flow_z_speed.gp ] || fail "no pictures"
code 2 ranks 1 permeability spheres.yaml --out no --stepped --fields
grep -q -- '--fields: only where the flow is solved at once' err || fail "$(cat err)"

# what it takes is said before it is taken, and by check
code 0 ranks 1 permeability slit.yaml --out forecast --quick
grep -q '8 x 12 x 10 cells, 480 of pore: at most 0.12 MB of memory, about ' out || fail "$(cat out)"
code 0 ranks 1 check slit.yaml
grep -q 'at once    frana permeability solves about 480 pore cells' out || fail "$(cat out)"
grep -q 'the other lines are of frana run, which steps the flow in time' out || fail "$(cat out)"

refused "fluid passes beside the sample, so it has no permeability along x" permeability spheres.yaml \
  --set 'coupling.medium={low: [0, 0.2, 0.2], high: [0.9, 0.8, 0.8]}'
refused "beside the box along z there is solid" permeability spheres.yaml \
  --set 'coupling.medium={low: [0, 0, 0.25], high: [1, 1, 0.75]}'
refused "nothing resists the flow" permeability spheres.yaml --set 'domain.cells=[2, 2, 2]' --set solid.spacing=0.05 \
  --set 'solid.bodies=[{name: a, shape: sphere, centre: [0.5, 0.5, 0.5], radius: 0.2}]'
code 75 ranks 1 permeability spheres.yaml --out stopped --max-wall 0.001
[ ! -e stopped ] || fail "something was kept of what was stopped"
rm -f out # of the last command, whose text must not be taken for this one's
"$frana" permeability spheres.yaml --out stopped --set 'domain.cells=[96, 96, 96]' >out 2>err &
pid=$!
await $pid grep -qs 'of pore' out || fail "it ended before: $(cat out err)"
kill -TERM $pid
got=0
wait $pid || got=$?
[ "$got" = 75 ] || fail "exit code $got after SIGTERM"
grep -q 'stopped by SIGTERM: nothing is kept of what is not finished' err || fail "$(cat err)"

# particles that are not on the lattice: stepped in time, and why
code 0 ranks 1 permeability spheres.yaml --out points --set stages.flow.steps=2 \
  --set 'solid.bodies.a.arrangement={kind: perturbed, perturbation: 0.1}'
grep -q "stepped in time, because a body's particles are not on the lattice" out || fail "the reason is not said"
echo ok
