-- Where robots have seen what the map does not show: the middle of a cell, millimetres.
create table sightings (
  floor varchar(64) not null,
  x int not null,
  y int not null,
  first_at datetime(3) not null,
  last_at datetime(3) not null,
  robots text not null,
  dismissed boolean not null,
  primary key (floor, x, y)
);
