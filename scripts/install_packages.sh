#!/usr/bin/env bash
# Installs the packages of scripts/packages.txt that are missing, and asks for nothing.
# Usage: scripts/install_packages.sh [--develop]
#   --develop  also what formatting, linting and the sanitizer build need
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

wanted_group=''
case "${1:-}" in
  '') ;;
  --develop) wanted_group='develop' ;;
  *) sed -n '2,4s/^# //p' "$0" >&2; exit 2 ;;
esac

say() { printf '%s\n' "$*" >&2; }

is_installed() {
  [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null || true)" = installed ]
}

any_installed() {
  local name
  for name in ${1//|/ }; do
    if is_installed "$name"; then return 0; fi
  done
  return 1
}

# The entries of the list ("a|b") that are wanted and not there.
missing_entries() {
  local entry group
  while read -r entry group; do
    case "$entry" in '' | '#'*) continue ;; esac
    if [ -n "$group" ] && [ "$group" != "$wanted_group" ]; then continue; fi
    any_installed "$entry" || printf '%s\n' "$entry"
  done <"$here/packages.txt"
}

has_candidate() { apt-cache show --no-all-versions "$1" >/dev/null 2>&1; }

# The first name of an entry that this release has.
name_here() {
  local name
  for name in ${1//|/ }; do
    if has_candidate "$name"; then
      printf '%s\n' "$name"
      return
    fi
  done
  say "This release has no package $1; see scripts/packages.txt."
  return 1
}

as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo DEBIAN_FRONTEND=noninteractive "$@"
  else
    say "Packages are missing and installing them needs root or sudo. Missing: ${missing[*]}"
    exit 1
  fi
}

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  say 'There is no apt-get here. mapwright is built on Debian 12 and Ubuntu; elsewhere install what'
  say 'scripts/packages.txt lists by the names of your system, then run cmake --preset release.'
  exit 1
fi

mapfile -t missing < <(missing_entries)
if [ "${#missing[@]}" -eq 0 ]; then exit 0; fi

export DEBIAN_FRONTEND=noninteractive
wait_for_others=(-o DPkg::Lock::Timeout=600)  # a fresh machine often updates itself meanwhile
as_root apt-get "${wait_for_others[@]}" update -qq </dev/null >&2
names=()
for entry in "${missing[@]}"; do names+=("$(name_here "$entry")"); done
say "Installing: ${names[*]}"
as_root apt-get "${wait_for_others[@]}" install -y -qq --no-install-recommends "${names[@]}" \
  </dev/null >&2
