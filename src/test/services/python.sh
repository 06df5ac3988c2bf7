# What the tests take from Python's package index, in an environment of its own.

# schemathesis: sets $fuzzer to the program; to nothing, and says so, where it cannot be fetched.
schemathesis() {
  fuzzer=$cache/schemathesis-4.32.5/bin/schemathesis
  [ -x "$fuzzer" ] && return
  python3 -c 'import ensurepip' 2>/dev/null || install "Python's venv" python3-venv
  say "fetching Schemathesis"
  environment=$cache/schemathesis-4.32.5
  if python3 -m venv "$environment" && "$environment/bin/pip" -q install schemathesis==4.32.5; then
    return
  fi
  rm -rf "$environment"
  fuzzer=
  say "Schemathesis cannot be fetched: the API is not fuzzed"
} >&2
