-- When the task got its first robots, and when its load was delivered.
alter table tasks add column assigned_at datetime(3);
alter table tasks add column delivered_at datetime(3);
update tasks set assigned_at =
  (select min(at) from events where events.task_id = tasks.id and events.kind = 'task.assigned');
update tasks set delivered_at =
  (select max(at) from events where events.task_id = tasks.id and events.kind = 'task.delivered')
  where state in ('RETURNING', 'DONE');
create index tasks_created on tasks (created_at);
create index tasks_assigned on tasks (assigned_at, created_at);
create index tasks_delivered on tasks (delivered_at, created_at);
create index tasks_ended on tasks (changed_at, state, created_at);
alter table tasks drop index tasks_changed; -- the one before begins as it did

-- What a robot did in half an hour, or in the rest of one, from that moment on.
create table robot_use (
  at datetime(3) not null,
  robot_id bigint not null,
  working_ms int not null,
  travelling_ms int not null,
  charging_ms int not null,
  idle_ms int not null,
  held_ms int not null,
  troubled_ms int not null,
  lost_ms int not null,
  out_of_service_ms int not null,
  way_mm int not null,
  battery double not null, -- how much it fell; 1 is a full one
  primary key (at, robot_id),
  constraint robot_use_robot foreign key (robot_id) references robots (id) on delete cascade
);
