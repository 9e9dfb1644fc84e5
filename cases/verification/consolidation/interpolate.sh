# shellcheck shell=bash
# To be sourced: functions of awk that read values at the time T from rows of a series. A row has the time `now`, the
# one before it had `was`.
# shellcheck disable=SC2034 # for whoever sources this
interpolate='
  function take(name, v) { # call it once a row
    if (was < T && now >= T) value[name] = before[name] + (T - was) / (now - was) * (v - before[name])
    before[name] = v
  }
  function print_taken(name) {
    if (!(name in value)) { print "the run ends before T = " T > "/dev/stderr"; exit 1 }
    printf "%.8g\n", value[name]
  }'

# Moduli of the lattice's families in a plate at m = 3, for the shear modulus and the bulk modulus of strains in the
# plane that E and NU have: sets C1 = C11, C2 = C12. At NU = 1/4 they are those of bonds alone, sums over the family;
# else the dilatation makes the bulk modulus (C1 + C2)/2 exact. isotropic: without the lattice's anisotropy.
# shellcheck disable=SC2034 # read by the scripts
moduli='
  function lattice(E, NU, isotropic,  mu, bulk, excess) {
    mu = E / (2 * (1 + NU)); bulk = mu / (1 - 2 * NU)
    C1 = (isotropic ? 1 : 1.0220027) * 3 * mu; C2 = (isotropic ? 1 : 0.98967) * mu
    excess = NU == 0.25 ? 0 : bulk - (C1 + C2) / 2
    C1 += excess; C2 += excess
  }'
