#!/usr/bin/env bash
# Prints a page of documentation with what its commands say now. Two kinds of blocks have commands: "sh", whose output
# the block "text" after it shows, and "console", where each line "$ ..." is followed by what the command prints on
# either stream. The answer of a command may be no.
# Usage: rerun_page.sh PAGE.md FOLDER_OF_HECKBERT
set -euo pipefail
page=$1
export PATH="$2:$PATH"

run() { eval "$1" || [ $? -eq 1 ]; }

block='' commands=''
while IFS= read -r line; do
  if [[ $line == '```'* ]]; then
    block=${line#'```'}
    printf '%s\n' "$line"
    case $block in
      sh) commands='' ;;
      text) run "$commands" 2>/dev/null ;;
    esac
    continue
  fi
  case $block in
    sh) commands+=$line$'\n' ;;
    text) continue ;;
    console) [[ $line == '$ '* ]] || continue ;;
  esac
  printf '%s\n' "$line"
  if [ "$block" = console ]; then run "${line#'$ '}" 2>&1; fi
done <"$page"
