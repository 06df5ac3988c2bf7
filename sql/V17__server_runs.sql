-- One row: the server's last run. Not ended: it goes on, or its process was killed.
create table server_runs (
  id tinyint not null primary key,
  began_at datetime(3) not null,
  ended_at datetime(3)
);
