# A private database server for one run: MySQL, or MariaDB where MySQL cannot be had.

database_server=
database_folder=

# Sets database_url.
start_database() {
  if [ -n "${TOQA_TEST_MYSQL_URL:-}" ]; then
    database_url=$TOQA_TEST_MYSQL_URL
    return
  fi
  find_database
  database_folder=$(mktemp -d)
  log=$database_folder/log
  say "starting $("${brand}_server" --version | sed 's/.* Ver \([^ ]*\).*/'"$brand"' \1/')"
  initialise_database >"$log" 2>&1 || database_failed
  for _ in 1 2 3 4 5; do
    port=$(free_port)
    "run_$brand" >"$log" 2>&1 &
    database_server=$!
    if database_answers; then
      database_url="jdbc:mysql://127.0.0.1:$port/?user=root"
      return
    fi
  done
  database_failed
}

# A port of this machine that nobody has now; MySQL takes none of its own choice.
free_port() {
  python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])'
}

# Sets brand; what it names is unpacked.
find_database() {
  mkdir -p "$cache"
  case $(distribution) in
    ubuntu) set -- "$(release)" default-mysql-server-core ;;
    *) set -- sid mysql-server-core ;;
  esac
  if unpack "$1" "$2" "$cache/mysql"; then
    brand=mysql
  elif unpack "$(release)" mariadb-server-core "$cache/mariadb"; then
    brand=mariadb
    say "$2 of $1 cannot be had; the tests run on MariaDB, and those that need MySQL fail"
  else
    say "found no database server; start a MySQL and name it by TOQA_TEST_MYSQL_URL"
    exit 1
  fi
}

# The programs that back MySQL up and restore it are unpacked.
find_mysql_client() {
  mkdir -p "$cache"
  client_release=sid
  [ "$(distribution)" = debian ] || client_release=$(release)
  if ! unpack "$client_release" mysql-client "$cache/mysql-client"; then
    say "found no client of MySQL: mysql-client of $client_release cannot be had"
    exit 1
  fi
}

# Waits for at most a minute; false where the server ended, as when another one has the port.
database_answers() {
  seconds=60
  while kill -0 "$database_server" 2>/dev/null && [ "$seconds" -gt 0 ]; do
    grep -q "ready for connections" "$log" && grep -q "port: $port" "$log" && return
    sleep 1
    seconds=$((seconds - 1))
  done
  return 1
}

database_failed() {
  cat "$log" >&2
  say "the database server does not start"
  exit 1
}

stop_database() {
  if [ -n "$database_server" ]; then
    kill "$database_server" 2>/dev/null || true
    wait "$database_server" 2>/dev/null || true
  fi
  if [ -n "$database_folder" ]; then
    rm -rf "$database_folder"
  fi
}

# Makes an empty database; the first one is kept beside the server's program, and copied from then
# on: a fifteenth of the work.
initialise_database() {
  empty=$cache/$brand/empty
  if [ -d "$empty" ]; then
    cp -R "$empty" "$database_folder/data"
    return
  fi
  "initialise_$brand" || return
  # Somebody else may be as far; then theirs is kept.
  cp -R "$database_folder/data" "$empty.$$" && mv -T "$empty.$$" "$empty" || rm -rf "$empty.$$"
}

mysql_server() {
  within "$cache/mysql" /usr/sbin/mysqld --no-defaults --user="$(id -un)" \
    --basedir="$cache/mysql/root/usr" --lc-messages-dir="$cache/mysql/root/usr/share/mysql" \
    --datadir="$database_folder/data" "$@"
}

initialise_mysql() (
  mysql_server --initialize-insecure
)

# Who kills it loses nothing of what it has written, also where the disk has not. On a machine that
# does much at once a client may take long to log in.
run_mysql() {
  mysql_server --plugin-dir="$cache/mysql/root/usr/lib/mysql/plugin" \
    --character-sets-dir="$cache/mysql/root/usr/share/mysql/charsets" \
    --port="$port" --bind-address=127.0.0.1 --socket="$database_folder/socket" \
    --mysqlx=OFF --secure-file-priv=NULL --performance-schema=OFF \
    --innodb-flush-log-at-trx-commit=2 --skip-log-bin --connect-timeout=300
}

mariadb_server() {
  within "$cache/mariadb" /usr/sbin/mariadbd --no-defaults --user="$(id -un)" \
    --basedir="$cache/mariadb/root/usr" --lc-messages-dir="$cache/mariadb/root/usr/share/mysql" \
    --datadir="$database_folder/data" "$@"
}

initialise_mariadb() (
  tables=$cache/mariadb/root/usr/share/mysql
  mkdir -p "$database_folder/data/mysql"
  {
    echo "use mysql;"
    cat "$tables/mysql_system_tables.sql" "$tables/mysql_performance_tables.sql" \
      "$tables/mysql_system_tables_data.sql"
  } | mariadb_server --bootstrap
)

# Under its own version Connector/J takes MariaDB 10 for a MySQL 5.5 and drops fractions of seconds.
run_mariadb() {
  mariadb_server --version=5.7.19-MariaDB --skip-grant-tables \
    --port="$port" --bind-address=127.0.0.1 --socket="$database_folder/socket" \
    --connect-timeout=300
}
