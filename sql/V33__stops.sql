-- All stops of a task, as JSON, the start first and the goal last; null: from start to goal, without a wait.
alter table tasks add column stops varchar(8000);
alter table schedules add column stops varchar(8000);
-- How far a task is on its way: the number, from 0, of the first stop that is not left, and since when robots wait there.
alter table tasks add column stop int not null default 0;
alter table tasks add column waiting_since datetime(3);
