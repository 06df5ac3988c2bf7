-- What has become of the ends of drives since they began: the segments from `first` on, until the next row's.
create table drive_ends (
  robot_id bigint not null,
  first int not null,
  segments varchar(4000) not null, -- JSON, at most 40
  primary key (robot_id, first),
  constraint drive_ends_robot foreign key (robot_id) references robots (id) on delete cascade
);
