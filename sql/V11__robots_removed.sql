-- A robot that was removed stays for the history of its tasks; adding one of its name brings it back.
alter table robots add column removed boolean not null default false;
