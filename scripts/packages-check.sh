#!/usr/bin/env bash
# Installs the packages of `make deb` on a clean Debian 12 and uses them there as a user does: the program, Python, documents,
# C and C++; removes them and shows that nothing is left. Then builds where there is no SQLite, toml++ and CLI11: the library
# without batches, and a wheel, which is installed and used. At last the packages are built there, by their Build-Depends
# alone, in another folder, time zone and language and with another umask, and have to be the same bytes. Takes root, the
# network, and a quarter of an hour on two cores, most of it for the last step. Ends with `N passed, N failed, N skipped`.
# usage: packages-check.sh [STEP...]   the steps that are named, in the root of the last run; default: all, in a new one
set -uo pipefail
cd "$(dirname "$0")/.." || exit 2
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "need root or sudo for a folder with another Debian" >&2; exit 2; }
  exec sudo --preserve-env=CCACHE_DIR scripts/packages-check.sh "$@"
fi
packages=$PWD/build/packages
work=$PWD/build/packages-check
root=$work/root
chosen=" $* "
passed=0 failed=0 skipped=0
version=$(sed -n '1s/^lober (\([^)]*\)) .*/\1/p' debian/changelog)
library=$(sed -n 's/^Package: \(liblober[0-9.]*\)$/\1/p' debian/control)
[ -n "$(ls "$packages"/*.deb 2>/dev/null)" ] || { echo "there are no packages in $packages; make deb builds them" >&2; exit 2; }
scripts/install-packages.sh mmdebstrap lintian || exit 2
mkdir -p "$work"
if [ -z "${CCACHE_DIR:-}" ] && command -v ccache >/dev/null; then CCACHE_DIR=$(ccache --get-config cache_dir); fi
export CCACHE_DIR=${CCACHE_DIR:-}
# shellcheck source=scripts/packages-root.sh
source scripts/packages-root.sh

# step NAME FUNCTION: lines that begin with == are shown; status 77 is a skip, the last line says why.
step() {
  local name=$1 begin=$SECONDS status log=$work/$1.log
  [[ $chosen == "  " || $chosen == *" $name "* ]] || return
  (set -e; "$2") >"$log" 2>&1
  status=$?
  case $status in
    0) echo "passed   $name, $((SECONDS - begin)) s"; passed=$((passed + 1)) ;;
    77) echo "skipped  $name: $(tail -n 1 "$log")"; skipped=$((skipped + 1)) ;;
    *) echo "FAILED   $name, status $status:"; tail -n 30 "$log"; failed=$((failed + 1)) ;;
  esac
  [ $status -ne 0 ] || sed -n 's/^== /         /p' "$log"
}

