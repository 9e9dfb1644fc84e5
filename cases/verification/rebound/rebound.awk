# The velocities of a ball with which it passes a gap of a twentieth of its diameter, on its way to the wall and back,
# from the momentum of series.csv; with what=stokes the Stokes number of the impact, else the rebound over the impact.
BEGIN { FS = ","; diameter = 0.015; gap = 0.012; start = -0.1; v = start }
/^#/ { next }
!column["t"] { for (i = 1; i <= NF; i++) column[$i] = i; next }
{
  p = $column["momentum_z"]
  if (!mass) mass = p * p / 2 / $column["e_kinetic_solid"]
  next_v = p / mass
  next_gap = gap + (v + next_v) / 2 * ($column["t"] - t)
  if (!impact && next_gap < diameter / 20) impact = -next_v
  if (impact && !rebound && next_v > 0 && next_gap > diameter / 20) rebound = next_v
  gap = next_gap; v = next_v; t = $column["t"]
}
END { printf "%.6g\n", what == "stokes" ? 8 * impact * diameter / 9 / viscosity : rebound / impact }
