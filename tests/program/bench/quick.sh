#!/usr/bin/env bash
# frana bench --quick writes a complete table, with every column and part, all numbers positive and finite, and all
# kinds of traffic of its ranks; the pages can be made from it.      usage: quick.sh FRANA WORK RANKS
set -euo pipefail
frana=$(realpath "$1") work=$2 ranks=$3
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
export OMPI_MCA_hwloc_base_binding_policy=none OMPI_MCA_mpi_yield_when_idle=1
rm -rf "$work" && mkdir -p "$work" && cd "$work"
fail() { echo "FAILED: $*" >&2; exit 1; }
mpiexec -n "$ranks" "$frana" bench --quick --repeats 5 --out out >said
[ "$(ls out/*.csv | wc -l)" = 2 ] || fail "not two tables: $(ls out)"
table=$(ls out/*-"$ranks".csv) traffic=$(ls out/*-"$ranks"-traffic.csv)
awk -F, '
  function positive(x) { return x ~ /^[0-9.]+(e[-+]?[0-9]+)?$/ && x + 0 > 0 }
  NR == 1 { columns = NF; for (i = 1; i <= NF; i++) at[$i] = i
    n = split("part size ranks calls repeats median_ms low_ms high_ms ns_per_unit unit units bytes_per_unit " \
      "flops_per_unit gb_per_s bandwidth_gb_per_s peak_gflop_per_s fraction_of_limit cpu cores compiler flags fftw " \
      "plan mpi date revision", want, " ")
    for (k = 1; k <= n; k++) if (!(want[k] in at)) { print "no column " want[k]; bad = 1 }
    next }
  { part = $at["part"]; seen[part] = 1; memory = part ~ /^memory/
    if (NF != columns) { print part ": " NF " cells"; bad = 1 }
    for (i = 1; i <= NF; i++) {
      text = i == at["part"] || i == at["size"] || i == at["unit"] || i >= at["cpu"]
      if (text && $i == "") { print part ": no text in column " i; bad = 1 }
      if (!text && $i != "" && !positive($i)) { print part ": " $i " in column " i; bad = 1 } }
    if (!memory)
      for (k = 1; k <= 11; k++) if ($at[want[k]] == "") { print part ": no " want[k]; bad = 1 }
    if (memory && !positive($at["bytes_per_unit"])) { print part ": no bytes"; bad = 1 }
    if (!memory && ($at["low_ms"] + 0 > $at["median_ms"] + 0 || $at["high_ms"] + 0 < $at["median_ms"] + 0)) {
      print part ": spread"; bad = 1 } }
  END {
    n = split("triad_one_rank triad multiply_add fluid_step fluid_step_last_stage fluid_momentum fluid_poisson " \
      "fluid_poisson_forward " \
      "fluid_poisson_columns fluid_poisson_backward fluid_halo halo_fill channel_step sweep_full sweep_full_damped " \
      "sweep_porous sweep_porous_damped sweep_full_list sweep_full_list_damped sweep_porous_list " \
      "sweep_porous_list_damped sweep_full_box sweep_full_box_damped sweep_porous_box sweep_porous_box_damped " \
      "sweep_full_image sweep_full_image_damped sweep_porous_image sweep_full_bonds sweep_full_dilated " \
      "sweep_full_bonds_damped sweep_full_dilated_damped sweep_porous_bonds sweep_porous_dilated " \
      "sweep_porous_bonds_damped sweep_porous_dilated_damped " \
      "sweep_full_double sweep_full_mixed sweep_full_double_damped sweep_full_mixed_damped sweep_porous_double " \
      "sweep_porous_mixed sweep_porous_double_damped sweep_porous_mixed_damped " \
      "sweep_porous_image_damped coupled_step coupled_step_breakage coupled_step_rk3 coupled_step_broken " \
      "coupled_step_reaction coupled_step_ab2 markers " \
      "forcing probe interface interface_broken contact contact_broken solid_substeps memory_fluid " \
      "memory_lattice_bond memory_lattice_particle memory_list_bond " \
      "memory_list_particle memory_image_bond memory_image_particle memory_marker memory_run", rows, " ")
    for (k = 1; k <= n; k++) if (!(rows[k] in seen)) { print "no row " rows[k]; bad = 1 }
    exit bad }' "$table" || fail "$table"
# an image of the same particles has the same bonds, and takes the same bytes
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
  !($1 in size) { size[$1] = $at["size"]; units[$1] = $at["units"]; bytes[$1] = $at["bytes_per_unit"] }
  END {
    n = split("sweep_full sweep_full_image sweep_full_damped sweep_full_image_damped sweep_porous " \
      "sweep_porous_image sweep_porous_damped sweep_porous_image_damped sweep_full_box sweep_full_image " \
      "sweep_full_box_damped sweep_full_image_damped sweep_porous_box sweep_porous_image " \
      "sweep_porous_box_damped sweep_porous_image_damped memory_lattice_bond memory_image_bond " \
      "memory_lattice_particle memory_image_particle", pair, " ")
    for (k = 1; k < n; k += 2) {
      a = pair[k]; b = pair[k + 1]
      if (size[a] != size[b] || units[a] != units[b] || bytes[a] == "" || bytes[b] / bytes[a] > 1.01) {
        print b ": " size[b] ", " units[b] " units of " bytes[b] " B, the box: " size[a] ", " units[a] ", " bytes[a]
        bad = 1 } }
    exit bad }' "$table" || fail "image and box differ: $table"
if [ "$ranks" -gt 1 ]; then
  for kind in halo ghost exchange transpose reduction; do
    awk -F, -v kind=$kind '$4 == kind && $5 + $6 > 0 && $7 > 0 { found = 1 } END { exit !found }' "$traffic" ||
      fail "no $kind in $traffic"
  done
else
  [ "$(wc -l <"$traffic")" = 1 ] || fail "one rank has spoken to itself: $(cat "$traffic")"
fi
