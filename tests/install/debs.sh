#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The Debian packages: which there are, what each has and depends on; and a host that is built and
# run with what was in them. One more argument: cpack.
# shellcheck source-path=SCRIPTDIR source=support.sh
. "$(dirname "${BASH_SOURCE[0]}")/support.sh"
quietly "$1" --config "$build/CPackConfig.cmake" -G DEB -B "$work"
cp -r "$source/tests/install/consumer" "$source/examples/cubic-bspline/cubic.c" "$work"
mv "$work/cubic.c" "$work/consumer"
cd "$work"

packages=("libawd$abi" libawd-dev libawd-bases)
wanted="bases" renderer=none
if [[ -f $build/lib/awd/refit-1.so ]]; then
  packages+=(libawd-refit)
  wanted+=";refit"
fi
if [[ -f $build/bin/awd ]]; then
  packages+=(awd-tools)
  wanted+=";render" renderer=render
fi
[[ ! -d $source/bindings/python/awd ]] || packages+=(python3-awd)
diff <(printf "%s_${version}_$(dpkg --print-architecture).deb\n" "${packages[@]}" |
  sed '/^python3-/s/_[^_]*\.deb/_all.deb/' | sort) \
  <(find . -maxdepth 1 -name '*.deb' | sed 's/..//' | sort) || die "not the packages"

# Nothing is in two packages, names a path of ours, or may be changed by others.
for package in "${packages[@]}"; do
  dpkg-deb -x "$package"_*.deb root
  dpkg-deb --fsys-tarfile "$package"_*.deb | tar -t | grep -v '/$' >>all
  [[ -f root/usr/share/doc/$package/copyright ]] || die "$package has no copyright"
done
[[ -z $(sort all | uniq -d) ]] || die "in two packages: $(sort all | uniq -d)"
! grep -rlF -e "$work" -e "$build" -e "$source" root || die "a path leaks"
[[ -z $(find root ! -user root -o -perm /022 ! -type l) ]] || die "others may write to it"

# depends PACKAGE NAMES: has a dependency on each.
depends() {
  local name list
  list=$(dpkg-deb -f "$1"_*.deb Depends)
  for name in "${@:2}"; do
    grep -qE "(^|, )$name( \(|,|$)" <<<"$list" || die "$1 does not depend on $name, but on $list"
  done
}
own=" libawd$abi (= $version)"
[[ " $(dpkg-deb -f libawd-dev_*.deb Depends)" == "$own" ]] || die "libawd-dev wants more: $own"
depends "libawd$abi" libc6 'libstdc\+\+6' libgcc-s1
[[ $renderer == none ]] || depends "libawd$abi" 'libembree[34]-.*' 'libopenexr-.*' 'libpng16.*'
! dpkg-deb -f "libawd$abi"_*.deb Depends | grep -E 'ceres|glog|cholmod|assimp|awd|-dev' ||
  die "the library depends on too much"
[[ $wanted != *refit* ]] || depends libawd-refit "libawd$abi" 'libgoogle-glog.*' libc6
[[ $renderer == none ]] || depends awd-tools "libawd$abi" libawd-bases 'libassimp.*' libc6
# Whoever links libawd gets its package by dpkg-shlibdeps, and the loader gets to know it.
dpkg-deb -I "libawd$abi"_*.deb shlibs >control
grep -qx "libawd $abi libawd$abi (>= $version)" control || die "no shlibs"
dpkg-deb -I "libawd$abi"_*.deb postinst >control
grep -q ldconfig control || die "no ldconfig"

# The host sees what was in the packages alone.
prefix=$work/root/usr
project host consumer "$prefix" -DAWD_WANTED="$version" -DAWD_COMPONENTS="$wanted"
[[ $(grep '^awd_DIR' host/CMakeCache.txt) == *"$prefix"* ]] || die "not the awd of the packages"
silent host/plain shipped "$renderer"
[[ $wanted != *refit* ]] || silent host/refit there
[[ $renderer == none ]] || quietly "$prefix/bin/awd" bases
finish
