#!/bin/sh
# own-database.sh FOLDER PORT: runs a database server of the caller's own in the foreground, on what
# the folder holds. It can be stopped, killed, and started again.
set -eu

services=$(cd "$(dirname "$0")" && pwd -P)

say() {
  echo "own database: $1" >&2
}

. "$services/debian.sh"
. "$services/database.sh"

database_folder=$1
port=$2
mkdir -p "$database_folder"
find_database
[ -d "$database_folder/data" ] || initialise_database
"run_$brand"
