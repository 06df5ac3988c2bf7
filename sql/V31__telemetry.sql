-- By which robots publish over MQTT: the SHA-256 of a random password, hex.
create table mqtt_passwords (
  robot varchar(64) not null primary key,
  password_hash char(64) not null,
  made_at datetime(3) not null
);

-- Below or above which a reading of a robot is an alert; null: no limit there.
create table reading_limits (
  robot varchar(64) not null,
  reading varchar(32) not null,
  low double,
  high double,
  primary key (robot, reading)
);