# Nothing of Debian's policy is broken.
lintian_has_no_errors() {
  lintian --fail-on error --tag-display-limit 0 "$packages"/*.changes | tee "$work/lintian"
  echo "== $(grep -c '^E:' "$work/lintian" || true) errors, $(grep -c '^W:' "$work/lintian" || true) warnings"
}

clean_root() {
  make_root
  mkdir "$root/packages" "$root/source"
  cp "$packages"/*.deb "$root/packages/"
  git ls-files -z | tar --create --null --no-recursion --files-from=- | tar --extract --directory="$root/source"
  cp "$packages/lober-$version/COMMIT" "$root/source/"
  installed_in_root >"$work/packages.before"
  files_in_root >"$work/files.before"
  ! grep -i lober "$work/packages.before" "$work/files.before"
}

# By apt, which finds all that they depend on; the patterns are for the shell in the root.
# shellcheck disable=SC2016
user_installs() {
  in_root apt-get update -qq
  shell_in_root 'apt-get install -y --no-install-recommends /packages/lober_*.deb /packages/lober-doc_*.deb /packages/python3-lober_*.deb'
  echo "== $(($(installed_in_root | wc -l) - $(wc -l <"$work/packages.before"))) packages with those that they depend on"
}

# The least of 50 starts counts: the machine may have other work.
# shellcheck disable=SC2016
program_runs() {
  shell_in_root '
    [ "$(lober --version)" = "lober $1" ]
    cd /usr/share/doc/lober/examples
    lober overlay resonance.dat resonance_image.dat --verify --svg /tmp/lobes.svg | tee /tmp/overlay
    grep -q "<svg" /tmp/lobes.svg
    lober overlay six-crossings.dat#0 six-crossings.dat#1 --json - >/tmp/six.json
    lober transport ovp --iterates 2
    least=1000000
    for run in $(seq 50); do
      begin=$(date +%s%N); lober --version >/dev/null; took=$((($(date +%s%N) - begin) / 1000))
      [ $took -ge $least ] || least=$took
    done
    echo "== lober --version takes $((least / 1000)).$(printf %03d $((least % 1000))) ms with its process"
    [ $least -lt 5000 ]' "$version"
}

# Every command has a page, with the date of the package, and the shells find completions.
# shellcheck disable=SC2016
manual_and_completions() {
  shell_in_root '
    export SOURCE_DATE_EPOCH=$1
    zcat /usr/share/man/man1/lober.1.gz | cmp - <(lober --generate man)
    for command in $(lober --generate commands); do
      zcat "/usr/share/man/man1/lober-$command.1.gz" | cmp - <(lober --generate man "$command")
    done
    lober --generate complete-bash | cmp - /usr/share/bash-completion/completions/lober
    lober --generate complete-zsh | cmp - /usr/share/zsh/vendor-completions/_lober
    lober --generate complete-fish | cmp - /usr/share/fish/vendor_completions.d/lober.fish
    echo "== $(ls /usr/share/man/man1/lober*.1.gz | wc -l) pages, completions for bash, zsh and fish"' "$(dpkg-parsechangelog --show-field Timestamp)"
}

# shellcheck disable=SC2016
python_runs() {
  shell_in_root '
    begin=$(date +%s%N)
    python3 -c "import lober; lober.show_versions(); lober.test()" | sed "s/^/== /"
    took=$((($(date +%s%N) - begin) / 1000000))
    echo "== $took ms"
    [ $took -lt 5000 ]'
}

# An NPZ file needs libzip4: without it the message says so, with it the file is read.
# shellcheck disable=SC2016
suggested_libraries() {
  shell_in_root '
    python3 -c "import numpy; numpy.savez(\"/tmp/square.npz\", xy=numpy.array([[0.0, 0], [2, 0], [2, 2], [0, 2]]))"
    ! lober overlay /tmp/square.npz /tmp/square.npz 2>/tmp/message
    grep -q libzip4 /tmp/message
    sed "s/^/== /" /tmp/message
    suggested=$(dpkg-query -W -f "\${Suggests}" lober | tr -d , | sed "s/lober-doc//")
    apt-get install -y -qq --no-install-recommends $suggested
    lober overlay /tmp/square.npz /tmp/square.npz
    python3 -c "import lober; missing = [f.library for f in lober.formats() if f.missing]; assert not missing, missing"'
}

# shellcheck disable=SC2016
documents_are_there() {
  shell_in_root '
    cd /usr/share/doc
    for package in lober lober-doc python3-lober; do [ -s "$package/copyright" ]; done
    for name in changelog.gz examples/resonance.dat examples/c/lobes.c; do [ -s "lober/$name" ] || { echo "no $name"; exit 1; }; done
    [ -s lober/html/index.html ]
    # Links from page to page, and to pictures.
    cd lober/html
    missing=$(grep -hoE "(href|src)=\"[^\":#?]+[\"#?]" index.html | sed "s/.*=\"//; s/.$//" | sort -u | while read -r target; do
      [ -e "$target" ] || echo "$target"
    done)
    [ -z "$missing" ] || { echo "index.html names what is not there: $missing"; exit 1; }
    echo "== $(find . -name "*.html" | wc -l) pages of HTML"'
}

# All packages that came are removed; then the root has the files that it had.
nothing_is_left() {
  installed_in_root | comm -13 "$work/packages.before" - >"$work/packages.new"
  grep -q lober "$work/packages.new"
  mapfile -t new <"$work/packages.new"
  in_root apt-get purge -y -qq "${new[@]}"
  local left
  left=$(find "$root" -xdev -iname '*lober*' -not -path "$root/packages/*" -not -path "$root/source/*" -not -path "$root/ccache/*" -not -path "$root/tmp/*")
  [ -z "$left" ] || { echo "left of lober: $left"; return 1; }
  files_in_root | comm -13 "$work/files.before" - >"$work/files.left"
  if [ -s "$work/files.left" ]; then
    echo "left by packages:"
    cat "$work/files.left"
    return 1
  fi
  echo "== ${#new[@]} packages removed, no file is left"
}

# C by pkg-config, C++ by CMake and by pkg-config.
# shellcheck disable=SC2016
programs_in_c_and_cpp() {
  install_in_root g++ cmake make pkg-config
  shell_in_root 'apt-get install -y -qq --no-install-recommends /packages/liblober*.deb /packages/lober-doc_*.deb'
  shell_in_root '
    rm -rf /tmp/use && mkdir /tmp/use && cd /tmp/use
    cc -std=c99 -Wall -Wextra -Werror /usr/share/doc/lober/examples/c/lobes.c $(pkg-config --cflags --libs lober) -lm -o lobes
    ./lobes | tee lobes.out
    grep -q "^5 lobes of area 0.3685" lobes.out
    cp -r /source/tests/consumer . && cmake -S consumer -B cmake -DLOBER_VERSION="${1%.*}" && cmake --build cmake
    cmake/consumer
    cmake/consumer_of_all
    g++ -std=c++20 -Wall -Wextra -Werror consumer/all.cpp $(pkg-config --cflags --libs lober) -o all
    ./all
    readelf -d all | grep -q "NEEDED.*liblober.so"
    [ "$(pkg-config --modversion lober)" = "$1" ]' "$version"
}

# What a build without batches needs; nothing of SQLite, toml++, CLI11, spdlog and nlohmann-json can be included here.
small_build=(g++ cmake ninja-build ccache libtbb-dev libeigen3-dev libnanoflann-dev libboost-dev nettle-dev)
# shellcheck disable=SC2016
without='for header in sqlite3.h toml++/toml.h CLI/CLI.hpp spdlog/spdlog.h nlohmann/json.hpp; do
  ! echo "#include <$header>" | g++ -std=c++20 -fsyntax-only -x c++ - 2>/dev/null || { echo "$header is here"; exit 1; }
done'

# shellcheck disable=SC2016
builds_without_batches() {
  install_in_root "${small_build[@]}"
  shell_in_root "$without"'
    build=/source/python/build/temp.linux-x86_64-cpython-311/cmake  # the folder of the wheel, for the compiler cache
    rm -rf /source/python/build /tmp/installed /tmp/consumer
    cmake -S /source -B $build -G Ninja -DLOBER_UNITY=ON -DLOBER_BUILD_BATCH=OFF
    cmake --build $build
    cmake --install $build --prefix /tmp/installed >/dev/null
    cmake -S /source/tests/consumer -B /tmp/consumer -G Ninja -DCMAKE_PREFIX_PATH=/tmp/installed -DLOBER_COMPONENT=geometry -DLOBER_VERSION="${1%.*}"
    cmake --build /tmp/consumer
    /tmp/consumer/consumer' "$version"
}

# shellcheck disable=SC2016
wheel() {
  install_in_root "${small_build[@]}" pybind11-dev python3-dev python3-numpy python3-build python3-setuptools python3-wheel python3-venv
  shell_in_root "$without"'
    cd /source/python
    rm -rf dist build
    python3 -m build --no-isolation --wheel
    rm -rf /tmp/venv && python3 -m venv --system-site-packages /tmp/venv
    /tmp/venv/bin/pip install --no-index --disable-pip-version-check dist/*.whl
    cd /
    /tmp/venv/bin/python -c "import lober; assert lober.__file__.startswith(\"/tmp/venv/\"); lober.test()" | sed "s/^/== /"
    echo "== $(ls /source/python/dist)"'
}

# The packages of a build that may have had a part in it; another version of one gives other bytes.
built_with() { sed -n '/^Installed-Build-Depends:/,/^[A-Z].*:/s/^ //p' "$1"/*.buildinfo; }

# shellcheck disable=SC2016
same_packages_again() {
  install_in_root build-essential
  rm -rf "$root/root/elsewhere"
  mkdir -p "$root/root/elsewhere"
  cp -r "$root/source" "$root/root/elsewhere/lober-again"
  rm -rf "$root/root/elsewhere/lober-again/python/"{dist,build,lober.egg-info}
  shell_in_root '
    cd /root/elsewhere/lober-again
    apt-get build-dep -y -qq --no-install-recommends ./
    umask 002
    export TZ=Pacific/Kiritimati LC_ALL=C LANGUAGE=fr HOME=/nowhere CCACHE_DISABLE=1
    DEB_BUILD_OPTIONS="noautodbgsym parallel=$(nproc)" dpkg-buildpackage --build=binary --no-sign'
  local package different=
  for package in "$packages"/*.deb; do
    cmp "$package" "$root/root/elsewhere/$(basename "$package")" || different+=" $(basename "$package")"
  done
  if [ -n "$different" ]; then
    echo "diffoscope shows what differs in$different: $packages, $root/root/elsewhere"
    echo "packages that they were built with, where the versions differ: here and there"
    diff <(built_with "$packages") <(built_with "$root/root/elsewhere") || true
    return 1
  fi
  echo "== $(ls "$packages"/*.deb | wc -l) packages are the same bytes"
}

step lintian lintian_has_no_errors
step clean-root clean_root
step install user_installs
step program program_runs
step manual manual_and_completions
step python python_runs
step suggested-libraries suggested_libraries
step documents documents_are_there
step removal nothing_is_left
step c-and-c++ programs_in_c_and_cpp
step removal-of-development nothing_is_left
step without-batches builds_without_batches
step wheel wheel
step same-bytes same_packages_again
echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
