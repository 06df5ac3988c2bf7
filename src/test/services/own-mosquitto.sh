#!/bin/sh
# own-mosquitto.sh CONFIGURATION: runs a Mosquitto of the caller's own in the foreground. The
# package is unpacked, not installed: installed, it would serve the machine.
set -eu

services=$(cd "$(dirname "$0")" && pwd -P)

say() {
  echo "own mosquitto: $1" >&2
}

. "$services/debian.sh"

mkdir -p "$cache"
if ! unpack "$(release)" mosquitto "$cache/mosquitto"; then
  say "mosquitto of $(release) cannot be had"
  exit 1
fi
within "$cache/mosquitto" /usr/sbin/mosquitto -c "$1"
