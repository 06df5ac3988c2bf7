#!/bin/sh
# Runs every test of the product, with a browser, a stock Tomcat and a real database server on
# private ports. ./toqa test calls it with JAVA_HOME set.
set -eu

services=$(cd "$(dirname "$0")" && pwd -P)
root=$(cd "$services/../../.." && pwd -P)
tally=$root/target/tally.tsv

say() {
  echo "toqa test: $1" >&2
}

. "$services/debian.sh"
. "$services/python.sh"
. "$services/database.sh"

usage() {
  cat <<'END'
Usage: ./toqa test [--long] [--seed N]

Runs the full test suite, and says at its end how much it did of each kind.

  --long    as much as the documents state: 1,000 generated floors of each kind, a million fuzzed
            inputs of each target, 200 runs with crashes, 100 examples for each route of the API,
            eighty times the tries of each property, all attacks in each field, the walk over all pages with pictures, all from a
            new seed, which it prints; without it a sample from seed 1
  --seed N  begins from this seed: the same seed tries the same

Nothing is left out: what this machine lacks is named, all at once. On Debian and Ubuntu it brings
what it needs: Chromium, socat, iproute2, nftables, dnsmasq, udhcpc, babeld, faketime and the compilers of the firmware (installed when
you are root), a private MySQL server with its client, Mosquitto and the fuzzer Schemathesis (unpacked
into ~/.cache/toqa, not installed). Network cables are pulled by root alone.
TOQA_TEST_MYSQL_URL=jdbc:mysql://... uses a server of yours where it is only talked to; its user
must be allowed to create databases. The tests that kill one fail then.
END
}

wrong() {
  say "$1 (./toqa test --help)"
  exit 2
}

tier=sample
seed=
while [ $# -gt 0 ]; do
  case $1 in
    --long) tier=long ;;
    --seed)
      shift
      case ${1:-} in
        "" | *[!0-9]* | ??????????*) wrong "--seed needs a whole number of at most nine digits" ;;
      esac
      seed=$1
      ;;
    -h | --help)
      usage
      exit 0
      ;;
    *) wrong "\"$1\" is not known" ;;
  esac
  shift
done

case $tier in
  long)
    seed=${seed:-$(($(od -An -N4 -tu4 /dev/urandom) % 1000000000))}
    size="-Dtoqa.floors=1000 -Dtoqa.crashes=200 -Dtoqa.tries=80"
    size="$size -Dtoqa.fuzz.inputs=1000000 -Dtoqa.fuzz.examples=100 -Dtoqa.walk=whole -Dtoqa.attacks=whole"
    ;;
  sample)
    seed=${seed:-1}
    size="-Dtoqa.floors=4 -Dtoqa.crashes=5 -Dtoqa.tries=1"
    size="$size -Dtoqa.fuzz.inputs=10000 -Dtoqa.fuzz.examples=2"
    ;;
esac

# Ends everything that the tests started, also what they started themselves.
end_maven() {
  [ -n "${maven:-}" ] || return 0
  kill -TERM "-$maven" 2>/dev/null || true
  tenths=100
  while kill -0 "-$maven" 2>/dev/null && [ "$tenths" -gt 0 ]; do
    sleep 0.1
    tenths=$((tenths - 1))
  done
  kill -KILL "-$maven" 2>/dev/null || true
}

# The network namespaces of robots, and their cables: see RobotNetwork.
remove_networks() {
  command -v ip >/dev/null || return 0
  mark=tq$(($$ % 10000))
  ip netns list 2>/dev/null | sed -n "s/^\(${mark}[rp][^ ]*\).*/\1/p" | while read -r space; do
    ip netns pids "$space" | xargs -r kill 2>/dev/null || true # babelds, which outlive their daemons
    ip netns delete "$space" || true
  done
  ip route delete unreachable "10.232.$(($$ % 10000 % 250)).0/24" 2>/dev/null || true
  ip -o link 2>/dev/null | sed -n "s/^[0-9]*: \(${mark}[cs][0-9]*\)[@:].*/\1/p" |
    while read -r link; do
      ip link delete "$link" 2>/dev/null || true
    done
}

