#!/bin/sh
# mysql-client.sh mysqldump|mysql ARGUMENTS...: runs a program of MySQL's client.
set -eu

services=$(cd "$(dirname "$0")" && pwd -P)

say() {
  echo "MySQL client: $1" >&2
}

. "$services/debian.sh"
. "$services/database.sh"

find_mysql_client
program=$1
shift
within "$cache/mysql-client" "/usr/bin/$program" --no-defaults "$@"
