-- Names the wish to add a task, so that it can be taken back when nobody knows whether it was stored.
alter table tasks add column submission char(36);
alter table tasks add constraint tasks_submission unique (submission);
create index tasks_changed on tasks (changed_at);

create index events_robot on events (robot, id);
create index events_who on events (who, id);
create index events_kind on events (kind, id);

-- Where robots were: a point where the way bends. Millimetres, map frame; at: milliseconds since 1970.
create table tracks (
  robot_id bigint not null,
  at bigint not null,
  x int not null,
  y int not null,
  primary key (robot_id, at),
  constraint tracks_robot foreign key (robot_id) references robots (id) on delete cascade
);
