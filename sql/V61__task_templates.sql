-- sql/V61__task_templates.sql
-- Orders of tasks that are given again and again. task_order: as the API takes it, but for its floor; parameters: JSON, of each its
-- name and the field of the order that it fills. user_id as of schedules.
create table task_templates (
  id bigint not null auto_increment primary key,
  name varchar(100) not null,
  name_key varchar(100) not null, -- lower case
  floor varchar(64) not null,
  task_order text not null,
  parameters text not null,
  shared boolean not null,
  user_name varchar(64) not null,
  user_id bigint,
  changed_at datetime(3) not null,
  constraint task_templates_name unique (name_key),
  constraint task_templates_user foreign key (user_id) references users (id) on delete set null
);
