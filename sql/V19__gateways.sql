-- The gateway that reaches the robot, in whose network its host is; null: the server does.
alter table robots add column gateway varchar(64);
