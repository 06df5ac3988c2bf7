-- What needed a person's attention, each condition once, with its end. uid names it to whoever is told, so that the
-- same one told twice is one. said as of events. owner_id: whose task it is about; no reference, for it only sorts.
create table notices (
  id bigint not null auto_increment primary key,
  uid char(36) not null,
  kind varchar(32) not null,
  subject varchar(200) not null,
  floor varchar(64),
  task_id bigint,
  robot varchar(64),
  owner_id bigint,
  text varchar(500) not null,
  said varchar(2000),
  begun_at datetime(3) not null,
  ended_at datetime(3),
  constraint notices_uid unique (uid),
  key notices_begun (begun_at),
  key notices_ended (ended_at)
);

-- Who has seen which, also when he is no user any more.
create table notice_seen (
  notice_id bigint not null,
  user_id bigint not null,
  user_name varchar(64) not null,
  seen_at datetime(3) not null,
  primary key (notice_id, user_id),
  constraint notice_seen_notice foreign key (notice_id) references notices (id) on delete cascade
);

-- How somebody wants to be told; without a row as everybody is at first. Quiet hours: minutes of the day there.
create table notice_preferences (
  user_id bigint not null primary key,
  own_tasks boolean not null,
  ends boolean not null,
  quiet_from int,
  quiet_until int,
  zone varchar(64) not null,
  language varchar(16) not null,
  constraint notice_preferences_user foreign key (user_id) references users (id) on delete cascade
);

create table notice_choices (
  user_id bigint not null,
  kind varchar(32) not null,
  channel varchar(16) not null,
  primary key (user_id, kind, channel),
  constraint notice_choices_user foreign key (user_id) references users (id) on delete cascade
);
