#!/usr/bin/env bash
# Formats the C files in place (.clang-format, clang-format 14), or with --check says which are not.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
how=(-i)
[ "${1:-}" != --check ] || how=(--dry-run -Werror)
find base fluid solid ibm coupling postproc study tests \( -name '*.c' -o -name '*.h' \) -print0 |
    xargs -0 "$(command -v clang-format-14 || echo clang-format)" "${how[@]}"
