#!/usr/bin/env bash
# Formats all C files that git tracks in place (.clang-format, clang-format 14), or with --check says which are not. The
# width of lines, comments and scripts included, is tools/columns.sh's.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
how=(-i)
[ "${1:-}" != --check ] || how=(--dry-run -Werror)
git ls-files -z '*.c' '*.h' | xargs -0 "$(command -v clang-format-14 || echo clang-format)" "${how[@]}"
