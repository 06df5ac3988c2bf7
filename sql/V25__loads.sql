-- Which load a task has, by the first task that had it, and since when that is where it is.
-- Both null: the task's own, at its start since the task was ordered.
alter table tasks add column load_id bigint;
alter table tasks add column load_since datetime(3);
