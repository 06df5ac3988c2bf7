-- What the replay shows beside tracks, each for as long as it was so. at, until: milliseconds since
-- 1970; until null: it still is. Lengths and places: millimetres, map frame.

-- Where loads were.
create table load_places (
  load_id bigint not null,
  at bigint not null,
  until bigint,
  floor varchar(64) not null,
  task_id bigint not null, -- that it was of
  robots text, -- with blanks between, the leader first; null: it was on none
  x int, -- null: on its robots
  y int,
  load_length int, -- null: nobody said
  load_width int,
  primary key (load_id, at)
);
create index load_places_floor on load_places (floor, until);

-- Which paths robots had ahead.
create table planned_paths (
  robot_id bigint not null,
  at bigint not null,
  until bigint,
  floor varchar(64) not null,
  points mediumtext not null, -- JSON: x and y of each in turn, where the robot was at first
  primary key (robot_id, at),
  constraint planned_paths_robot foreign key (robot_id) references robots (id) on delete cascade
);
create index planned_paths_floor on planned_paths (floor, until);
create index load_places_until on load_places (until);
create index planned_paths_until on planned_paths (until);

-- Who has chosen how to be told of notices is told on pages of the kind that is new.
insert into notice_choices (user_id, kind, channel)
select user_id, 'schedule-refused', 'badge' from notice_preferences;
