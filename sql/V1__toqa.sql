-- Runs unchanged on MySQL and on H2 in its MySQL mode. Times are UTC.

create table users (
  id bigint not null auto_increment primary key,
  name varchar(64) not null,
  name_key varchar(64) not null, -- lower-cased: MySQL folds case in a comparison, H2 does not
  password_hash varchar(255) not null,
  role enum('CLERK', 'MANAGER') not null,
  created_at datetime(3) not null,
  constraint users_name_key unique (name_key)
);

create table api_tokens (
  id bigint not null auto_increment primary key,
  user_id bigint not null,
  token_hash char(64) not null, -- SHA-256, hex
  created_at datetime(3) not null,
  expires_at datetime(3) not null,
  constraint api_tokens_token_hash unique (token_hash),
  constraint api_tokens_user foreign key (user_id) references users (id) on delete cascade
);

create table robots (
  id bigint not null auto_increment primary key,
  name varchar(64) not null,
  floor varchar(64) not null,
  host varchar(255) not null,
  port int not null,
  max_load double not null, -- kilograms
  parking varchar(64),
  simulated boolean not null,
  availability tinyint not null, -- 1: can be given a task
  phase tinyint not null, -- 0 parked, else the phase it is in
  last_seq bigint not null, -- of the robot link
  constraint robots_name unique (name)
);

create table tasks (
  id bigint not null auto_increment primary key,
  name varchar(100) not null,
  user_id bigint,
  user_name varchar(64) not null, -- stays when the user is deleted
  floor varchar(64) not null,
  load_kg double not null,
  load_length double, -- metres
  load_width double,
  start_x double not null,
  start_y double not null,
  start_station varchar(64),
  goal_x double not null,
  goal_y double not null,
  goal_station varchar(64),
  priority int not null,
  deadline datetime(3),
  state enum('QUEUED', 'ASSIGNED', 'TO_OBJECT', 'CARRYING', 'RETURNING', 'DONE', 'FAILED', 'CANCELLED') not null,
  created_at datetime(3) not null,
  changed_at datetime(3) not null,
  constraint tasks_user foreign key (user_id) references users (id) on delete set null,
  key tasks_state (state)
);

-- Which robots execute which task.
create table task_robots (
  task_id bigint not null,
  robot_id bigint not null,
  place int not null, -- the order in which they were chosen
  phase tinyint not null, -- the phase it is in
  arrived boolean not null, -- at the end of that phase
  released boolean not null, -- has parked, failed or taken another task
  primary key (task_id, robot_id),
  constraint task_robots_task foreign key (task_id) references tasks (id) on delete cascade,
  constraint task_robots_robot foreign key (robot_id) references robots (id) on delete cascade
);

-- The last drive that each robot was sent: stored before it is sent.
create table drives (
  robot_id bigint not null primary key,
  seq bigint not null,
  task_id bigint,
  phase tinyint not null,
  way text not null, -- start pose and segments, JSON
  created_at datetime(3) not null,
  constraint drives_robot foreign key (robot_id) references robots (id) on delete cascade
);

create table events (
  id bigint not null auto_increment primary key,
  at datetime(3) not null,
  kind varchar(32) not null,
  task_id bigint,
  robot varchar(64),
  who varchar(64) not null,
  text varchar(500) not null,
  key events_task (task_id),
  key events_at (at)
);
