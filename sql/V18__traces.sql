-- Which tasks a user follows, each user a list of his own. It goes with the user, and with the task.
create table traces (
  user_id bigint not null,
  task_id bigint not null,
  since datetime(3) not null,
  primary key (user_id, task_id),
  constraint traces_user foreign key (user_id) references users (id) on delete cascade,
  constraint traces_task foreign key (task_id) references tasks (id) on delete cascade
);
