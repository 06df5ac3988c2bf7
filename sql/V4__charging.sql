-- How long the robot has worked since it last charged, in seconds.
alter table robots add column worked_s double not null default 0;
-- The charging point that it charges at, drives to or waits for, and since when; null: none.
alter table robots add column charger varchar(64);
alter table robots add column charger_since datetime(3);
