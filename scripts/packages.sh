#!/usr/bin/env bash
# Builds the Debian packages from the tracked files as they are now, in a copy of them. Needs no network but for packages to
# build with that are missing. usage: packages.sh [FOLDER]   (build/packages)
set -euo pipefail
cd "$(dirname "$0")/.."
folder=$(realpath -m "${1:-build/packages}")
version=$(sed -n '1s/^lober (\([^)]*\)) .*/\1/p' debian/changelog)
scripts/packages-version.sh
# The names in Build-Depends; debhelper-compat is a version of debhelper.
build_depends=$(sed -n '/^Build-Depends/,/^$/{s/^Build-Depends[A-Za-z-]*://; s/([^)]*)//g; s/<[^>]*>//g; s/[ ,]//g; s/-compat$//; p}' debian/control)
# shellcheck disable=SC2086
scripts/install-packages.sh build-essential $build_depends

echo "Builds the packages of lober $version: minutes, most of them to compile; ccache, where it is installed, keeps that for the next time"
tree=$folder/lober-$version
rm -rf "$folder"
mkdir -p "$tree"
git ls-files -z | tar --create --null --no-recursion --files-from=- | tar --extract --directory="$tree"
git describe --always --abbrev=12 --exclude='*' --dirty=+changes >"$tree/COMMIT"
# debhelper has a home of its own, where the compiler cache would be lost.
if command -v ccache >/dev/null; then
  export CCACHE_DIR=${CCACHE_DIR:-$(ccache --get-config cache_dir)} CMAKE_CXX_COMPILER_LAUNCHER=ccache
fi
export PATH=/usr/sbin:/usr/bin:/sbin:/bin
export DEB_BUILD_OPTIONS="${DEB_BUILD_OPTIONS:-noautodbgsym parallel=$(nproc)}"
(cd "$tree" && dpkg-buildpackage --build=binary --no-sign) >"$folder/build.log" 2>&1 || {
  tail -n 40 "$folder/build.log" | cut -c 1-300
  echo "the packages are not built; all of the log is $folder/build.log" >&2
  exit 1
}
(cd "$folder" && ls -l --block-size=K ./*.deb | awk '{print $5, $NF}')
echo "They are in $folder. Another machine with Debian 12 needs no compiler and none of this: copy the files there, and"
echo "  apt install ./lober_*.deb ./lober-doc_*.deb ./python3-lober_*.deb    # the program, documents and examples, Python"
echo "  apt install ./liblober*.deb                                          # for programs in C++ and C"
