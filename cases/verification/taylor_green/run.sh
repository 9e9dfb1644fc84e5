#!/usr/bin/env bash
# Orders, decay rates and the vortices at Re = 1600, compared with their references.
# usage: cases/verification/taylor_green/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
study study
study study_time
study study_space
discrete=0.9967913640449608 # (sin(h/2)/(h/2))^2, h = 2 pi/32
for plane in xy xz yz; do
  near "$plane: decay rate over 2 nu at 32^2" 1 "$(cell study value $plane 32 'decay rate')" $discrete \
    "rate of the discrete equations" 1e-8
  row "$plane: largest divergence at 64^2" 1/s "$(cell study value $plane 64 divergence)" 0 continuity 0 1e-11
done
for level in 32 64; do
  row "order in space to $level^2" 1 "$(cell study order xy $level 'decay rate')" 2 "second order" 1.9 2.1
done
for level in 1/80 1/160; do
  row "order in time to $level" 1 "$(cell study_time order xy $level 'decay rate')" 3 "RK3" 2.7 3.3
done
near "Re 1600 at 64^3: energy at t = 4" m2/s2 "$(cell study_space value RK3 64 'energy at t = 4')" 0.1215082 \
  "Dairay et al. 2017" 1e-3
near "Re 1600 at 64^3: dissipation at t = 4" m2/s3 "$(cell study_space value RK3 64 'dissipation at t = 4')" \
  2.06619e-3 "Dairay et al. 2017" 5e-2
row "Re 1600 at 64^3: largest gap of the energy balance over the largest dissipation" 1 \
  "$(cell study_space value RK3 64 balance)" 0 "-dE/dt = nu |grad u|^2" 0 0.01
if [ ! "$quick" ]; then
  study study_fine
  near "Re 1600 at 128^3: energy at t = 4" m2/s2 "$(cell study_fine value RK3 128 'energy at t = 4')" 0.1215082 \
    "Dairay et al. 2017" 1e-3
  shown "Re 1600 at 128^3: dissipation at t = 4" m2/s3 "$(cell study_fine value RK3 128 'dissipation at t = 4')" \
    2.06619e-3 "Dairay et al. 2017"
  row "Re 1600: order of the dissipation at t = 4 to 128^3" 1 \
    "$(cell study_fine order RK3 128 'dissipation at t = 4')" 2 "second order" 1.6 2.1
  study study_peak
  near "Re 1600 at 128^3: dissipation at its peak" m2/s3 "$(cell study_peak value RK3 128 'dissipation at its peak')" \
    1.28486e-2 "Dairay et al. 2017" 0.1
  row "Re 1600 at 128^3: time of the peak" s "$(cell study_peak value RK3 128 'time of the peak')" 8.98 \
    "Dairay et al. 2017" 8.48 9.48
  row "Re 1600 at 128^3: largest gap of the energy balance over the largest dissipation" 1 \
    "$(cell study_peak value RK3 128 balance)" 0 "-dE/dt = nu |grad u|^2" 0 0.01
fi
finish
