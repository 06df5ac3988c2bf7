-- The last exploration of each floor.
create table explorations (
  floor varchar(64) not null primary key,
  ground varchar(80) not null, -- scene: or floor: and its name
  robots int not null,
  start_x double precision not null, -- metres, map frame
  start_y double precision not null,
  target_x double precision not null,
  target_y double precision not null,
  seed bigint not null,
  user_name varchar(64) not null,
  revision bigint not null, -- that the draft of the floor had when it began
  started_at datetime(3) not null,
  ended_at datetime(3),
  state enum('RUNNING', 'REACHED', 'NO_WAY', 'LOST', 'OUT_OF_TIME', 'STOPPED', 'FAILED', 'INTERRUPTED') not null,
  draft enum('NONE_YET', 'SAVED', 'NOT_SAVED') not null, -- what has become of what was seen
  picture mediumtext not null -- JSON: time, way, robots, track, and the cells that were seen
);
