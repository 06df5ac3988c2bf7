-- Of 100 letters, each of which H2 counts as two characters where it is outside the first plane
alter table tasks modify column name varchar(200) not null;
alter table schedules modify column name varchar(200) not null;
alter table orders modify column name varchar(200) not null;
alter table task_templates modify column name varchar(200) not null;
alter table task_templates modify column name_key varchar(200) not null;
-- Likewise of 64
alter table sessions modify column name varchar(128);
alter table tasks modify column start_station varchar(128);
alter table tasks modify column goal_station varchar(128);
alter table schedules modify column start_station varchar(128);
alter table schedules modify column goal_station varchar(128);
alter table robots modify column parking varchar(128);
alter table robots modify column charger varchar(128);
