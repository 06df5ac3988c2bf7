-- Names of the robots that may carry a task, with blanks between; null: whichever there are.
alter table tasks add column only_robots varchar(1400);
alter table schedules add column only_robots varchar(1400);
