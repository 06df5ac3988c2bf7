-- Cameras, and where each answers with its picture: on a robot, or watching a floor.
create table cameras (
  id bigint not null auto_increment primary key,
  name varchar(64) not null,
  url varchar(500) not null, -- may have a user and a password in it, by which the server asks
  robot varchar(64),
  floor varchar(64),
  constraint cameras_name unique (name)
);
