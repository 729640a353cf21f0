#!/usr/bin/env bash
# try.sh PACKAGES FOLDER: installs the packages of a folder in a fresh Debian 12, which debootstrap makes in FOLDER, and uses
# them as a user would, and then what the archive holds. It needs root and a network.
set -euo pipefail
packages=$(realpath "$1") folder=$2
debootstrap --variant=minbase bookworm "$folder"
mkdir "$folder/packages"
cp "$packages"/*.deb "$packages"/*.tar.gz "$folder/packages/"
mount -t proc proc "$folder/proc"
trap 'umount "$folder/proc"' EXIT
cp -L /etc/resolv.conf "$folder/etc/resolv.conf" || true
for file in /etc/apt/apt.conf.d/*proxy*; do
  [ ! -e "$file" ] || cp "$file" "$folder$file"
done
chroot "$folder" bash -euo pipefail -c '
  export DEBIAN_FRONTEND=noninteractive
  apt-get update -qq
  apt-get install -y -qq --no-install-recommends /packages/*.deb g++ cmake make pkg-config
  cd /tmp
  meet demo -o demo
  meet collide demo/animal.ply demo/figure.ply
  meetc new cell
  cmake -S cell -B cell/build
  cmake --build cell/build
  cell/build/first
  meetc show /usr/share/meetc/algebra_spec/scenes/spheres.toml >shown
  python3 -c "
import numpy as np, meetc
a = meetc.Set(np.float32([[0, 0, 0], [1, 0, 0], [0, 1, 0]]), np.int32([[0, 1, 2]]))
assert meetc.count(a, a) == 1
print(\"python\", meetc.__version__)"
  cat >program.cpp <<CPP
#include <cga/cga_runtime.hpp>
#include <cstdio>
int main() { std::printf("%d predicates\n", cga::catalogue().predicate_count); }
CPP
  g++ -std=c++20 program.cpp $(pkg-config --cflags --libs meetc) -o program
  ./program
  apt-get remove -y -qq meetc libmeetc-dev python3-meetc
  [ ! -e /usr/bin/meet ] && [ ! -e /usr/include/meet ]
  mkdir archive
  tar xzf /packages/meetc-*.tar.gz -C archive --strip-components 1
  apt-get install -y -qq --no-install-recommends libfmt-dev libflint17 libpng16-16 libfreetype6 libfontconfig1 libtinyxml2-9
  archive/bin/meet collide demo/animal.ply demo/figure.ply
  pc=$(dirname "$(find "$PWD/archive" -name meetc.pc)")
  g++ -std=c++20 program.cpp $(PKG_CONFIG_PATH=$pc pkg-config --cflags --libs meetc) -o program
  ./program'
echo "the packages work in a fresh Debian"
