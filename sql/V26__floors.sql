-- Floors, in the order of their places; the first is the default. A name is unique without regard
-- to case, by its lower-cased key. The revision rises with every change of map or draft.
create table floors (
  name_key varchar(64) not null primary key,
  name varchar(64) not null,
  place int not null,
  revision bigint not null
);

-- The maps that were and are in force on floors, also of those that are gone; the newest of a floor
-- is in force. Files: a ZIP file of a ROS map with its floor file.
create table floor_maps (
  id bigint auto_increment primary key,
  floor varchar(64) not null,
  since datetime(3) not null,
  user_name varchar(64),
  files mediumblob not null
);
create index floor_maps_floor on floor_maps (floor, since);

-- Which floor an event concerns; null: none, or all.
alter table events add column floor varchar(64);
update events set floor = (select floor from tasks where tasks.id = events.task_id)
where task_id is not null;
update events set floor = (select floor from robots where robots.name = events.robot)
where task_id is null and robot is not null;

create table floor_drafts (
  floor varchar(64) not null primary key,
  user_name varchar(64) not null,
  at datetime(3) not null,
  files mediumblob not null
);
