-- Kilograms that the robot says it carries; null: it was never connected.
alter table robots add column told_load double;

-- How full robots' batteries were, when it had changed by a whole percent. at: milliseconds since 1970.
create table battery_levels (
  robot_id bigint not null,
  at bigint not null,
  percent smallint not null,
  primary key (robot_id, at),
  constraint battery_levels_robot foreign key (robot_id) references robots (id) on delete cascade
);
create index battery_levels_at on battery_levels (at);
