-- Such a user cannot log in; what he did stays under his name.
alter table users add column disabled boolean not null default false;
