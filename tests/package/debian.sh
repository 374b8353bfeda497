#!/usr/bin/env bash
# Installs the Debian packages in a bare Debian 12, and uses them as a reader of the README would, and a cluster. Needs root and a Debian
# mirror.
# debian.sh FOLDER-OF-PACKAGES
set -euo pipefail
packages=$(cd "$1" && pwd)
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
consumer=$(cd "$here/../consumer" && pwd)
root=$(mktemp -d)
chmod 755 "$root"
inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root DEBIAN_FRONTEND=noninteractive "$@"; }
leave() {
    umount --recursive "$root/sys" 2>/dev/null || true
    umount "$root/dev/pts" "$root/proc" 2>/dev/null || true
    rm -rf --one-file-system "$root"
}
trap leave EXIT

echo "== A bare Debian 12"
debootstrap --variant=minbase bookworm "$root" "${DEBIAN_MIRROR:-http://deb.debian.org/debian}" >/dev/null
mkdir "$root/packages"
cp "$packages"/*.deb "$root/packages"
cp -r "$consumer" "$root/consumer"
mount -t proc proc "$root/proc"
mount -t devpts devpts "$root/dev/pts"
inside apt-get update -q >/dev/null
cat >"$root/scene.json" <<'END'
{"window": {"x": 0, "y": 0, "width": 16, "height": 16},
 "polygons": [
   {"id": "far",  "vertices": [[1, 1, 0.2], [13, 1, 0.2], [13, 13, 0.2], [1, 13, 0.2]]},
   {"id": "near", "vertices": [[5, 4, 0.7], [15, 6, 0.7], [8, 15, 0.7]]}
 ]
}
END

say() { printf '\n$ %s\n' "$*"; }
run() {
    say "$@"
    inside sh -euc "$*"
}
say "apt install ./vidno_*.deb"
inside sh -euc 'apt-get install -y -q --no-install-recommends ./packages/vidno_*.deb' | tail -n 4
run 'vidno --version'
run 'vidno trace scene.json -o run.jsonl && tail -n 1 run.jsonl'
run 'vidno check scene.json --kernel float'
run 'vidno figure run.jsonl --step 100 --show picture,windows,listing -o figure.pdf && head -c 8 figure.pdf'
run 'vidno figure run.jsonl --step 100 -o figure.svg && head -n 1 figure.svg | cut -c1-100'
run 'vidno page run.jsonl scene.json -o lecture.html && ls -s --block-size=1k lecture.html'
run 'vidno lesson check /usr/share/vidno/lessons/01-four-relations'
run 'cd /usr/share && ls -s --block-size=1k man/man1/vidno.1.gz bash-completion/completions/vidno zsh/vendor-completions/_vidno'
run 'vidno chart scene.json -o chart.svg || head -n 1 chart.svg | cut -c1-100' # it says which run lost something

say "apt install ./libvidno-dev_*.deb cmake g++ ninja-build"
inside sh -euc 'apt-get install -y -q --no-install-recommends ./packages/libvidno-dev_*.deb cmake g++ ninja-build' | tail -n 2
version=$(inside vidno --version)
run "cmake -S consumer -B built -G Ninja -DCMAKE_BUILD_TYPE=Release -DVIDNO_VERSION=${version#vidno } >/dev/null &&
    cmake --build built >/dev/null && built/consumer" |
    tee "$root/consumer.txt"
# The picture is that of consumer/run.cmake.
[[ $(grep -c '^tttt\.\.\.\.$' "$root/consumer.txt") == 2 ]]
echo "== Both packages work"

echo "== A campaign of the package on Slurm"
printf '#!/bin/sh\nexit 101\n' >"$root/usr/sbin/policy-rc.d" # no package starts a daemon here
chmod +x "$root/usr/sbin/policy-rc.d"
inside apt-get install -y -q --no-install-recommends slurm-wlm slurmdbd munge mariadb-server procps | tail -n 1
mount --rbind /sys "$root/sys" # slurmd looks for control groups
mount --make-rslave "$root/sys"
cp "$here/slurm.sh" "$root"
inside bash /slurm.sh /usr/bin/vidno
