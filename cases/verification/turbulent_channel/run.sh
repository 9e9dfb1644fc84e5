#!/usr/bin/env bash
# A minimal turbulent channel at Re_tau = 178: mean profile, fluctuations, total stress.
# usage: cases/verification/turbulent_channel/run.sh [FRANA [RUNS [OUT]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
study study
value() { cell study value explicit '64 x 96 x 48' "$1"; }
mkm="Moser, Kim and Mansour 1999"
row "averaging time" h/u_tau "$(value 'averaging time')" 25 "asked" 25 1e9
near "bulk velocity" u_tau "$(value 'bulk velocity')" 15.680 "$mkm" 0.04
shown "centre velocity" u_tau "$(value 'centre velocity')" 18.301 "$mkm"
near "largest u'" u_tau "$(value "largest u'")" 2.658 "$mkm" 0.06
near "largest v'" u_tau "$(value "largest v'")" 0.836 "$mkm" 0.1
near "largest w'" u_tau "$(value "largest w'")" 1.087 "$mkm" 0.1
shown "largest -uv" u_tau2 "$(value 'largest -uv')" 0.7231 "$mkm"
row "largest fault of the total stress" u_tau2 "$(value 'largest fault of the total stress')" 0 "1 - y/h" 0 0.02
[ "$again" ] || cp "$runs/runs/study/explicit/64-x-96-x-48/1"/{profiles,stress}.csv "$out"
finish
