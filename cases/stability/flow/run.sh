#!/usr/bin/env bash
# The longest stable step of the fluid with explicit and with implicit diffusion. First a uniform stream with small
# waves, compared with the scheme's exact amplification of each wave. Then a channel with a cube in it, over its
# Reynolds number, compared with the automatic step.
# usage: cases/stability/flow/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../../verification/common.sh" "$@"
# shellcheck source=cases/stability/edge.sh
. "$here/../edge.sh"
# A run is bounded if the dissipation late in the run is less than ten times that at its start. Only the waves
# dissipate.
judge() { [ "$(of_run "$1" dissipation 'print max(n - n / 4, n) <= 10 * max(1, n / 10)')" = 1 ]; }

# computed DIFFUSION NU: the shortest step at which one of the waves on 8 cells grows, for U = 1 in each direction and
# cells of size 1. The scheme is low-storage RK3 with central differences. The rates of a wave are i c = -i sum
# sin(theta) and l = 2 nu sum (1 - cos(theta)).
computed() {
  awk -v kind="$1" -v nu="$2" '
    function grows(c, l,  r, x, y, fx, fy, ox, oy, nx, ny, d) { # c and l are multiplied by the step
      x = 1; y = ox = oy = 0
      for (r = 0; r < 3; r++) {
        fx = c * y; fy = -c * x; d = 1
        if (kind == "explicit") { fx -= l * x; fy -= l * y } else d = 1 + (a[r] + b[r]) * l
        nx = (x + a[r] * fx + b[r] * ox) / d; ny = (y + a[r] * fy + b[r] * oy) / d
        x = nx; y = ny; ox = fx; oy = fy }
      return x * x + y * y > 1 + 1e-9 }
    function any(dt,  i, j, k) {
      for (i = 0; i <= 4; i++) for (j = 0; j <= i; j++) for (k = 0; k <= j; k++)
        if (i && grows(dt * (s[i] + s[j] + s[k]), dt * 2 * nu * (3 - q[i] - q[j] - q[k]))) return 1
      return 0 }
    BEGIN { pi = atan2(0, -1); a[0] = 8 / 15; a[1] = 5 / 12; a[2] = 3 / 4; b[1] = -17 / 60; b[2] = -5 / 12
      for (i = 0; i <= 4; i++) { s[i] = sin(pi * i / 4); q[i] = cos(pi * i / 4) }
      dt = 1e-3; if (nu > 1) dt /= nu
      while (!any(dt) && dt < 100) dt *= 1.005
      if (dt >= 100) { print 100; exit } # none
      low = dt / 1.005; high = dt
      for (n = 0; n < 30; n++) { dt = (low + high) / 2; if (any(dt)) high = dt; else low = dt }
      print dt }'
}
point() {
  local map=$1 kind=$2 at=$3 nu step found
  if [ "$map" = waves ]; then # over the cell's Reynolds number U dx/nu
    nu=$(calc "1 / $at") step=$(computed "$kind" "$(calc "1 / $at")")
    found=$(edge "$(calc "0.7 * $step")" "$(calc "1.6 * $step")" 0.005 \
      scene fluid.viscosity="$nu" fluid.diffusion="$kind" stages.0.time_step=@)
    echo "$kind,$at,$found,$step,$(calc "12 * $nu * $found"),$(calc "3 * $found"),$(
      calc "12 * $nu * $step"),$(calc "3 * $step")"
  else # over the bulk Reynolds number; the automatic step is held against what a given one may be
    nu=$(calc "1 / $at")
    made "$runs/auto/$kind$at" channel fluid.viscosity="$nu" fluid.diffusion="$kind"
    step=$(of_run "$runs/auto/$kind$at" dt 'print x[n]')
    found=$(edge "$(calc "0.5 * $step")" "$(calc "8 * $step")" 0.02 \
      channel fluid.viscosity="$nu" fluid.diffusion="$kind" stages.0.time_step=@)
    echo "$kind,$at,$found,$step"
  fi
}
for kind in explicit implicit; do
  printf "waves $kind %s\n" ${quick:-0.01 0.1 0.3 1 2 3 5 10 30} 0.01 1 1e4
done | awk '!/quick/ && !seen[$0]++' >"$runs/waves"
[ ! "$quick" ] || sed -i '/implicit/d' "$runs/waves"
table waves 'diffusion,cell_reynolds,step,step_computed,diffusion_number,cfl,diffusion_number_computed,cfl_computed' \
  <"$runs/waves"
while IFS=, read -r kind at found step rest; do
  [ "$kind" != diffusion ] || continue
  if [ "$step" = 100 ]; then
    row "$kind diffusion, U dx/nu = $at: longest step" s "$found" "" "no wave grows, up to 100 s" 100 1e9
  else
    near "$kind diffusion, U dx/nu = $at: longest step" s "$found" "$step" "amplification of each wave" 0.05
  fi
done <"$out/waves.csv"
plot waves
if [ ! "$quick" ]; then
  for kind in explicit implicit; do printf "channel $kind %s\n" 1e-3 1e-2 0.1 1 10 100 1000; done >"$runs/channel"
  table channel 'diffusion,reynolds,step,step_automatic' <"$runs/channel"
  while IFS=, read -r kind at found step; do
    [ "$kind" = diffusion ] ||
      row "$kind diffusion, a channel with a cube at Re = $at: longest step over the automatic one" 1 \
        "$(calc "$found / $step")" "" "the automatic step holds" 1
  done <"$out/channel.csv"
  plot channel
fi
finish
