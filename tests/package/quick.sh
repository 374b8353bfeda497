#!/usr/bin/env bash
# What can be checked of the packages in seconds: the files of the page and of the player, their versions, the manual, the completions.
# quick.sh PROGRAM
set -euo pipefail
program=$(realpath "$1")
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
version=$("$program" --version)
version=${version#vidno }

fail() {
    echo "$*" >&2
    exit 1
}

VIDNO_PACKAGES=$work/packages trace/package/make page player >/dev/null
(cd "$work/packages" && sha256sum --check --quiet SHA256SUMS)
unzip -q "$work/packages/vidno-page-$version.zip" -d "$work"
for file in index.html chart.html vidno-player.js; do
    cmp "viewer_web/dist/$file" "$work/vidno-page-$version/$file"
done
grep -qF "content=\"vidno $version\"" "$work/vidno-page-$version/index.html" || fail "The page does not state version $version"
tar -xzf "$work/packages/vidno-player-$version.tgz" -C "$work"
cmp viewer_web/dist/vidno-player.js "$work/package/vidno-player.js"
grep -qF "\"version\": \"$version\"" "$work/package/package.json" || fail "The player does not have version $version"

"$program" describe manual >"$work/vidno.1"
groff -man -Tutf8 -ww -z "$work/vidno.1" 2>"$work/warnings"
[[ ! -s $work/warnings ]] || fail "groff warns: $(<"$work/warnings")"

# Debian 12's npm cannot read such overrides; that of most developers can.
! grep -qF '"npm:' viewer_web/package.json || fail "viewer_web/package.json overrides a dependency by another package"

# What ./dev release says of a clone that is no release.
if git rev-parse --git-dir >/dev/null 2>&1; then
    git clone -q . "$work/clone"
    refused() {
        local said
        ! said=$(cd "$work/clone" && ./dev release "$1" 2>&1) || fail "./dev release $1 was not refused"
        [[ $said == *"$2"* ]] || fail "./dev release $1: $said"
    }
    refused '' 'X.Y.Z'
    refused 1.2 'X.Y.Z'
    refused "9$version" "states version $version"
    sed -i '/^## 0/,$d' "$work/clone/CHANGELOG.md"
    refused "$version" 'not committed'
    git -C "$work/clone" -c user.name=test -c user.email=test@localhost commit -qam 'Drop the changes of all versions'
    refused "$version" "no changes under $version"
    git -C "$work/clone" tag "v$version"
    refused "$version" "tag v$version exists"
fi

# What bash would propose for the last of the words.
"$program" describe bash >"$work/completion"
proposed() {
    bash -euc 'source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _vidno; printf "%s " "${COMPREPLY[@]}"' - "$work/completion" "$@"
}
[[ $(proposed vidno tr) == 'trace ' ]] || fail "Commands are not completed"
[[ $(proposed vidno trace --ker) == '--kernel ' ]] || fail "Options are not completed"
[[ $(proposed vidno trace --method floa) == 'floating-horizon ' ]] || fail "Methods are not completed"
[[ $(proposed vidno lesson bu) == 'build ' ]] || fail "Commands of commands are not completed"
"$program" describe zsh >"$work/_vidno"
[[ $(head -n 1 "$work/_vidno") == '#compdef vidno' ]] || fail "zsh would not load the completion"
