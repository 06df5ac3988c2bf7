-- Where a robot stood last, metres and radians, for who starts before it is heard again.
create table places (
  robot_id bigint not null primary key,
  drive bigint not null, -- the number of its last drive; a drive with a higher one has begun since
  x double, -- null: a person said that it is not there any more
  y double,
  theta double,
  diameter double,
  constraint places_robot foreign key (robot_id) references robots (id) on delete cascade
);

-- A path of more than a thousand segments has no room in 64 KiB.
alter table drives modify column way mediumtext not null;
