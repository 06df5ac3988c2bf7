-- Whether what keeps a task's robot from going on is that its arm did not do what it should.
alter table tasks add column trouble_arm boolean not null default false;
