-- What the server proves itself by to a robot that takes wheel commands over HTTP; null: it speaks the robot link.
alter table robots add column token varchar(128);
