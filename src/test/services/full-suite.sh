#!/bin/sh
# Runs every test of the product, with a browser, a stock Tomcat and a real database server on
# private ports. ./toqa test calls it with JAVA_HOME set.
set -eu

services=$(cd "$(dirname "$0")" && pwd -P)
root=$(cd "$services/../../.." && pwd -P)

say() {
  echo "toqa test: $1" >&2
}

. "$services/debian.sh"
. "$services/python.sh"
. "$services/database.sh"

usage() {
  cat <<'END'
Usage: ./toqa test

Runs the full test suite. On Debian it brings what it needs: Chromium, socat, iproute2, faketime
and the compilers of the firmware (installed when you are root, named when not), a private MySQL
server with its client and the fuzzer Schemathesis (unpacked into ~/.cache/toqa, not installed).
TOQA_TEST_MYSQL_URL=jdbc:mysql://... uses a server of yours instead; its user must be allowed to
create databases.
END
}

case ${1:-} in
  "") ;;
  -h | --help)
    usage
    exit 0
    ;;
  *)
    say "\"$1\" is not known (./toqa test --help)"
    exit 2
    ;;
esac

finish() {
  trap - EXIT INT TERM
  [ -z "${maven:-}" ] || kill "$maven" 2>/dev/null || true
  stop_database
}
trap finish EXIT
trap 'exit 130' INT
trap 'exit 143' TERM

require chromium chromium
require make make
require cc gcc
require avr-gcc gcc-avr
require_file /usr/lib/avr/include/avr/io.h avr-libc
require_file /usr/include/simavr/sim_avr.h libsimavr-dev
require cppcheck cppcheck
require socat socat
require ip iproute2
require faketime faketime
require python3 python3

cd "$root"
say "testing the firmware"
make -s -C firmware test sim
schemathesis
start_database
[ "${brand:-}" != mysql ] || find_mysql_client

./mvnw -B -ntp verify -Pfull -Dtoqa.mysql.url="$database_url" -Dtoqa.schemathesis="$fuzzer" &
maven=$!
status=0
wait "$maven" || status=$?
maven=
exit "$status"
