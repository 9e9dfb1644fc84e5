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
