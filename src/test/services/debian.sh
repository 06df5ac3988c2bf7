# What the tests take from Debian: installed packages, and packages that are only unpacked.

cache=${XDG_CACHE_HOME:-$HOME/.cache}/toqa/services

# Where the system keeps its settings; the test of this script has samples of its own.
etc=${TOQA_TEST_ETC:-/etc}

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

# The mirror of Debian or Ubuntu that this machine uses, whichever way its sources are written.
# Archives of others have addresses that look the same as Ubuntu's, but no "universe".
mirror() {
  case $(distribution) in
    ubuntu) found=$(sources | sed -n "s/^$(release) universe //p" | head -n 1) ;;
    *) found=$(sources | sed -n 's/^[^ ]* main \(.*\/debian\/\)$/\1/p' | head -n 1) ;;
  esac
  [ -n "$found" ] || {
    say "found no package source of $(distribution) in $etc/apt; add one and try again"
    return 1
  }
  echo "$found"
}

# A line for each: RELEASE COMPONENT ADDRESS/. Read here, for apt tells only those that it has
# fetched, and a new machine has fetched none.
sources() {
  for list in "$etc/apt/sources.list" "$etc"/apt/sources.list.d/*.list; do
    [ ! -f "$list" ] || sed -n 's/^deb[[:blank:]][[:blank:]]*\(\[[^]]*\] *\)\{0,1\}//p' "$list"
  done | awk '{ sub(/\/*$/, "/", $1); for (i = 3; i <= NF && $i !~ /^#/; i++) print $2, $i, $1 }'
  for paragraphs in "$etc"/apt/sources.list.d/*.sources; do
    [ ! -f "$paragraphs" ] || awk '
      function tell(addresses, releases, components, a, r, c) {
        if (types ~ /(^| )deb( |$)/ && enabled !~ /no|false/) {
          addresses = split(uris, address); releases = split(suites, release)
          components = split(parts, component)
          for (a = 1; a <= addresses; a++) for (r = 1; r <= releases; r++)
            for (c = 1; c <= components; c++) {
              sub(/\/*$/, "/", address[a])
              print release[r], component[c], address[a]
            }
        }
        types = uris = suites = parts = enabled = ""
      }
      /^#/ { next }
      /^[ \t]*$/ { tell(); next }
      /^[^ \t]/ { key = tolower($1) }
      {
        value = $0
        sub(/^[^ \t:]*:?/, "", value)
        if (key == "types:") types = types value
        if (key == "uris:") uris = uris value
        if (key == "suites:") suites = suites value
        if (key == "components:") parts = parts value
        if (key == "enabled:") enabled = tolower(value)
      }
      END { tell() }' "$paragraphs"
  done
}

# unpack SUITE PACKAGE FOLDER: the package and all that it depends on, unpacked and not installed.
unpack() {
  [ -d "$3" ] && return
  command -v apt-get >/dev/null || return 1
  say "fetching $2"
  source=$(mirror) || return 1
  part=$3.$$
  mkdir -p "$part/lists/partial" "$part/cache/archives/partial" "$part/root"
  components=main
  [ "$(distribution)" = debian ] || components="main universe"
  keyring=/usr/share/keyrings/$(distribution)-archive-keyring.gpg
  echo "deb [signed-by=$keyring] $source $1 $components" >"$part/sources.list"
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

# What was being made here when it was ended, or failed.
remove_unfinished() {
  rm -rf "$cache"/*.$$ "$cache"/*/*.$$
}

# apt-get as if nothing was installed, with everything it writes in one folder. A mirror may be
# weeks behind sid: its signature is checked, its date is not.
private_apt() {
  apt_folder=$1
  shift
  apt-get -qq -y --no-install-recommends \
    -o Dir::Etc::sourcelist="$apt_folder/sources.list" -o Dir::Etc::sourceparts=/nonexistent \
    -o Dir::State::lists="$apt_folder/lists" -o Dir::State::status=/dev/null \
    -o Dir::Cache="$apt_folder/cache" -o APT::Get::List-Cleanup=0 -o APT::Sandbox::User=root \
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
