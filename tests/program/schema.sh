#!/usr/bin/env bash
# The yaml language server accepts the scenes of cases/ and tests/ by `frana schema`, and refuses broken ones. Without
# it (npm install yaml-language-server; its folder node_modules/.bin in PATH) the test is skipped: exit code 77.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
server=$(command -v yaml-language-server) && command -v node >/dev/null || { echo "no yaml-language-server"; exit 77; }
"$frana" schema >schema.json
samples=$source/tests/scene/scenes
sed 's/viscosity:/viscosty:/' "$samples/fluid.yaml" >unknown.yaml
sed 's/density: .*/density: -3/' "$samples/fluid.yaml" >range.yaml
sed '/viscosity:/d' "$samples/fluid.yaml" >missing.yaml
sed 's/steps: [0-9]*/steps: 1.5/' "$samples/fluid.yaml" >whole.yaml
sed 's/shape: box/shape: bx/' "$samples/block.yaml" >choice.yaml
sed 's/shape: box/shape: sphere/' "$samples/block.yaml" >beside.yaml
mapfile -t good < <(find "$source/cases" "$source/tests" -name '*.yaml' ! -name 'study*.yaml' ! -name gates.yaml | sort)
[ ${#good[@]} -ge 100 ] || fail "only ${#good[@]} scenes"
node "$source/tests/program/language_server.js" "$server" schema.json "${good[@]}" --bad ./*.yaml
echo ok
