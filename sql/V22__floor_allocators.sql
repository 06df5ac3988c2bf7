-- Who decides on a floor which robots carry what, where a manager has chosen it.
create table floor_allocators (
  floor varchar(64) not null primary key,
  allocator varchar(16) not null
);
