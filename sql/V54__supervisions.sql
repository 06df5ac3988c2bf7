-- The last supervisor and its workers of each floor, and the boxes that they carry.
create table supervisions (
  floor varchar(64) not null primary key,
  run_key varchar(36) not null,
  supervisor varchar(64) not null,
  workers text not null, -- names, with commas between
  overlaps boolean not null, -- whether boxes are looked for while others are carried
  user_name varchar(64) not null,
  state enum('RUNNING', 'DONE', 'STOPPED') not null,
  begun_at datetime(3) not null,
  ended_at datetime(3),
  idle_seconds double not null, -- of all workers together
  boxes mediumtext not null, -- JSON: each with its target, place, weight, task, and whether it is delivered
  seen mediumtext not null -- cells of the floor that the supervisor has seen, packed
);
