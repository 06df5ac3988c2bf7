-- A person has put the task on hold.
alter table tasks add column held boolean not null default false;
-- What becomes of the load on board of a task that was cancelled.
alter table tasks add column ending enum('HERE', 'BACK');
-- Where the load stands if that is neither its start nor its goal.
alter table tasks add column set_down_x double;
alter table tasks add column set_down_y double;
-- The robot that cannot go on with the task, why, where it was last, and whether the task waits for it.
alter table tasks add column trouble_robot varchar(64);
alter table tasks add column trouble_why varchar(300);
alter table tasks add column trouble_x double;
alter table tasks add column trouble_y double;
alter table tasks add column trouble_waits boolean not null default false;

-- A person has put the robot on hold.
alter table robots add column held boolean not null default false;

-- At most one row: all robots are paused.
create table fleet_pause (
  id tinyint not null primary key,
  user_name varchar(64) not null,
  at datetime(3) not null
);
