# What the tests take from Debian: installed packages, and packages that are only unpacked.

cache=${XDG_CACHE_HOME:-$HOME/.cache}/toqa/services

# require COMMAND PACKAGE: installs the package where the command is missing, or names it.
require() {
  command -v "$1" >/dev/null || install "$1" "$2"
}

# require_file FILE PACKAGE: the same for a package that brings no command.
require_file() {
  [ -f "$1" ] || install "$1" "$2"
}

# install WHAT PACKAGE
install() {
  if [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null; then
    say "installing $2"
    apt-get -q update >&2
    DEBIAN_FRONTEND=noninteractive apt-get -q -y --no-install-recommends install "$2" >&2
  else
    say "needs $1: install it (Debian: apt-get install $2) and try again"
    exit 1
  fi
}

# The Debian mirror that this machine uses.
mirror() {
  apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' | grep '/debian/$' | head -n 1
}

# unpack SUITE PACKAGE FOLDER: the package and all that it depends on, unpacked and not installed.
unpack() {
  [ -d "$3" ] && return
  command -v apt-get >/dev/null || return 1
  say "fetching $2"
  part=$3.$$
  mkdir -p "$part/lists/partial" "$part/cache/archives/partial" "$part/root"
  keyring=/usr/share/keyrings/debian-archive-keyring.gpg
  echo "deb [signed-by=$keyring] $(mirror) $1 main" >"$part/sources.list"
  if private_apt "$part" update && private_apt "$part" --download-only install "$2"; then
    for package in "$part"/cache/archives/*.deb; do
      dpkg -x "$package" "$part/root" || return 1
    done
    rm -rf "$part/lists" "$part/cache"
    mv "$part" "$3"
  else
    rm -rf "$part"
    return 1
  fi
} >&2

# apt-get as if nothing was installed, with everything it writes in one folder. A mirror may be
# weeks behind sid: its signature is checked, its date is not.
private_apt() {
  folder=$1
  shift
  apt-get -qq -y --no-install-recommends \
    -o Dir::Etc::sourcelist="$folder/sources.list" -o Dir::Etc::sourceparts=/nonexistent \
    -o Dir::State::lists="$folder/lists" -o Dir::State::status=/dev/null \
    -o Dir::Cache="$folder/cache" -o APT::Get::List-Cleanup=0 -o APT::Sandbox::User=root \
    -o Acquire::Check-Valid-Until=false -o Debug::NoLocking=1 "$@"
}

# within FOLDER PROGRAM ARGUMENTS...: runs an unpacked program with the libraries beside it.
within() {
  system=$1/root
  program=$2
  shift 2
  libraries=$(dirname "$(find "$system/usr/lib" "$system/lib" -name libc.so.6 2>/dev/null | head -n 1)")
  loader=$(find "$libraries" -name 'ld-linux*.so.*' | head -n 1)
  exec "$loader" --library-path "$libraries:$system/usr/lib/$(basename "$libraries")" \
    "$system$program" "$@"
}
