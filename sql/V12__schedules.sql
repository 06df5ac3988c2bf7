-- Tasks that are put in by themselves, once or again and again.
create table schedules (
  id bigint not null auto_increment primary key,
  submission char(36) not null, -- names the wish to add it
  name varchar(100) not null,
  user_name varchar(64) not null,
  floor varchar(64),
  load_kg double not null,
  load_length double, -- metres
  load_width double,
  start_x double, -- where there is no station
  start_y double,
  start_station varchar(64),
  goal_x double,
  goal_y double,
  goal_station varchar(64),
  priority int not null,
  kind enum('ONCE', 'EVERY', 'WEEKLY') not null,
  first_at datetime(3), -- of ONCE and EVERY
  every_s bigint,
  weekdays varchar(64), -- MONDAY,TUESDAY
  time_of_day varchar(8),
  zone varchar(64),
  until_at datetime(3),
  paused boolean not null,
  created_at datetime(3) not null,
  due_at datetime(3), -- null: never again
  last_task bigint,
  constraint schedules_submission unique (submission),
  key schedules_due_at (due_at)
);
