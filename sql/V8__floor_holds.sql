-- The robots of a floor are on hold.
create table floor_holds (
  floor varchar(64) not null primary key,
  user_name varchar(64) not null,
  at datetime(3) not null
);