finish() {
  trap - EXIT
  trap '' INT TERM HUP
  end_maven
  [ -z "${firmware:-}" ] || kill "$firmware" 2>/dev/null || true
  stop_database
  remove_networks
  [ -z "${folder:-}" ] || rm -rf "$folder"
  [ -z "${memory:-}" ] || rm -rf "$memory"
  remove_unfinished
}
trap finish EXIT
trap 'exit 129' HUP
trap 'exit 130' INT
trap 'exit 143' TERM

# How much was done; false where something was left out, or nothing of a kind was done.
report() {
  [ -f "$tally" ] || return 1
  echo "toqa test: what was done, the $tier from seed $seed"
  awk -F '\t' '
    $1 == "left out" { print "left out, which must not be: " $3; bad = 1; next }
    { sum[$1] += $2 }
    END {
      for (kind in sum) printf "%12d  %s\n", sum[kind], kind | "sort -k 2"
      close("sort -k 2")
      exit bad
    }' "$tally" || return 1
  all=0
  while read -r kind; do
    grep -q "^$kind	[1-9]" "$tally" || {
      echo "not done: $kind"
      all=1
    }
  done <<'END'
unit tests
browser tests
packaged tests
properties
property tries
paths of known length
generated floors
runs with crashes
possible carries
legs of groups
crashes between two events of a task
attack strings
looks at pages by axe
requests by Schemathesis
fuzz inputs of the server
fuzz inputs of the daemon
fuzz inputs of the frames of the microcontroller
fuzz inputs of a serial stream
fuzz inputs of the readers of maps
END
  return "$all"
}

cd "$root"
folder=$(mktemp -d)
memory=$(mktemp -d -p /dev/shm 2>/dev/null || mktemp -d)
TMPDIR=$folder
export TMPDIR
mkdir -p target
say "building, while what is missing is fetched"
# A session of its own, so that all of it can be ended.
setsid ./mvnw -B -ntp -Pfull -DskipTests -DskipITs verify >"$folder/build.log" 2>&1 &
maven=$!

command -v chromium-browser >/dev/null || command -v google-chrome >/dev/null ||
  require chromium chromium
# Where it can be had, tests take the browser without a desktop: a quarter less work, same pages.
[ "$(distribution)" != debian ] || require chromium-headless-shell chromium-headless-shell
require make make
require cc gcc
require avr-gcc gcc-avr
require_file /usr/lib/avr/include/avr/io.h avr-libc
require_file /usr/include/simavr/sim_avr.h libsimavr-dev
require cppcheck cppcheck
require socat socat
require ip iproute2
require nft nftables
require dnsmasq dnsmasq-base
require udhcpc udhcpc
require babeld babeld
require faketime faketime
require setsid util-linux
require systemd-analyze systemd
require python3 python3
python3 -c 'import ensurepip' 2>/dev/null || missing="$missing python3-venv"
install_missing
[ "$(id -u)" = 0 ] ||
  say "you are not root: the tests that pull network cables will fail (sudo -E ./toqa test)"

say "the $tier, from seed $seed: ${size}"
say "testing the firmware"
make -s -C firmware test sim &
firmware=$!
schemathesis
start_database
[ "${brand:-}" != mysql ] || find_mysql_client
wait "$firmware"
firmware=
wait "$maven" || {
  cat "$folder/build.log" >&2
  exit 1
}

: >"$tally"
# All is built and packaged: the tests alone. Planners compute; all others wait in turn, and share
# a pool.
# shellcheck disable=SC2086 # the size is words
setsid ./mvnw -B -ntp -Pfull toolchains:select-jdk-toolchain@default surefire:test@default-test \
  failsafe:integration-test@default failsafe:verify@default \
  -Dtoqa.full=true -Dtoqa.seed="$seed" $size \
  -Dtest.unpackaged='%regex[org/toqa/(traffic|planning)/.*(Test|IT)\.class]' \
  -Dtest.packaged='%regex[org/toqa/(?!traffic/|planning/).*(Test|IT)\.class]' \
  -Dtoqa.run=$$ -Dtest.folder="$folder" -Dtoqa.memory="$memory" \
  -Dtoqa.mysql.url="$database_url" -Dtoqa.schemathesis="$fuzzer" &
maven=$!
status=0
wait "$maven" || status=$?
report || [ "$status" -ne 0 ] || status=1
exit "$status"
