# What the tests take from Debian: installed packages, and packages that are only unpacked.

cache=${XDG_CACHE_HOME:-$HOME/.cache}/toqa/services

# Where the system keeps its settings; the test of this script has samples of its own.
etc=${etc:-/etc}

missing=

# require COMMAND PACKAGE: remembers the package where the command is missing.
require() {
  command -v "$1" >/dev/null || missing="$missing $2"
}

# require_file FILE PACKAGE: the same for a package that brings no command.
require_file() {
  [ -f "$1" ] || missing="$missing $2"
}

# Installs all that is missing, or names all of it.
install_missing() {
  [ -n "$missing" ] || return 0
  if [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null; then
    say "installing$missing"
    apt-get -q update >&2
    # shellcheck disable=SC2086 # packages are words
    DEBIAN_FRONTEND=noninteractive apt-get -q -y --no-install-recommends install $missing >&2
  else
    say "missing:$missing"
    say "install it and try again (Debian, Ubuntu: sudo apt-get install$missing)"
    exit 1
  fi
}

# "debian" or "ubuntu", also on a system that is made of one of them.
distribution() (
  . "$etc/os-release"
  case " $ID ${ID_LIKE:-} " in
    *" ubuntu "*) echo ubuntu ;;
    *) echo debian ;;
  esac
)

# The name of the release, such as "bookworm" or "noble".
release() (
  . "$etc/os-release"
  echo "${UBUNTU_CODENAME:-$VERSION_CODENAME}"
)

# The mirror of Debian or Ubuntu that this machine uses, whichever way its sources are written:
# apt itself reads them. Archives of others have addresses that look the same, but no "universe".
mirror() {
  case $(distribution) in
    ubuntu)
      found=$(sources | sed -n "s/^$(release) universe //p" | head -n 1)
      case $(dpkg --print-architecture) in
        amd64 | i386) usual=http://archive.ubuntu.com/ubuntu/ ;;
        *) usual=http://ports.ubuntu.com/ubuntu-ports/ ;;
      esac
      ;;
    *)
      found=$(sources | sed -n 's/^[^ ]* main \(.*\/debian\/\)$/\1/p' | head -n 1)
      usual=http://deb.debian.org/debian/
      ;;
  esac
  echo "${found:-$usual}"
}

# A line for each: RELEASE COMPONENT ADDRESS.
sources() {
  apt-get -o Dir::Etc="$etc/apt" indextargets --format '$(RELEASE) $(COMPONENT) $(REPO_URI)' \
    'Created-By: Packages'
}

# unpack SUITE PACKAGE FOLDER: the package and all that it depends on, unpacked and not installed.
unpack() {
  [ -d "$3" ] && return
  command -v apt-get >/dev/null || return 1
  say "fetching $2"
  part=$3.$$
  mkdir -p "$part/lists/partial" "$part/cache/archives/partial" "$part/root"
  components=main
  [ "$(distribution)" = debian ] || components="main universe"
  keyring=/usr/share/keyrings/$(distribution)-archive-keyring.gpg
  echo "deb [signed-by=$keyring] $(mirror) $1 $components" >"$part/sources.list"
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
