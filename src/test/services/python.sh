# What the tests take from Python's package index, in an environment of its own.

# schemathesis: sets $fuzzer to the program. It and all that it needs are of the versions that
# schemathesis.txt lists.
schemathesis() {
  environment=$cache/schemathesis-$(cksum <"$services/schemathesis.txt" | cut -d ' ' -f 1)
  fuzzer=$environment/bin/schemathesis
  [ -x "$fuzzer" ] && return
  say "fetching Schemathesis"
  if python3 -m venv "$environment" &&
    "$environment/bin/pip" -q install -r "$services/schemathesis.txt"; then
    return
  fi
  rm -rf "$environment"
  say "Schemathesis, which fuzzes the API, cannot be fetched: is the index of Python packages reached?"
  exit 1
} >&2
