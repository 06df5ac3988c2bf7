-- A person has taken the robot out of service; it outlives a restart.
alter table robots add column out_of_service boolean not null default false;
