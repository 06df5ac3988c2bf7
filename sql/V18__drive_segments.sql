-- The segments of each robot's last drive. In drives.way they are only where it was stored before this table was.
-- Rows apply in the order of their key, and each replaces the segments from its first one on.
create table drive_segments (
  robot_id bigint not null,
  drive bigint not null, -- drives.seq; of another drive the row says nothing
  extension int not null, -- 0: as the drive began
  first_segment int not null, -- index in the drive
  segments varbinary(3072) not null, -- of each v, w and t: m/s, rad/s and s, IEEE 754 doubles, big-endian
  primary key (robot_id, drive, extension, first_segment),
  constraint drive_segments_robot foreign key (robot_id) references robots (id) on delete cascade
);
