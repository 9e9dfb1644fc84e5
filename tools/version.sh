#!/usr/bin/env bash
# The version stands in several files: CMakeLists.txt has it for the program, the others for those who cite and package.
#   tools/version.sh           checks that all are that of CMakeLists.txt; prints each that differs, and leaves with 1
#   tools/version.sh 1.2.3     writes a new version into all of them
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

spack=tools/packaging/spack/spack_repo/frana/packages/frana/package.py
number='[0-9]+\.[0-9]+\.[0-9]+'
# file|line|what may differ: the version in a line that matches is the group between the two others
places="CMakeLists.txt|^(project\(frana VERSION )($number)( .*)$
CITATION.cff|^(version: )($number)()$
codemeta.json|^(  \"version\": \")($number)(\",)$
tools/packaging/easybuild/frana.eb|^(version = ')($number)(')$
$spack|^(    version\(\"[^\"]*\", tag=\"v)($number)(\"\))$"

has() { sed -nE "s/$2/\2/p" "$1"; }
if [ $# -gt 0 ]; then
    [[ $1 =~ ^$number$ ]] || {
        echo "$1: must be three numbers, as 1.2.3" >&2
        exit 2
    }
    while IFS='|' read -r file line; do sed -Ei "s/$line/\1$1\3/" "$file"; done <<<"$places"
    sed -Ei "s/^(    version\(\")$number(\", tag=)/\1$1\2/" "$spack"
fi
version=$(has CMakeLists.txt "$(sed -n '1s/^[^|]*|//p' <<<"$places")")
wrong=0
while IFS='|' read -r file line; do
    found=$(has "$file" "$line")
    if [ "$found" != "$version" ]; then
        echo "$file: version ${found:-is missing}, in CMakeLists.txt it is $version"
        wrong=1
    fi
done <<<"$places"
[ $wrong = 0 ] && echo "version $version in $(wc -l <<<"$places") files"
exit $wrong
