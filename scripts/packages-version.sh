#!/usr/bin/env bash
# Fails where a file of debian/ or CITATION.cff has another version than engine/lober/base/version.hpp, the one source of
# it. With --update these files follow: the package of the shared library gets the name that Debian's policy wants for its
# SONAME (liblober.so.0.2: liblober0.2), and debian/changelog an entry with the time of now.
# usage: packages-version.sh [--update]
set -euo pipefail
cd "$(dirname "$0")/.."
version=$(sed -n 's/^#define LOBER_VERSION_[A-Z]* \([0-9]*\)$/\1/p' engine/lober/base/version.hpp | paste -sd .)
[[ $version =~ ^([0-9]+)\.([0-9]+)\.[0-9]+$ ]] || { echo "engine/lober/base/version.hpp has no version" >&2; exit 1; }
# As the SONAME in engine/shared.cmake.
library=liblober${BASH_REMATCH[1]}
[ "${BASH_REMATCH[1]}" != 0 ] || library+=.${BASH_REMATCH[2]}

packaged() { sed -n '1s/^lober (\([^)]*\)) .*/\1/p' debian/changelog; }
package_of_library() { sed -n 's/^Package: \(liblober[0-9.]*\)$/\1/p' debian/control; }
cited() { sed -n 's/^version: //p' CITATION.cff; }

if [ "${1:-}" = --update ]; then
  old=$(package_of_library)
  if [ "$old" != "$library" ]; then
    sed -i "s/\b${old//./\\.}\b/$library/g" debian/control
    mv "debian/$old.install" "debian/$library.install"
  fi
  sed -i "s/^version: .*/version: $version/" CITATION.cff
  if [ "$(packaged)" != "$version" ]; then
    maintainer=$(sed -n 's/^Maintainer: //p' debian/control)
    {
      printf 'lober (%s) bookworm; urgency=medium\n\n  * CHANGELOG.md has what is new in this version.\n\n' "$version"
      printf ' -- %s  %s\n\n' "$maintainer" "$(LC_ALL=C date -R)"
      cat debian/changelog
    } >debian/changelog.new
    mv debian/changelog.new debian/changelog
  fi
fi

failed=
differs() {
  echo "$1 has $2, but engine/lober/base/version.hpp means $3; scripts/packages-version.sh --update changes it" >&2
  failed=1
}
[ "$(packaged)" = "$version" ] || differs debian/changelog "version $(packaged)" "$version"
[ "$(package_of_library)" = "$library" ] || differs debian/control "the package $(package_of_library)" "$library"
[ -f "debian/$library.install" ] || differs debian "no $library.install" "$library"
[ "$(cited)" = "$version" ] || differs CITATION.cff "version $(cited)" "$version"
[ -z "$failed" ] || exit 1
echo "version $version, shared library $library: debian and CITATION.cff agree"
