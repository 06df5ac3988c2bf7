-- Runs of experiments that managers ordered.
create table lab_runs (
  id bigint not null auto_increment primary key,
  experiment varchar(64) not null,
  seed bigint not null,
  runs int not null,
  parameters text not null, -- those that were set, JSON
  user_name varchar(64) not null,
  ordered_at datetime(3) not null,
  started_at datetime(3),
  ended_at datetime(3),
  state enum('QUEUED', 'RUNNING', 'DONE', 'STOPPED', 'FAILED', 'BROKEN_OFF') not null,
  detail varchar(1000), -- why it failed
  report mediumtext -- of one that is done, JSON
);

-- What they have drawn.
create table lab_drawings (
  run_id bigint not null,
  position int not null,
  name varchar(64) not null,
  title varchar(200) not null,
  svg mediumtext not null,
  motion mediumtext, -- how bodies move over it, JSON; null: nothing does
  primary key (run_id, position),
  constraint lab_drawings_run foreign key (run_id) references lab_runs (id) on delete cascade
);
